// SPDX-License-Identifier: MIT
#include "jobs/inspected_parts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_report.h"

namespace remesher {
namespace {

// Triangles from which on a part is inspected as it is given.
constexpr std::size_t kLarge = 1'500'000;

// Densities of the vertices in their new order, if there is one for each.
void putInOrder(std::vector<float>& density, const CanonicalOrder& order) {
  if (density.size() != order.vertices.size()) return;
  std::vector<float> made;
  for (const Index v : order.vertices) made.push_back(density[v]);
  density = std::move(made);
}

using VertexPairs = std::vector<std::pair<Index, Index>>;

// The vertices of edges by their new numbers. Each pair must be joined by an edge of a triangle.
VertexPairs inOrder(VertexPairs pairs, const CanonicalOrder& order, const Welding& welding) {
  if (pairs.empty()) return pairs;
  std::set<std::pair<Index, Index>> edges;
  for (Index h = 0; h < welding.corners.size(); ++h)
    edges.insert(std::minmax(welding.corners[h], welding.corners[nextCorner(h)]));
  for (auto& [a, b] : pairs) {
    const Index known = Index(order.numbers.size());
    const Index from = a < known ? order.numbers[a] : kNone;
    const Index to = b < known ? order.numbers[b] : kNone;
    if (from == kNone || to == kNone ||
        !edges.contains(std::minmax(welding.first[from], welding.first[to])))
      throw Error(ErrorCode::InvalidOption,
                  "featureEdges: there is no edge between vertices " + std::to_string(a) + " and " +
                      std::to_string(b) + ".",
                  "Give pairs of input vertices that an edge of a triangle joins.");
    a = from, b = to;
  }
  return pairs;
}

// Those with invalid values stay, so that the message on them names the given vertex.
bool isDensityValid(const std::vector<float>& density) {
  return std::all_of(density.begin(), density.end(),
                     [](float value) { return std::isfinite(value) && value >= 0; });
}

bool isUnchanged(const TriangleMesh& now, const TriangleMesh& before) {
  return now.indices == before.indices && now.positions == before.positions &&
         now.groups == before.groups && now.isQuads == before.isQuads;
}

}  // namespace

InspectedParts::InspectedParts(const std::vector<io::Part>& given, const Progress& progress)
    : given_(given),
      frames_(given, FrameRounding::Allowed, FrameAxes::Own),
      parts_(frames_.isNeeded() ? frames_.applied(given) : given) {
  for (io::Part& part : parts_) {
    requireValid(part.mesh);
    orders_.push_back(canonicalOrder(part.mesh));
    progress.at(0.45 * double(orders_.size()) / double(parts_.size()));
    part.mesh = inOrder(part.mesh, orders_.back());
  }
  weldings_ = weldingsOf(parts_);
  places_ = placesOf(parts_);
  progress.at(0.7);
  report_ = inspectParts(parts_, weldings_, places_);
  report_.diagonal = worldDiagonal(given_);
}

PartOptions InspectedParts::applied(PartOptions options) const {
  if (orders_.size() == 1) {
    if (isDensityValid(options.density)) putInOrder(options.density, orders_.front());
    options.featureEdges =
        inOrder(std::move(options.featureEdges), orders_.front(), weldings_.front());
  }
  return frames_.applied(std::move(options));
}

std::vector<io::Part> InspectedParts::undone(std::vector<io::Part> results) const {
  std::vector<char> isGiven;
  for (std::size_t i = 0; i < results.size(); ++i)
    isGiven.push_back(char(isUnchanged(results[i].mesh, parts_[i].mesh)));
  results = frames_.undone(std::move(results), given_);
  for (std::size_t i = 0; i < results.size(); ++i)
    if (isGiven[i]) results[i].mesh = given_[i].mesh;
  return results;
}

std::vector<InputPlace> InspectedParts::given(std::size_t part,
                                              std::vector<InputPlace> places) const {
  const CanonicalOrder& order = orders_[part];
  for (InputPlace& place : places) {
    const std::size_t t = place.triangle.index;
    const Vec3 weights = place.weights;
    place.triangle = InputTriangle(order.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k)
      place.weights[Eigen::Index((k + order.turns[t]) % 3)] = weights[Eigen::Index(k)];
  }
  return places;
}

Vec3 InspectedParts::given(std::size_t part, const Vec3& p) const {
  return frames_.undone(part, p);
}

PlainInspection::PlainInspection(const std::vector<io::Part>& parts) {
  for (const io::Part& part : parts) {
    requireValid(part.mesh);
    weldings.emplace_back(part.mesh, Twins::Unknown);
  }
  report = inspectParts(parts, weldings, placesOf(parts));
  report.diagonal = worldDiagonal(parts);
}

MeshReport inspectScaled(const std::vector<io::Part>& parts, const Progress& progress) {
  const bool isLarge = std::any_of(parts.begin(), parts.end(), [](const io::Part& part) {
    return part.mesh.triangleCount() >= kLarge;
  });
  if (isLarge) return PlainInspection(parts).report;
  return InspectedParts(parts, progress).report();
}

}  // namespace remesher
