// SPDX-License-Identifier: MIT
#include "mesh/mesh_builder.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/edge_groups.h"
#include "mesh/manifold_cut.h"
#include "mesh/orientation.h"
#include "mesh/space_order.h"

namespace remesher {

namespace {

// Meshes with more places than the caches hold are put in spatial order, whatever order the input
// has: then a look around a vertex waits less for memory.
constexpr std::size_t kManyPlaces = 100'000;

// The triangles still kept: corners by place, wedges by input vertex.
struct Soup {
  std::vector<Index> corners;
  std::vector<Index> wedges;
  std::vector<Index> triangles;
  std::vector<Index> sources;  // per place: the first vertex there

  void resize(std::size_t count) {
    corners.resize(3 * count);
    wedges.resize(3 * count);
    triangles.resize(count);
  }
};

void warn(std::vector<Warning>& warnings, const char* code, const char* message,
          std::size_t count) {
  if (count > 0) warnings.push_back({code, message, count});
}

// The first vertex at each place, in the order of the places.
std::vector<Index> sourcesOf(const TriangleMesh& input, const std::vector<Index>& first) {
  std::vector<Index> sources;
  for (Index v = 0; v < first.size(); ++v)
    if (first[v] == v) sources.push_back(v);
  if (sources.size() < kManyPlaces) return sources;
  std::vector<std::array<float, 3>> points(sources.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      points[i][axis] = float(input.positions[sources[i]][axis]);
  std::vector<Index> order = orderInSpace(points);
  for (Index& place : order) place = sources[place];
  return order;
}

// Per input vertex its place.
std::vector<Index> placesOf(const std::vector<Index>& first, const std::vector<Index>& sources) {
  std::vector<Index> places(first.size());
  for (Index i = 0; i < sources.size(); ++i) places[sources[i]] = i;
  for (Index v = 0; v < first.size(); ++v) places[v] = places[first[v]];
  return places;
}

// The triangles of the input in their order, or, if the places are reordered, by their first place.
std::vector<Index> orderOfTriangles(const TriangleMesh& input, const std::vector<Index>& places,
                                    std::size_t placeCount) {
  std::vector<Index> order(input.triangleCount());
  std::iota(order.begin(), order.end(), Index{0});
  if (placeCount < kManyPlaces) return order;
  std::vector<Index> begins(placeCount + 1, 0);
  const auto firstPlace = [&](std::size_t f) {
    const Index* wedge = &input.indices[3 * f];
    return std::min({places[wedge[0]], places[wedge[1]], places[wedge[2]]});
  };
  for (std::size_t f = 0; f < order.size(); ++f) ++begins[firstPlace(f) + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  for (Index f = 0; f < order.size(); ++f) order[begins[firstPlace(f)]++] = f;
  return order;
}

Soup gather(const TriangleMesh& input, const std::vector<Index>& first) {
  Soup soup;
  soup.sources = sourcesOf(input, first);
  const std::vector<Index> place = placesOf(first, soup.sources);
  soup.resize(input.triangleCount());
  Index kept = 0;
  for (const Index f : orderOfTriangles(input, place, soup.sources.size())) {
    const Index* wedge = &input.indices[3 * std::size_t{f}];
    const Index a = place[wedge[0]], b = place[wedge[1]], c = place[wedge[2]];
    if (a == b || b == c || c == a) continue;
    Index* const corners = &soup.corners[3 * std::size_t{kept}];
    corners[0] = a, corners[1] = b, corners[2] = c;
    for (Index i = 0; i < 3; ++i) soup.wedges[3 * std::size_t{kept} + i] = wedge[i];
    soup.triangles[kept++] = f;
  }
  soup.resize(kept);
  if (soup.triangles.empty())
    throw Error(
        ErrorCode::NoTriangles,
        "No triangle of " + std::to_string(input.triangleCount()) + " has three distinct corners.",
        "The mesh may have been scaled to zero or rounded too coarsely.");
  return soup;
}

// The twins of the given triangles, renumbered for the triangles in `soup`.
std::vector<Index> twinsOf(const Soup& soup, std::size_t given, std::vector<Index> twins) {
  if (twins.empty() || soup.sources.size() < kManyPlaces) return twins;
  std::vector<Index> numbers(given, kNone);  // of each here
  for (Index f = 0; f < soup.triangles.size(); ++f) numbers[soup.triangles[f]] = f;
  std::erase(numbers, kNone);
  const auto here = [&](Index h) { return h == kNone ? kNone : 3 * numbers[h / 3] + h % 3; };
  std::vector<Index> result(twins.size());
  for (Index h = 0; h < twins.size(); ++h) result[here(h)] = here(twins[h]);
  return result;
}

// Returns the number of removed triangles.
std::size_t remove(Soup& soup, std::span<const char> unwanted) {
  Index kept = 0;
  for (Index f = 0; f < unwanted.size(); ++f) {
    if (unwanted[f]) continue;
    for (Index i = 0; i < 3; ++i) {
      soup.corners[3 * kept + i] = soup.corners[3 * f + i];
      soup.wedges[3 * kept + i] = soup.wedges[3 * f + i];
    }
    soup.triangles[kept++] = soup.triangles[f];
  }
  soup.resize(kept);
  return unwanted.size() - kept;
}

// Removes triangles with the same corners in the same order as an earlier one. All copies of a
// triangle meet at each of its edges, so looking at the edges finds them.
std::size_t removeDuplicates(Soup& soup, const EdgeGroups& edges) {
  std::vector<char> duplicate(soup.triangles.size(), 0);
  std::vector<std::pair<Index, Index>> sorted;  // the third corner, and the halfedge
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() < 2) continue;
    const Index end = soup.corners[edges[e][0]];
    for (const bool isFromEnd : {true, false}) {
      sorted.clear();
      for (const Index h : edges[e])
        if ((soup.corners[h] == end) == isFromEnd)
          sorted.emplace_back(soup.corners[prevCorner(h)], h);
      std::sort(sorted.data(), sorted.data() + sorted.size());
      for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i - 1].first == sorted[i].first) duplicate[sorted[i].second / 3] = 1;
    }
  }
  return remove(soup, duplicate);
}

void turnOver(Soup& soup, std::span<const char> turn) {
  for (Index f = 0; f < turn.size(); ++f) {
    if (!turn[f]) continue;
    std::swap(soup.corners[3 * f + 1], soup.corners[3 * f + 2]);
    std::swap(soup.wedges[3 * f + 1], soup.wedges[3 * f + 2]);
  }
}

// Removes pairs of triangles that enclose nothing and cannot be refined: two triangles back to back
// whose three vertices, after the cut, belong to no other triangle.
std::size_t removeBackToBack(Soup& soup, const ManifoldCut& cut) {
  std::vector<Index> corners(cut.origins.size(), 0);
  for (const Index v : cut.corners) ++corners[v];
  std::vector<Index> firstFace(cut.origins.size(), kNone);
  std::vector<char> unwanted(soup.triangles.size(), 0);
  for (Index f = 0; f < unwanted.size(); ++f) {
    const Index a = cut.corners[3 * f], b = cut.corners[3 * f + 1], c = cut.corners[3 * f + 2];
    if (corners[a] != 2 || corners[b] != 2 || corners[c] != 2) continue;
    const Index g = firstFace[a];
    if (g != kNone && g == firstFace[b] && g == firstFace[c]) unwanted[f] = unwanted[g] = 1;
    firstFace[a] = firstFace[b] = firstFace[c] = f;
  }
  const std::size_t removed = remove(soup, unwanted);
  if (soup.triangles.empty())
    throw Error(ErrorCode::NoTriangles, "All triangles lie back to back with another one.",
                "A sheet needs one side only.");
  return removed;
}

BuiltMesh assemble(const TriangleMesh& input, Soup&& soup, ManifoldCut&& cut) {
  BuiltMesh built;
  built.mesh = cut.twins.empty() ? HalfedgeMesh(cut.origins.size(), cut.corners)
                                 : HalfedgeMesh(cut.origins.size(), cut.corners, cut.twins);
  built.positions.reserve(cut.origins.size());
  for (Index& source : cut.origins) {
    source = soup.sources[source];
    built.positions.values().push_back(input.positions[source]);
  }
  built.sources.values() = std::move(cut.origins);
  built.wedges.values() = std::move(soup.wedges);
  built.triangles.values() = std::move(soup.triangles);
  return built;
}

// Removes copies of triangles and makes neighbours face the same side.
void makeConsistent(const TriangleMesh& input, Soup& soup, std::vector<Warning>& warnings) {
  const std::size_t placeCount = soup.sources.size();
  EdgeGroups edges(placeCount, soup.corners);
  const std::size_t duplicates = removeDuplicates(soup, edges);
  warn(warnings, "DUPLICATE_TRIANGLES_REMOVED",
       "Triangles that repeat another one exactly were removed.", duplicates);
  if (duplicates > 0) edges = EdgeGroups(placeCount, soup.corners);

  const Orientation orientation = orient(soup.corners, edges);
  warn(warnings, "INCONSISTENT_ORIENTATION_FIXED",
       "Triangles were turned over to face the same side as most of their neighbours.",
       orientation.turned);
  warn(warnings, "NON_ORIENTABLE_CUT",
       "The surface has only one side: at some edges its triangles face opposite sides.",
       orientation.conflicts);
  if (const Index h = orientation.conflict; h != kNone)
    warnings.back().at =
        (input.positions[soup.wedges[h]] + input.positions[soup.wedges[nextCorner(h)]]) / 2;
  turnOver(soup, orientation.turn);
}

ManifoldCut cutApart(const TriangleMesh& input, const Soup& soup, std::vector<Index> twins) {
  const std::size_t placeCount = soup.sources.size();
  if (!twins.empty()) return cutFans(soup.corners, placeCount, std::move(twins));
  std::vector<Vec3> positions;
  positions.reserve(placeCount);
  for (const Index source : soup.sources) positions.push_back(input.positions[source]);
  return cutToManifold(positions, soup.corners, EdgeGroups(placeCount, soup.corners));
}

}  // namespace

BuiltMesh buildMesh(const TriangleMesh& input, Welding welding) {
  std::vector<Warning> warnings;

  Soup soup = gather(input, welding.first);
  const std::size_t placeCount = soup.sources.size();
  const std::size_t lines = input.triangleCount() - soup.triangles.size();
  warn(warnings, "DEGENERATE_TRIANGLES_REMOVED",
       "Triangles without three distinct corners were removed.", lines);

  std::vector<Index> twins = twinsOf(soup, input.triangleCount(), std::move(welding.twins));
  if (twins.empty()) {
    makeConsistent(input, soup, warnings);
    twins = plainTwins(placeCount, soup.corners);
  }
  ManifoldCut cut = cutApart(input, soup, std::move(twins));
  std::size_t backToBack = 0;
  // Each removal changes where the surface is cut, which may free further pairs.
  while (const std::size_t removed = removeBackToBack(soup, cut)) {
    backToBack += removed;
    cut = cutApart(input, soup, plainTwins(placeCount, soup.corners));
  }
  warn(warnings, "BACK_TO_BACK_TRIANGLES_REMOVED",
       "Triangles back to back, which enclose nothing, were removed.", backToBack);
  warn(warnings, "NON_MANIFOLD_EDGES_SPLIT",
       "Edges shared by more than two triangles were cut apart.", cut.edges);
  warn(warnings, "NON_MANIFOLD_VERTICES_SPLIT",
       "Vertices where the surface touches itself in a point were separated.", cut.vertices);

  BuiltMesh built = assemble(input, std::move(soup), std::move(cut));
  built.isInSpaceOrder = placeCount >= kManyPlaces;
  built.lines = lines;
  built.warnings = std::move(warnings);
  return built;
}

}  // namespace remesher
