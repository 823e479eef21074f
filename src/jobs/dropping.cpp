// SPDX-License-Identifier: MIT
#include "jobs/dropping.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "geometry/triangle.h"
#include "jobs/checks/result_check.h"
#include "jobs/parts/part_frames.h"
#include "jobs/parts/part_places.h"
#include "mesh/used_vertices.h"
#include "mesh/welding.h"
#include "repair/loose_pieces.h"
#include "repair/sight.h"

namespace remesher {

namespace {

struct WorldTriangle {
  std::size_t part;
  Index triangle;  // of the part
};

// Parts at places in the world, as one bag of triangles.
struct World {
  std::vector<Vec3> positions;
  std::vector<Index> corners;
  std::vector<WorldTriangle> triangles;
  std::vector<char> isClear;  // per triangle: of a material that is seen through

  void add(const io::Part& part, std::size_t number, const Transform& place) {
    const Index first = Index(positions.size());
    for (const Vec3& p : part.mesh.positions) positions.emplace_back(place * p);
    for (Index t = 0; t < part.mesh.triangleCount(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        corners.push_back(first + part.mesh.indices[3 * std::size_t{t} + k]);
      triangles.push_back({number, t});
      const std::size_t group = part.mesh.groups.empty() ? 0 : part.mesh.groups[t];
      isClear.push_back(char(group < part.groups.size() && !part.groups[group].look.isOpaque));
    }
  }

  double areaOf(std::size_t t) const {
    return area(positions[corners[3 * t]], positions[corners[3 * t + 1]],
                positions[corners[3 * t + 2]]);
  }
};

bool isCoarser(const io::Part& part) { return !part.finer.empty(); }

// Whether the part bends or changes its shape, so that what is hidden now may show later.
bool moves(const io::Part& part) {
  return std::any_of(part.mesh.attributes.begin(), part.mesh.attributes.end(),
                     [](const Attribute& attribute) {
                       return attribute.semantic.starts_with("JOINTS_") ||
                              attribute.semantic.starts_with("TARGET_");
                     });
}

using Marks = std::vector<std::vector<char>>;  // per part and triangle

Marks marksFor(const std::vector<io::Part>& parts, char mark) {
  Marks marks;
  for (const io::Part& part : parts) marks.emplace_back(part.mesh.triangleCount(), mark);
  return marks;
}

void keepUnmarked(TriangleMesh& mesh, const std::vector<char>& isGone) {
  const std::vector<Index> indices = std::exchange(mesh.indices, {}),
                           groups = std::exchange(mesh.groups, {});
  for (std::size_t t = 0; t < isGone.size(); ++t) {
    if (isGone[t]) continue;
    mesh.indices.insert(mesh.indices.end(), indices.begin() + std::ptrdiff_t(3 * t),
                        indices.begin() + std::ptrdiff_t(3 * t + 3));
    if (!groups.empty()) mesh.groups.push_back(groups[t]);
  }
  keepUsedVertices(mesh);
}

// Both halves of a quad go, or none.
void keepHalvesTogether(const std::vector<io::Part>& parts, Marks& isGone) {
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t t = 0; parts[p].mesh.isQuads && t + 1 < isGone[p].size(); t += 2)
      isGone[p][t] = isGone[p][t + 1] = char(isGone[p][t] && isGone[p][t + 1]);
}

void keepUnmarkedIn(std::vector<io::Part>& parts, const Marks& isGone) {
  bool isAnyLeft = false;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::vector<char>& own = isGone[p];
    if (std::find(own.begin(), own.end(), 1) != own.end()) keepUnmarked(parts[p].mesh, own);
    isAnyLeft = isAnyLeft || !parts[p].mesh.indices.empty();
  }
  if (!isAnyLeft)
    throw Error(ErrorCode::NoTriangles, "Nothing would be left: every piece was to be left out.",
                "Ask for less with --drop-below, or leave it out.");
}

std::vector<io::Part> applied(const PartFrames& scale, const std::vector<io::Part>& parts) {
  return scale.isNeeded() ? scale.applied(parts) : parts;
}

// "12.5 across near (1, 2, 3)", of a few.
std::string placesInWords(const std::vector<SizedPlace>& places,
                          const std::vector<io::Part>& parts) {
  constexpr std::size_t kNamed = 3;
  constexpr int kDigitsAcross = 3;
  std::string words;
  for (std::size_t i = 0; i < std::min(kNamed, places.size()); ++i)
    words += (i > 0 ? ", " : "") + inDigits(places[i].across, kDigitsAcross) + " near (" +
             placeInWords(places[i].at, parts) + ")";
  return words;
}

SizedPlace placeOf(const LoosePiece& piece, const PartFrames& scale) {
  const Vec3 low = scale.unscaled(piece.box.low), high = scale.unscaled(piece.box.high);
  return {(low + high) / 2, (high - low).norm()};
}

void sortByWidth(std::vector<SizedPlace>& places) {
  std::stable_sort(places.begin(), places.end(),
                   [](const SizedPlace& a, const SizedPlace& b) { return a.across > b.across; });
  if (places.size() > kMostSizedPlaces) places.resize(kMostSizedPlaces);
}

// Per part the components of its triangles by shared places, and whether each is closed.
struct Components {
  explicit Components(const TriangleMesh& mesh) : pieces(mesh.positions, mesh.indices) {
    isClosed.assign(pieces.all().size(), 1);
    const Welding welding(mesh);
    const std::vector<Index> given = welding.triangles(mesh);
    welding.forEachEdge([&](std::span<const Index> edge) {
      if (edge.size() == 1) isClosed[pieces.ofTriangles()[given[edge[0] / 3]]] = 0;
    });
  }

  LoosePieces pieces;
  std::vector<char> isClosed;
};

// Of closed components only those go of which nothing is seen.
void keepClosedWhole(const TriangleMesh& mesh, std::vector<char>& isGone) {
  if (mesh.indices.empty()) return;
  const Components components(mesh);
  std::vector<char> isKept(components.isClosed.size(), 0);
  const std::vector<Index>& of = components.pieces.ofTriangles();
  for (std::size_t t = 0; t < of.size(); ++t)
    if (!isGone[t]) isKept[of[t]] = components.isClosed[of[t]];
  for (std::size_t t = 0; t < of.size(); ++t)
    if (isKept[of[t]]) isGone[t] = 0;
}

}  // namespace

Dropped dropSmallPieces(std::vector<io::Part>& parts, const PartOptions& options) {
  Dropped dropped;
  const PartFrames scale(parts);
  const std::vector<io::Part> scaled = applied(scale, parts);
  const std::vector<PartPlace> places = placesOf(scaled);
  World world;
  for (std::size_t p = 0; p < scaled.size(); ++p)
    if (!isCoarser(scaled[p])) world.add(scaled[p], p, places[p].toWorld);
  const LoosePieces pieces(world.positions, world.corners);
  const std::vector<char> isSmall =
      options.dropFloaters ? pieces.floaters() : pieces.smallerThan(*options.dropBelow / 100);
  Marks isGone = marksFor(parts, 0);
  double all = 0, lost = 0;
  for (std::size_t t = 0; t < world.triangles.size(); ++t) {
    const auto& [part, triangle] = world.triangles[t];
    const double own = world.areaOf(t);
    all += own;
    isGone[part][triangle] = isSmall[pieces.ofTriangles()[t]];
    if (isGone[part][triangle]) lost += own;
  }
  for (std::size_t i = 0; i < pieces.all().size(); ++i)
    if (isSmall[i]) dropped.report.piecesAt.push_back(placeOf(pieces.all()[i], scale));
  dropped.report.pieces = dropped.report.piecesAt.size();
  dropped.report.lost = all > 0 ? 100 * lost / all : 0;
  if (dropped.report.pieces == 0) return dropped;
  sortByWidth(dropped.report.piecesAt);
  keepUnmarkedIn(parts, isGone);
  dropped.warnings.push_back({"PIECES_DROPPED",
                              "Small pieces were left out, as asked. The largest are, across: " +
                                  placesInWords(dropped.report.piecesAt, parts) + ".",
                              dropped.report.pieces, dropped.report.piecesAt.front().at});
  return dropped;
}

Dropped dropHiddenTriangles(std::vector<io::Part>& parts, Hidden hidden) {
  Dropped dropped;
  const PartFrames scale(parts);
  const std::vector<io::Part> scaled = applied(scale, parts);
  World world;
  Marks isGone = marksFor(parts, 1);
  for (std::size_t p = 0; p < scaled.size(); ++p) {
    const std::vector<Transform>& own = scaled[p].instances;
    const std::size_t shown = own.size() - std::min(own.size(), scaled[p].hidden);
    if (isCoarser(scaled[p]) || moves(scaled[p]) || (shown == 0 && !own.empty()))
      isGone[p].assign(isGone[p].size(), 0);
    if (isCoarser(scaled[p])) continue;
    for (std::size_t i = 0; i < shown; ++i) world.add(scaled[p], p, own[i]);
    if (own.empty()) world.add(scaled[p], p, Transform::Identity());
  }
  const std::vector<char> isSeen = seenFromOutside({world.positions, world.corners, world.isClear});
  for (std::size_t t = 0; t < isSeen.size(); ++t)
    if (isSeen[t]) isGone[world.triangles[t].part][world.triangles[t].triangle] = 0;
  for (std::size_t p = 0; p < parts.size() && hidden == Hidden::Pieces; ++p)
    keepClosedWhole(parts[p].mesh, isGone[p]);
  keepHalvesTogether(parts, isGone);
  double all = 0, lost = 0;
  for (std::size_t t = 0; t < world.triangles.size(); ++t) {
    const auto& [part, triangle] = world.triangles[t];
    all += world.areaOf(t);
    if (isGone[part][triangle]) lost += world.areaOf(t);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t t = 0; t < isGone[p].size(); ++t) {
      if (!isGone[p][t]) continue;
      ++dropped.report.hidden;
      if (dropped.report.hiddenAt.size() < kMostSizedPlaces)
        dropped.report.hiddenAt.push_back(
            scale.inWorld(scaled[p], scaled[p].mesh.positions[scaled[p].mesh.indices[3 * t]]));
    }
  dropped.report.lost = all > 0 ? 100 * lost / all : 0;
  if (dropped.report.hidden == 0) return dropped;
  const std::string first = placeInWords(dropped.report.hiddenAt.front(), parts);
  keepUnmarkedIn(parts, isGone);
  dropped.warnings.push_back({"HIDDEN_DROPPED",
                              "Triangles that nobody sees from outside were left out, as asked. "
                              "The first was near (" +
                                  first + ").",
                              dropped.report.hidden, dropped.report.hiddenAt.front()});
  return dropped;
}

}  // namespace remesher
