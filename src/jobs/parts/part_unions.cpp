// SPDX-License-Identifier: MIT
#include "jobs/parts/part_unions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/place.h"
#include "io/model/appending.h"
#include "io/model/bake.h"
#include "jobs/parts/part_borders.h"
#include "remesh/schemes/targets.h"

namespace remesher {
namespace {

// A place with a smaller relative determinant is too flat to be inverted.
constexpr double kNoWayBack = 1e-9;
// Vertices that each part of a union has at least, and that are enough for it.
constexpr std::size_t kFewest = 4, kEnough = 16;

// Whether a part is at exactly one place, and that can be inverted.
bool isThere(const io::Part& part) {
  if (part.instances.size() != 1) return false;
  const Eigen::Matrix3d m = part.instances.front().linear();
  const double size = m.cwiseAbs().maxCoeff();
  return size > 0 && std::isfinite(size) && std::abs((m / size).determinant()) > kNoWayBack;
}

// Models with levels of detail keep their parts, and boundaries that are kept need no union.
bool mayUnite(const std::vector<io::Part>& parts, const PartOptions& options) {
  const auto isLevel = [](const io::Part& part) { return !part.finer.empty(); };
  return parts.size() > 1 && options.boundary != Boundary::Keep && options.density.empty() &&
         options.featureEdges.empty() && std::none_of(parts.begin(), parts.end(), isLevel);
}

std::size_t countCornerPlaces(const TriangleMesh& mesh) {
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<char> isCorner(first.size(), 0);
  for (const Index v : mesh.indices) isCorner[first[v]] = 1;
  return std::size_t(std::count(isCorner.begin(), isCorner.end(), 1));
}

using Coordinates = std::array<double, 3>;
Coordinates coordinatesIn(const Vec3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }

// Cuts one part out of the result of a union.
class Parting {
 public:
  Parting(const RemeshOutcome& whole, const std::vector<Index>& triangles)
      : whole_(whole), triangles_(triangles) {}

  // original: the part in its own space. placed: its vertices in the union.
  TriangleMesh mesh(const io::Part& original, std::span<const Vec3> placed,
                    Index firstGroup) const {
    TriangleMesh made = cut(original.mesh, firstGroup);
    std::map<Coordinates, Index> known;
    for (Index v = 0; v < placed.size(); ++v) known.emplace(coordinatesIn(placed[v]), v);
    std::vector<Index> sources;
    for (const Vec3& p : made.positions) {
      const auto found = known.find(coordinatesIn(p));
      sources.push_back(found == known.end() ? kNone : found->second);
    }
    io::transformMesh(made, original.instances.front().inverse());
    for (std::size_t v = 0; v < sources.size(); ++v)
      if (sources[v] != kNone) made.positions[v] = original.mesh.positions[sources[v]];
    return made;
  }

  // Per corner of the part's triangles. In a mirrored part the second and the third corner are
  // exchanged.
  std::vector<InputPlace> places(Index firstTriangle, const Transform& place) const {
    std::vector<InputPlace> result;
    if (whole_.places.empty()) return result;
    const bool isMirrored = place.linear().determinant() < 0;
    for (const Index t : triangles_)
      for (const Index k : {0U, isMirrored ? 2U : 1U, isMirrored ? 1U : 2U}) {
        result.push_back(whole_.places[3 * std::size_t{t} + k]);
        result.back().triangle.index -= firstTriangle;
        if (isMirrored) std::swap(result.back().weights.y(), result.back().weights.z());
      }
    return result;
  }

 private:
  TriangleMesh cut(const TriangleMesh& original, Index firstGroup) const {
    TriangleMesh made;
    std::map<Index, Index> numbers;
    std::vector<Index> sources;
    for (const Index t : triangles_) {
      if (!original.groups.empty()) made.groups.push_back(whole_.mesh.groups[t] - firstGroup);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = whole_.mesh.indices[3 * std::size_t{t} + k];
        const auto [at, isNew] = numbers.emplace(v, Index(sources.size()));
        if (isNew) sources.push_back(v);
        made.indices.push_back(at->second);
      }
    }
    for (const Index v : sources) made.positions.push_back(whole_.mesh.positions[v]);
    for (const Attribute& attribute : original.attributes) {
      const Attribute& all = *findAttribute(whole_.mesh, attribute.semantic);
      made.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
      std::vector<float>& values = made.attributes.back().values;
      for (const Index v : sources) {
        const auto at = all.values.begin() + std::ptrdiff_t(v) * all.itemSize;
        values.insert(values.end(), at, at + all.itemSize);
      }
    }
    made.frame = original.frame;
    made.isQuads = whole_.mesh.isQuads;
    return made;
  }

  const RemeshOutcome& whole_;
  const std::vector<Index>& triangles_;
};

}  // namespace

PartUnions::PartUnions(const std::vector<io::Part>& parts, Held held, const PartOptions& options)
    : parts_(parts), held_(held) {
  std::vector<std::vector<std::size_t>> sets;
  std::vector<TriangleMesh> placed(parts.size());
  if (mayUnite(parts, options)) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!isThere(parts[i])) continue;
      placed[i] = parts[i].mesh;
      io::transformMesh(placed[i], parts[i].instances.front());
    }
    sets = joinedAlongBorders(placed);
  }
  std::set<std::size_t> inUnions;
  for (const std::vector<std::size_t>& set : sets) inUnions.insert(set.begin(), set.end());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto set = std::find_if(sets.begin(), sets.end(),
                                  [&](const auto& members) { return members.front() == i; });
    if (set != sets.end()) {
      add(*set, placed);
    } else if (!inUnions.contains(i)) {
      members_.push_back({i});
      if (!sets.empty()) surfaces_.push_back(parts[i]);
    }
  }
}

void PartUnions::add(std::vector<std::size_t> members, const std::vector<TriangleMesh>& placed) {
  Union made{surfaces_.size(), {}, {}, {}, {}};
  TriangleMesh mesh;
  mesh.isSingle = true;
  mesh.frame = parts_[members.front()].mesh.frame;
  for (const std::size_t m : members) {
    made.vertices.push_back(Index(mesh.positions.size()));
    made.triangles.push_back(Index(mesh.triangleCount()));
    made.groups.push_back(Index(made.bodies.size()));
    appendGroups(mesh.groups, placed[m], mesh.groups.empty() ? 0 : Index(groupCount(mesh)));
    appendMesh(mesh, placed[m]);
    made.bodies.resize(groupCount(mesh), Index(made.groups.size() - 1));
    const TriangleMesh& own = parts_[m].mesh;
    mesh.isSingle = mesh.isSingle && own.isSingle && own.frame == mesh.frame;
  }
  surfaces_.push_back({parts_[members.front()].name, std::move(mesh), {Transform::Identity()}});
  members_.push_back(std::move(members));
  unions_.push_back(std::move(made));
}

const PartUnions::Union* PartUnions::unionOf(std::size_t surface) const {
  const auto found = std::find_if(unions_.begin(), unions_.end(),
                                  [&](const Union& u) { return u.surface == surface; });
  return found == unions_.end() ? nullptr : &*found;
}

// In files that hold parts apart a place on a common border counts once for each part that meets
// there. The number of such places is estimated from the input's, in proportion to the square root
// of the vertex count.
PartOptions PartUnions::optionsOf(std::size_t surface, PartOptions options) const {
  const Union* const whole = unionOf(surface);
  if (!whole || held_ == Held::AsOne) return options;
  if (!options.quads) options.bodies = whole->bodies;
  if (options.edgeLength || leadsByEdges(options)) return options;
  const double bodies = double(members_[surface].size());
  const double ratio = options.ratio.value_or(1);
  double own = 0, asked = 0;
  for (const std::size_t m : members_[surface]) {
    const double count = double(countCornerPlaces(parts_[m].mesh));
    own += count;
    asked += std::round(ratio * count);
  }
  if (options.vertices) asked = double(*options.vertices);
  const std::size_t fewest = kFewest * members_[surface].size();
  if (asked < double(fewest)) {
    if (options.tooFew == TooFew::Refuse)
      throw TooFewVertices(ErrorCode::TargetTooSmall,
                           {std::size_t(asked), fewest, kEnough * members_[surface].size()});
    asked = double(fewest);
  }
  const double shared = own - double(countCornerPlaces(surfaces_[surface].mesh));
  options.ratio.reset();
  if (!options.quads) options.inBodies = Index(asked);
  options.vertices =
      Index(std::lround(std::max(asked / bodies, asked - shared * std::sqrt(asked / own))));
  return options;
}

std::vector<RemeshOutcome> PartUnions::parted(std::size_t surface, RemeshOutcome outcome) const {
  std::vector<RemeshOutcome> result;
  const Union* const whole = unionOf(surface);
  if (!whole) {
    result.push_back(std::move(outcome));
    return result;
  }
  const std::vector<std::size_t>& members = members_[surface];
  std::vector<std::vector<Index>> triangles(members.size());
  // The two halves of a quad stay together.
  if (outcome.mesh.isQuads)
    for (Index t = 1; t < outcome.mesh.triangleCount(); t += 2)
      outcome.mesh.groups[t] = outcome.mesh.groups[t - 1];
  for (Index t = 0; t < outcome.mesh.triangleCount(); ++t)
    triangles[whole->bodies[outcome.mesh.groups[t]]].push_back(t);
  const std::vector<Vec3>& placed = surfaces_[surface].mesh.positions;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const io::Part& original = parts_[members[k]];
    const Parting own(outcome, triangles[k]);
    const std::span<const Vec3> before(&placed[whole->vertices[k]], original.mesh.positions.size());
    RemeshOutcome part;
    part.mesh = own.mesh(original, before, whole->groups[k]);
    part.places = own.places(whole->triangles[k], original.instances.front());
    part.stopped = outcome.stopped;
    part.prefer = outcome.prefer;
    part.chosen = outcome.chosen;
    part.vertices = countPlaces(part.mesh.positions);
    result.push_back(std::move(part));
  }
  result.front().warnings = std::move(outcome.warnings);
  result.front().coincident = outcome.coincident;
  return result;
}

}  // namespace remesher
