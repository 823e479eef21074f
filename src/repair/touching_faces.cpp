// SPDX-License-Identifier: MIT
#include "repair/touching_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/fires.h"
#include "base/place.h"
#include "base/sort_pairs.h"
#include "contact/body_soup.h"
#include "contact/common_faces.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "mesh/attribute_mix.h"
#include "mesh/coordinate_step.h"
#include "repair/stitch.h"

namespace remesher {

namespace {

constexpr double kMoved = 4;  // a triangle's middle from where it was, at most: ratio to the gap
// Of triangles of one flat face: cosine, and distance from the plane, ratio to their size.
constexpr double kAlike = 0.98, kOffPlane = 1e-3;
constexpr double kSameValue = 1e-4;  // of attributes; relative beyond 1

// A triangle's weights at a point of its plane, which may lie outside of it.
Vec3 weightsAt(const Vec3& p, const Triangle& t) {
  const Vec3 normal = areaVector(t[0], t[1], t[2]);
  const double whole = normal.squaredNorm();
  const double a = areaVector(p, t[1], t[2]).dot(normal) / whole,
               b = areaVector(p, t[2], t[0]).dot(normal) / whole;
  return {a, b, 1 - a - b};
}

class Joining {
 public:
  Joining(const TriangleMesh& bodies, double gap, SharedFaces shared)
      : bodies_(bodies),
        gap_(gap),
        shared_(shared),
        sides_(sidesOf(bodies)),
        tree_(bodies.positions, bodies.indices),
        mix_(bodies) {
    result_.mesh = bodies;
    result_.mesh.indices.clear(), result_.mesh.groups.clear();
    result_.mesh.isQuads = false;
  }

  std::optional<JoinedFaces> run() {
    const std::vector<Index> pieces(bodies_.triangleCount(), 0);
    const BodyComplex complex = complexOf(bodies_, pieces, {gap_, gap_});
    if (complex.touching.pairs.empty()) return std::nullopt;
    places_ = placesOf(complex);
    made_.assign(places_.size(), kNone);
    std::vector<Joined> triangles;
    for (const ComplexTriangle& t : complex.triangles) {
      const bool isShared = t.other.body != kNone;
      if (isShared && shared_ == SharedFaces::Dropped) continue;
      const std::array<Index, 3>& c = t.corners;
      triangles.push_back({c, t.own, t.face != kNone});
      if (isShared) triangles.push_back({{c[0], c[2], c[1]}, t.other, true});
    }
    for (Joined& t : triangles) {
      t.parent = parentOf(t);
      if (t.parent == kNone && !isNeedle(t)) return std::nullopt;
    }
    // Three points of a face's side may make a needle that faces nowhere when they are rounded.
    const bool hasNeedles =
        std::erase_if(triangles, [](const Joined& t) { return t.parent == kNone; }) > 0;
    std::vector<Index> parents;
    for (const Joined& t : triangles) parents.push_back(t.parent);
    for (const Index i : orderByKeys(parents, bodies_.triangleCount()))
      if (!add(triangles[i])) return std::nullopt;
    if (hasNeedles) stitch();
    return std::move(result_);
  }

 private:
  struct Joined {
    std::array<Index, 3> corners;  // the complex's points
    BodySide side;
    bool isNew;  // of a face that was triangulated anew; else it lies in its parent
    Index parent = kNone;
  };

  Triangle at(const Joined& t) const {
    return {places_[t.corners[0]], places_[t.corners[1]], places_[t.corners[2]]};
  }

  // Whether it has no more height than what is brought together.
  bool isNeedle(const Joined& t) const {
    const auto [p, q, r] = at(t);
    const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
    return 2 * area(p, q, r) <= gap_ * longest;
  }

  // Neighbours of needles that were left out get their middle corners.
  void stitch() {
    fires("touching faces: needles left out");
    std::vector<Index> parents;
    for (const Index t : stitchOpenEdges(result_.mesh)) parents.push_back(result_.parents[t]);
    result_.parents = std::move(parents);
  }

  static bool isBefore(const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  }

  // Per triangle its body and group; no body for one with two corners at one place.
  static std::vector<BodySide> sidesOf(const TriangleMesh& bodies) {
    TriangleMesh numbered;
    numbered.positions = bodies.positions, numbered.indices = bodies.indices;
    numbered.groups.resize(bodies.triangleCount());
    std::iota(numbered.groups.begin(), numbered.groups.end(), Index{0});
    std::vector<BodySide> sides(bodies.triangleCount());
    const std::vector<Index> pieces(sides.size(), 0);
    for (const BodyTriangle& t : bodiesOf(numbered, pieces).triangles)
      sides[t.group] = {t.body, bodies.groups.empty() ? 0 : bodies.groups[t.group]};
    return sides;
  }

  // The complex's points; new ones are rounded, those of the bodies are not.
  std::vector<Vec3> placesOf(const BodyComplex& complex) const {
    std::vector<Vec3> given = bodies_.positions;
    std::sort(given.begin(), given.end(), isBefore);
    std::vector<Vec3> places = complex.points;
    for (Vec3& p : places) {
      if (std::binary_search(given.begin(), given.end(), p, isBefore)) continue;
      p = canonicalPlace(p);
      if (bodies_.isSingle) p = inSingle(p, bodies_.frame);
    }
    return places;
  }

  // The nearest triangle of those of its body and group that face the same way.
  Index parentOf(const Joined& t) const {
    const auto [p, q, r] = at(t);
    const Vec3 middle = (p + q + r) / 3, normal = areaVector(p, q, r);
    Box box;
    box.extend(middle.array() - kMoved * gap_);
    box.extend(middle.array() + kMoved * gap_);
    std::pair<double, Index> best{kInfinity, kNone};
    tree_.visitOverlapping(box, [&](Index s) {
      const auto [a, b, c] = tree_.corners(s);
      if (sides_[s] != t.side || areaVector(a, b, c).dot(normal) <= 0) return;
      best = std::min(best, {(closestPoint(middle, a, b, c) - middle).squaredNorm(), s});
    });
    return best.second;
  }

  // Those of its flat face that it may lie on; the largest first.
  std::vector<Index> sourcesOf(const Joined& t) const {
    if (bodies_.attributes.empty() || !t.isNew) return {t.parent};
    Box box;
    for (const Vec3& p : at(t)) {
      box.extend(p.array() - kMoved * gap_);
      box.extend(p.array() + kMoved * gap_);
    }
    const Triangle own = tree_.corners(t.parent);
    const Vec3 normal = unitNormal(own[0], own[1], own[2]);
    std::vector<Index> found;
    double largest = 0;
    tree_.visitOverlapping(box, [&](Index s) {
      const Triangle c = tree_.corners(s);
      const Vec3 vector = areaVector(c[0], c[1], c[2]);
      const double size = vector.norm();
      bool isOn = sides_[s] == t.side && vector.dot(normal) > kAlike * size;
      for (std::size_t k = 0; k < 3; ++k)
        isOn = isOn && std::abs(normal.dot(c[k] - own[0])) <=
                           std::max(kMoved * gap_, kOffPlane * (c[k] - own[0]).norm());
      if (!isOn) return;
      found.push_back(s);
      if (size > largest) std::swap(found.front(), found.back());
      largest = std::max(largest, size);
    });
    return found;
  }

  const Index* verticesOf(Index t) const { return &bodies_.indices[3 * std::size_t{t}]; }

  // Appends the attributes that a triangle has at a point of its plane.
  void append(Index source, const Vec3& p, std::vector<Attribute>& values) const {
    const Index* v = verticesOf(source);
    const Triangle c = tree_.corners(source);
    mix_.append({{v[0], v[1], v[2]}, weightsAt(p, c), areaVector(c[0], c[1], c[2])}, values);
  }

  static bool areSame(const std::vector<Attribute>& a, std::size_t i,
                      const std::vector<Attribute>& b, std::size_t k) {
    for (std::size_t n = 0; n < a.size(); ++n) {
      const auto size = std::size_t(a[n].itemSize);
      for (std::size_t j = 0; j < size; ++j) {
        const float x = a[n].values[i * size + j], y = b[n].values[k * size + j];
        if (!(std::abs(x - y) <= kSameValue * std::max(1.0F, std::abs(x)))) return false;
      }
    }
    return true;
  }

  // Whether attributes are linear all over them, as the first one's are.
  bool areLinear(const std::vector<Index>& sources) const {
    std::vector<Attribute> values = withoutValues(bodies_.attributes);
    std::size_t made = 0;
    for (std::size_t i = 1; i < sources.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = verticesOf(sources[i])[k];
        append(sources.front(), bodies_.positions[v], values);
        if (!areSame(values, made++, bodies_.attributes, v)) return false;
      }
    return true;
  }

  static std::vector<Attribute> withoutValues(std::vector<Attribute> attributes) {
    for (Attribute& attribute : attributes) attribute.values.clear();
    return attributes;
  }

  // Returns whether the bodies' attributes say what it has.
  bool add(const Joined& t) {
    const std::vector<Index> sources = sourcesOf(t);
    if (sources.empty() || !areLinear(sources)) return false;
    for (const Index point : t.corners)
      result_.mesh.indices.push_back(vertexAt(point, t.parent, sources));
    if (!bodies_.groups.empty()) result_.mesh.groups.push_back(bodies_.groups[t.parent]);
    result_.parents.push_back(t.parent);
    return true;
  }

  Index vertexAt(Index point, Index parent, const std::vector<Index>& sources) {
    TriangleMesh& mesh = result_.mesh;
    const Vec3& p = places_[point];
    const auto ownOf = [&](Index triangle) {
      const Index* v = verticesOf(triangle);
      const Index* own = std::find_if(v, v + 3, [&](Index i) { return bodies_.positions[i] == p; });
      return own != v + 3 ? *own : kNone;
    };
    if (const Index own = ownOf(parent); own != kNone) return own;
    for (const Index source : sources)
      if (const Index own = ownOf(source); own != kNone) return own;
    const auto made = Index(mesh.positions.size());
    mesh.positions.push_back(p);
    if (mesh.attributes.empty()) return made;
    append(sources.front(), p, mesh.attributes);
    for (Index other = made_[point]; other != kNone;
         other = next_[other - bodies_.positions.size()])
      if (areSame(mesh.attributes, other, mesh.attributes, made)) {
        dropLastVertex(mesh);
        return other;
      }
    next_.push_back(std::exchange(made_[point], made));
    return made;
  }

  const TriangleMesh& bodies_;
  const double gap_;
  const SharedFaces shared_;
  const std::vector<BodySide> sides_;
  const TriangleTree tree_;
  const AttributeMix mix_;
  std::vector<Vec3> places_;  // of the complex's points
  std::vector<Index> made_;   // per point the last vertex made there
  std::vector<Index> next_;   // per vertex made another one at its point
  JoinedFaces result_;
};

}  // namespace

std::optional<JoinedFaces> withFacesJoined(const TriangleMesh& bodies, double steps,
                                           SharedFaces shared) {
  std::vector<Vec3> used;
  for (const Index v : bodies.indices) used.push_back(bodies.positions[v]);
  return Joining(bodies, steps * coordinateStep(used), shared).run();
}

}  // namespace remesher
