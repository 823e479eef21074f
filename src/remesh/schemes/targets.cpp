// SPDX-License-Identifier: MIT
#include "remesh/schemes/targets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/legible.h"
#include "base/room.h"
#include "geometry/triangle.h"
#include "mesh/components.h"
#include "mesh/joints.h"
#include "mesh/topology.h"
#include "remesh/schemes/edge_limits.h"

namespace remesher {

namespace {

// A closed component needs a tetrahedron, an open one a triangle; a target below 4 is never meant.
constexpr std::size_t kFewestVertices = 4;

// Measured peak memory of a run, for each vertex of the result and of the input. Some meshes need
// less; no mesh fits beyond the addresses there are, or the numbers for six halfedges per vertex.
constexpr double kBytesPerVertex = 600, kBytesPerInputVertex = 1200;

// Digits of numbers in messages.
constexpr int kMessageDigits = 6;

void require(bool holds, const std::string& message, const std::string& hint) {
  if (!holds) throw Error(ErrorCode::InvalidOption, message, hint);
}

void checkDensity(const std::vector<float>& density, std::size_t inputVertices) {
  if (density.empty()) return;
  require(density.size() == inputVertices,
          "density has " + std::to_string(density.size()) + " values for " +
              std::to_string(inputVertices) + " vertices.",
          "Give one value for each input vertex.");
  for (std::size_t i = 0; i < density.size(); ++i)
    require(std::isfinite(density[i]) && density[i] >= 0,
            "density[" + std::to_string(i) + "] is " + inDigits(density[i], kMessageDigits) + ".",
            "Densities are finite numbers of at least 0.");
  require(*std::max_element(density.begin(), density.end()) > 0, "density is 0 everywhere.",
          "Give at least one value above 0; only their ratios count.");
}

// The message names no number but one that is enough.
std::string tooFew(ErrorCode code, std::size_t target, std::size_t needed) {
  const std::string beginning = "The target of " + std::to_string(target) + " vertices is ";
  if (code != ErrorCode::TargetBelowCurves) return beginning + "too small for this surface.";
  return beginning + "below the " + std::to_string(needed) +
         " that the corners of feature curves and kept boundaries need.";
}

}  // namespace

// The fewest vertices of a surface with handles depend on how it lies in space: a torus is rolled
// up of a sheet of four by four, twelve more than a ball needs, and each handle needs twelve more.
Fewest fewestVertices(const HalfedgeMesh& mesh) {
  DisjointSets components = componentsOfVertices(mesh);
  Fewest fewest;
  VertexData<char> isOpen(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    if (mesh.isAlive(Vertex(i)) && mesh.isBoundary(Vertex(i)))
      isOpen[Vertex(components.find(i))] = 1;
  // 0 if each component is a ball or a disc.
  long missing = -eulerCharacteristic(mesh);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    if (!mesh.isAlive(Vertex(i)) || components.find(i) != i) continue;
    fewest.needed += isOpen[Vertex(i)] ? 3 : 4;
    missing += isOpen[Vertex(i)] ? 1 : 2;
  }
  fewest.needed = std::max(fewest.needed, kFewestVertices);
  fewest.enough = fewest.needed + 6 * std::size_t(std::max(missing, 0L));
  return fewest;
}

TooFewVertices::TooFewVertices(ErrorCode errorCode, const VertexNeeds& needs)
    : Error(errorCode, tooFew(errorCode, needs.target, needs.needed),
            "Ask for " + std::to_string(needs.enough) + " vertices or more" +
                (errorCode == ErrorCode::TargetBelowCurves
                     ? ", or for fewer features (--feature-angle, --boundary)."
                     : ".")),
      VertexNeeds(needs) {}

void checkOptions(const PartOptions& options, std::size_t inputVertices) {
  require(options.gradation > 1,
          "gradation is " + inDigits(options.gradation, kMessageDigits) + ", not above 1.",
          "Sizes need room to change: 1.5 is usual.");
  const double adaptivity = options.adaptivity.value_or(0);
  require(adaptivity >= 0 && adaptivity <= 1,
          "adaptivity is " + inDigits(adaptivity, kMessageDigits) + ", not between 0 and 1.",
          "0 gives triangles of one size, 1 follows curvature fully.");
  require(!options.weld || *options.weld > 0, "weld is not above 0.",
          "It is in percent of the diagonal; leave it out to join nothing more.");
  require(!options.maxError || *options.maxError > 0, "maxError is not above 0.",
          "It is a percentage of the bounding box diagonal.");
  require(!options.edgeLength || *options.edgeLength > 0, "edgeLength is not above 0.",
          "It is a length in the units of the model.");
  require(!options.ratio || *options.ratio > 0, "ratio is not above 0.",
          "0.5 halves the number of vertices.");
  checkDensity(options.density, inputVertices);
}

double surfaceArea(const BuiltMesh& built) {
  double total = 0;
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    total += area(built.positions[a], built.positions[b], built.positions[c]);
  }
  if (total > 0) return total;
  throw Error(ErrorCode::NoTriangles, "No triangle has an area: all are degenerate.",
              "Was the mesh scaled to zero in one direction, or rounded too coarsely?");
}

void requireRoom(const ModelSize& model, double target, double addresses) {
  const double room = addresses / kBytesPerInputVertex;  // vertices of a model
  if (model.vertices + kFewestVertices > room)
    throw Error(ErrorCode::OutOfMemory,
                "This model has " + inMillions(model.triangles) +
                    " triangles; this build has memory for about " +
                    inMillions(room / model.vertices * model.triangles) + ".",
                "Give it in parts, or remesh it with the native library.");
  const double left = addresses - kBytesPerInputVertex * model.vertices;
  const double most = std::min(left / kBytesPerVertex, double(kNone) / 6);
  if (target <= most) return;
  throw Error(ErrorCode::OutOfMemory,
              "The target is " + inMillions(target) + " vertices; beside this model of " +
                  inMillions(model.vertices) + " this build has memory for about " +
                  inMillions(most) + ".",
              "Ask for fewer, or give the model in parts.");
}

std::size_t targetVertices(const BuiltMesh& built, const PartOptions& options) {
  const double own = double(countPlaces(built));
  double target = own;
  if (options.vertices) target = double(*options.vertices);
  if (options.ratio) target = std::round(*options.ratio * own);
  if (options.edgeLength)
    target = std::round(verticesForEdgeLength(surfaceArea(built), *options.edgeLength));
  if (leadsByEdges(options)) target = std::round(numberByEdges(options, surfaceArea(built), own));
  requireRoom({double(built.mesh.vertexCount()), double(built.mesh.faceCount())}, target,
              kAddresses);
  const Fewest fewest = fewestVertices(built.mesh);
  if (target < double(fewest.needed) && options.tooFew == TooFew::Raise) return fewest.needed;
  if (target < double(fewest.needed))
    throw TooFewVertices(ErrorCode::TargetTooSmall,
                         {std::size_t(target), fewest.needed, fewest.enough});
  return std::size_t(target);
}

std::size_t countCorners(const FeatureCurves& curves, const HalfedgeMesh& mesh) {
  std::size_t corners = 0;
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) corners += curves.isCorner(Vertex(i)) ? 1 : 0;
  return corners;
}

void checkCurves(std::size_t corners, std::size_t vertices) {
  if (corners > vertices)
    throw TooFewVertices(ErrorCode::TargetBelowCurves, {vertices, corners, corners});
}

SizeRules sizeRules(const PartOptions& options, double vertices, std::span<const float> density) {
  constexpr double kMild = 0.5;
  const double byScheme = options.scheme == Scheme::Best ? kMild : 0.0;
  SizeRules rules{vertices, options.adaptivity.value_or(byScheme), options.gradation, density};
  const SizeBounds bounds = sizeBounds(options);
  rules.shortest = bounds.shortest;
  rules.longest = bounds.longest;
  return rules;
}

std::vector<float> densityOf(const BuiltMesh& built, const PartOptions& options) {
  std::vector<float> result;
  if (options.density.empty()) return result;
  for (const Index source : built.sources.values()) result.push_back(options.density[source]);
  return result;
}

}  // namespace remesher
