// SPDX-License-Identifier: MIT
#include "repair/fineness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/legible.h"
#include "base/room.h"

namespace remesher {

namespace {

// Spacings of the lattice, as shares of the diagonal.
constexpr double kFinest = 1.0 / 400, kCoarsest = 1.0 / 128, kUsual = 1.0 / 200;

// Peak memory for each triangle of the input, for each point of the lattice, for each crossing of
// the surface with its lines, and besides; or, when the lattice is gone, for each crossing with the
// triangles that are made there. Fitted to the peaks of 33 repairs, most of which held 0.6 to 1.2
// times what is said, two of many thin plates and one of 2000 loose triangles up to twice.
constexpr double kBytesPerTriangle = kRepairBytesPerTriangle;
constexpr double kBytesPerPoint = 25, kBytesPerCrossing = 100;
constexpr double kBytesPerMade = 400, kBytesBesides = 2.5e7;
// The memory that a lattice is made coarser for, and the points up to which thin walls make it
// finer: some 3 s.
constexpr double kMostBytes = 5e8, kMostPoints = 8e6;
// Few triangles do not get a surface of very many: the crossings and the points that each input
// has, and those for each triangle.
constexpr double kLeastCrossings = 2e4, kCrossingsPerTriangle = 100;
constexpr double kLeastPoints = 1e6, kPointsPerTriangle = 5e3;
// Times of one core, within a factor of two for most of the same shapes.
constexpr double kSecondsPerTriangle = 2e-5, kSecondsPerPoint = 1.2e-6;

constexpr double kUsualGap = 2;  // percent of the diagonal

struct Grid {
  double spacing, spare;  // spare: lengths beyond the mesh on all sides
};

double pointsOf(const Extent& extent, const Grid& grid) {
  constexpr double kBeside = 5;  // the lattice's own spare cells, and the last point
  double points = 1;
  for (const double side : extent.sides) points *= (side + 2 * grid.spare) / grid.spacing + kBeside;
  return points;
}

double crossingsOf(const Extent& extent, double spacing) {
  return spacing > 0 ? extent.shadows / (spacing * spacing) : 0;
}

double bytesOf(const Extent& extent, const Grid& grid) {
  const double crossings = crossingsOf(extent, grid.spacing);
  const double first = kBytesPerCrossing * crossings + kBytesPerPoint * pointsOf(extent, grid);
  return kBytesBesides + kBytesPerTriangle * double(extent.triangles) +
         std::max(first, kBytesPerMade * crossings);
}

double gapOf(const PartOptions& options, double diagonal) {
  return usualGap(options) / 100 * diagonal;
}

Grid gridFor(const Extent& extent, const PartOptions& options, InsideBy by) {
  constexpr double kStep = 1.05;
  const double diagonal = extent.diagonal();
  const double finest = kFinest * diagonal, coarsest = kCoarsest * diagonal;
  const double spare = by == InsideBy::Reach ? gapOf(options, diagonal) / 2 : 0;
  Grid grid = {
      std::clamp(options.spacing.value_or(wishedSpacing(extent, options)), finest, coarsest),
      spare};
  const double most = kLeastCrossings + kCrossingsPerTriangle * double(extent.triangles);
  while (grid.spacing < coarsest &&
         (bytesOf(extent, grid) > kMostBytes || crossingsOf(extent, grid.spacing) > most))
    grid.spacing = std::min(coarsest, kStep * grid.spacing);
  return grid;
}

// Remeshing to a number or an edge length replaces the triangles anyway.
Cleaning cleaningFor(const PartOptions& options) {
  const bool isRemeshed =
      options.vertices || options.ratio || options.edgeLength || leadsByEdges(options);
  return isRemeshed ? Cleaning::None : Cleaning::Thorough;
}

std::string bytesInWords(double bytes) {
  constexpr double kMega = 1e6, kGiga = 1e9;
  constexpr int kDigits = 2;
  return bytes < kGiga ? inDigits(bytes / kMega, kDigits) + " MB"
                       : inDigits(bytes / kGiga, kDigits) + " GB";
}

}  // namespace

double usualGap(const PartOptions& options) { return options.gap.value_or(kUsualGap); }

double wishedSpacing(const Extent& extent, const PartOptions& options) {
  double edge = 2 * kUsual * extent.diagonal();
  if (options.vertices)
    edge = std::sqrt(2 / std::sqrt(3.0) * extent.area / double(*options.vertices));
  if (options.edgeLength) edge = *options.edgeLength;
  if (options.maxEdge && leadsByEdges(options)) edge = *options.maxEdge / kLongestOfSize;
  return edge / 2;
}

SolidRule ruleFor(const TriangleMesh& input, const PartOptions& options, InsideBy by) {
  const Extent extent = extentOf(input);
  const Grid grid = gridFor(extent, options, by);
  SolidRule rule{grid.spacing, by};
  if (by == InsideBy::Reach) rule.gap = gapOf(options, extent.diagonal());
  rule.cleaning = cleaningFor(options);
  rule.sheets = options.sheets;
  rule.keepsCavities = options.cavities;
  const double left = std::max(0.0, kMostBytes - bytesOf(extent, grid)) / kBytesPerPoint;
  const double most =
      std::min(kMostPoints, kLeastPoints + kPointsPerTriangle * double(extent.triangles));
  rule.mostPoints = std::size_t(std::min(most, pointsOf(extent, grid) + left));
  return rule;
}

RepairNeeds needsOf(const TriangleMesh& input, const PartOptions& options) {
  const Extent extent = extentOf(input);
  RepairNeeds needs{kBytesPerTriangle * double(extent.triangles),
                    kSecondsPerTriangle * double(extent.triangles)};
  if (options.repair == Repair::Holes) return needs;
  const InsideBy by = options.repair == Repair::Solid ? InsideBy::Enclosure : InsideBy::Reach;
  const Grid grid = gridFor(extent, options, by);
  needs.bytes = bytesOf(extent, grid);
  needs.seconds += kSecondsPerPoint * pointsOf(extent, grid);
  return needs;
}

void requireMemory(const TriangleMesh& input, const PartOptions& options, double most) {
  const double bytes = needsOf(input, options).bytes;
  if (!(bytes > most)) return;
  throw Error(ErrorCode::OutOfMemory,
              "Repair takes about " + bytesInWords(bytes) +
                  " of memory for this mesh, more than the " + bytesInWords(most) + " there are.",
              "Give the model in parts, or with fewer triangles.");
}

void requireMemory(const TriangleMesh& input, const PartOptions& options) {
  requireMemory(input, options, double(std::numeric_limits<std::size_t>::max()));
}

}  // namespace remesher
