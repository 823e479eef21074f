// SPDX-License-Identifier: MIT
#include "remesh/schemes/part_by_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "geometry/extent.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "mesh/joints.h"
#include "mesh/submesh.h"
#include "remesh/operators/projection.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/schemes/guided.h"
#include "remesh/schemes/number_note.h"
#include "remesh/schemes/plan.h"
#include "remesh/schemes/targets.h"
#include "remesh/symmetry/mirror_planes.h"

namespace remesher {

namespace {

// Of the input's triangles the number of their connected part; kNone for those that are in none.
struct PartNumbers {
  std::vector<Index> ofTriangle;
  Index count = 0;
};

PartNumbers numbersOf(const TriangleMesh& input, const BuiltMesh& built) {
  const FaceData<Index> ofFace = partNumbers(built.mesh);
  PartNumbers numbers{std::vector<Index>(input.triangleCount(), kNone)};
  for (Index f = 0; f < ofFace.size(); ++f) {
    numbers.ofTriangle[built.triangles[Face(f)]] = ofFace[Face(f)];
    numbers.count = std::max(numbers.count, ofFace[Face(f)] + 1);
  }
  return numbers;
}

// How much of the vertices a triangle is due.
double weightOf(const TriangleMesh& mesh, Index t, const std::vector<float>& density) {
  const auto [a, b, c] = cornersOf(mesh, t);
  double mean = 1;
  if (!density.empty()) {
    mean = 0;
    for (std::size_t k = 0; k < 3; ++k) mean += density[mesh.indices[std::size_t{3} * t + k]] / 3;
  }
  return mean * area(a, b, c);
}

// Unites parts that meet along an edge, where the builder cut the surface apart.
void uniteJoined(DisjointSets& sets, const BuiltMesh& built, const PartNumbers& numbers) {
  using Ends = std::array<std::array<double, 3>, 2>;
  std::map<Ends, Index> partAt;
  const auto coordinatesOf = [&](Vertex v) {
    const Vec3& p = built.positions[v];
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  for (const Halfedge h : findJoints(built)) {
    Ends ends = {coordinatesOf(built.mesh.origin(h)), coordinatesOf(built.mesh.tip(h))};
    std::sort(ends.begin(), ends.end());
    const Index part = numbers.ofTriangle[built.triangles[HalfedgeMesh::face(h)]];
    const auto [entry, isNew] = partAt.emplace(ends, part);
    if (!isNew) sets.unite(part, entry->second);
  }
}

// Unites parts that a plane mirrors onto each other: those in which the middles of most of a few
// triangles come to lie.
void uniteImages(DisjointSets& sets, const TriangleMesh& input, const PartNumbers& numbers,
                 const std::vector<MirrorPlane>& planes) {
  constexpr std::size_t kFew = 9;
  std::vector<std::vector<Index>> triangles(numbers.count);
  for (Index t = 0; t < input.triangleCount(); ++t)
    if (numbers.ofTriangle[t] != kNone) triangles[numbers.ofTriangle[t]].push_back(t);
  const TriangleTree tree(input.positions, input.indices);
  for (Index part = 0; part < numbers.count; ++part)
    for (const MirrorPlane& plane : planes) {
      std::vector<Index> images;
      const std::size_t size = triangles[part].size(), step = (size + kFew - 1) / kFew;
      for (std::size_t i = 0; i < size; i += step) {
        const auto [a, b, c] = cornersOf(input, triangles[part][i]);
        const Index near = tree.nearest(plane.mirrored((a + b + c) / 3)).triangle;
        if (numbers.ofTriangle[near] != kNone) images.push_back(numbers.ofTriangle[near]);
      }
      if (images.empty()) continue;
      std::sort(images.begin(), images.end());
      sets.unite(part, images[images.size() / 2]);
    }
}

// The planes that mirror the whole, if they are looked for.
std::vector<MirrorPlane> planesOf(const TriangleMesh& input, const PartOptions& options) {
  if (options.symmetry != Symmetry::Auto || !options.mirrors.planes.empty()) return {};
  const double wished = options.vertices.value_or(Index(input.positions.size()));
  return findMirrorPlanes(input, kPlainlyNear * evenEdgeLength(extentOf(input).area, wished));
}

SurfacePart partOf(const TriangleMesh& input, std::vector<Index> triangles) {
  Submesh part = submeshOf(input, triangles);
  return {std::move(part.mesh), std::move(part.vertices), std::move(triangles), {}};
}

// The caller's wishes for places, which are by vertices of the whole, and a number of vertices.
PartOptions optionsOf(const SurfacePart& part, const PartOptions& whole, double vertices) {
  PartOptions options = whole;
  const auto number = Index(std::max(1LL, std::llround(vertices)));
  options.mirrors.vertices = number;
  options.vertices = Index(number >> whole.mirrors.planes.size());
  options.ratio.reset();
  options.edgeLength.reset();
  options.inBodies.reset();
  options.tooFew = TooFew::Raise;
  options.density.clear();
  options.featureEdges.clear();
  if (!whole.density.empty())
    for (const Index v : part.vertices) options.density.push_back(whole.density[v]);
  const auto own = [&](Index v) {
    const auto found = std::lower_bound(part.vertices.begin(), part.vertices.end(), v);
    const bool isIn = found != part.vertices.end() && *found == v;
    return isIn ? Index(found - part.vertices.begin()) : kNone;
  };
  for (const auto& [a, b] : whole.featureEdges)
    if (own(a) != kNone && own(b) != kNone) options.featureEdges.emplace_back(own(a), own(b));
  return options;
}

// Only planes that mirror all parts mirror the whole.
void keepCommon(std::vector<MirrorPlane>& planes, const std::vector<MirrorPlane>& others) {
  std::erase_if(planes, [&](const MirrorPlane& plane) {
    return std::none_of(others.begin(), others.end(), [&](const MirrorPlane& other) {
      return other.normal == plane.normal && other.offset == plane.offset;
    });
  });
}

// A warning that the whole has already is not repeated for a part.
void addWarnings(std::vector<Warning>& warnings, const std::vector<Warning>& more,
                 const std::vector<Warning>& known) {
  const auto find = [](auto& list, const std::string& code) {
    return std::find_if(list.begin(), list.end(),
                        [&](const Warning& one) { return one.code == code; });
  };
  for (const Warning& warning : more) {
    if (find(known, warning.code) != known.end()) continue;
    const auto same = find(warnings, warning.code);
    if (same == warnings.end())
      warnings.push_back(warning);
    else
      same->count += warning.count;
  }
}

void takePart(RemeshOutcome& whole, RemeshOutcome made, const SurfacePart& part,
              const std::vector<Warning>& known) {
  if (whole.mesh.indices.empty()) {
    whole.mesh = std::move(made.mesh);
    whole.mirrors = std::move(made.mirrors);
  } else {
    append(whole.mesh, made.mesh);
    keepCommon(whole.mirrors, made.mirrors);
  }
  for (const InputPlace& place : made.places)
    whole.places.push_back({InputTriangle{part.triangles[place.triangle.index]}, place.weights});
  std::erase_if(made.warnings, isNumberNote);
  addWarnings(whole.warnings, made.warnings, known);
  whole.vertices += made.vertices;
  whole.coincident += made.coincident;
  whole.quadParts += made.quadParts;
  whole.paired.insert(whole.paired.end(), made.paired.begin(), made.paired.end());
}

}  // namespace

std::vector<SurfacePart> surfaceParts(const TriangleMesh& input, const BuiltMesh& built,
                                      const PartOptions& options) {
  const PartNumbers numbers = numbersOf(input, built);
  if (numbers.count < 2) return {};
  const std::vector<MirrorPlane> planes = planesOf(input, options);
  DisjointSets sets(numbers.count);
  uniteJoined(sets, built, numbers);
  if (!planes.empty()) uniteImages(sets, input, numbers, planes);
  std::vector<std::vector<Index>> triangles(numbers.count);
  std::vector<double> weights(numbers.count, 0), areas(numbers.count, 0);
  double all = 0;
  for (Index t = 0; t < input.triangleCount(); ++t) {
    if (numbers.ofTriangle[t] == kNone) continue;
    const Index set = sets.find(numbers.ofTriangle[t]);
    triangles[set].push_back(t);
    weights[set] += weightOf(input, t, options.density);
    areas[set] += weightOf(input, t, {});
    all += weightOf(input, t, options.density);
  }
  std::vector<SurfacePart> parts;
  for (Index set = 0; set < numbers.count; ++set) {
    if (!(areas[set] > 0)) continue;
    parts.push_back(partOf(input, std::move(triangles[set])));
    parts.back().planes = planes;
    parts.back().share = all > 0 ? weights[set] / all : 0;
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const SurfacePart& a, const SurfacePart& b) { return a.share < b.share; });
  return parts;
}

std::optional<RemeshOutcome> remeshPartByPart(const TriangleMesh& input, const Welding& welding,
                                              const PartOptions& options,
                                              const PartRemesher& remeshPart,
                                              const Progress& progress) {
  progress.phase("build", 0, 0);
  const BuiltMesh built = buildMesh(input, welding);
  const std::vector<SurfacePart> parts = surfaceParts(input, built, options);
  if (parts.size() < 2) return {};
  const std::size_t asked =
      options.mirrors.planes.empty() ? targetVertices(built, options) : options.mirrors.vertices;
  const std::vector<Halfedge> joints = findJoints(built);
  RemeshOutcome whole;
  whole.warnings = built.warnings;
  if (!joints.empty()) whole.warnings.push_back(jointsReleased(input, options, joints.size()));
  const std::vector<Warning> known = whole.warnings;
  std::size_t flat = built.mesh.faceCount();
  for (const SurfacePart& part : parts) flat -= part.triangles.size();
  if (flat > 0)
    whole.warnings.push_back(
        {"DEGENERATE_TRIANGLES_REMOVED", "Connected parts without an area were left out.", flat});
  const std::vector<std::vector<Guide>> guides = guidesByPart(input, parts, options.guides);
  double share = 1, done = 0;
  for (const SurfacePart& part : parts) {
    const bool isLast = &part == &parts.back();
    const double left = std::max(0.0, double(asked) - double(whole.vertices));
    PartOptions own = optionsOf(
        part, options, isLast ? left : left * part.share / std::max({share, part.share, 1e-300}));
    own.exact = options.exact && isLast;
    own.guides = guides[std::size_t(&part - parts.data())];
    const double portion = (part.share + 1 / double(parts.size())) / 2;
    takePart(whole, remeshPart(part, own, progress.part(done, done + portion)), part, known);
    done += portion;
    share -= part.share;
  }
  whole.vertices = countPlaces(whole.mesh.positions);  // parts may share some
  const double off = std::abs(double(whole.vertices) - double(asked));
  if (off > (options.exact ? 0 : kFreeTolerance * double(asked))) whole.stopped = Stopped::Fidelity;
  noteNumber(whole, {asked, options.exact});
  return whole;
}

}  // namespace remesher
