// SPDX-License-Identifier: MIT
#include "mesh/given_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/place.h"
#include "base/sort_pairs.h"
#include "mesh/canonical_order.h"

namespace remesher {

namespace {

bool areAlike(const TriangleMesh& one, Index v, const TriangleMesh& other, Index w) {
  for (std::size_t a = 0; a < one.attributes.size(); ++a) {
    const int size = one.attributes[a].itemSize;
    const auto at = [&](const TriangleMesh& mesh, Index vertex) {
      return mesh.attributes[a].values.begin() + std::ptrdiff_t(vertex) * size;
    };
    if (!std::equal(at(one, v), at(one, v) + size, at(other, w))) return false;
  }
  return true;
}

// Positions as numbers that both meshes share.
class CommonPlaces {
 public:
  CommonPlaces(const TriangleMesh& made, const TriangleMesh& given)
      : givenCount_(given.positions.size()) {
    std::vector<Vec3> positions = given.positions;
    positions.insert(positions.end(), made.positions.begin(), made.positions.end());
    first_ = weld(positions);
  }

  std::size_t size() const { return first_.size(); }
  Index ofGiven(Index v) const { return first_[v]; }
  Index ofMade(Index v) const { return first_[givenCount_ + v]; }

 private:
  std::size_t givenCount_;
  std::vector<Index> first_;
};

// The numbers from 0 on, by ascending keys below `count`; kNone comes last.
std::vector<Index> sortedBy(std::vector<Index> keys, std::size_t count) {
  for (Index& key : keys) key = std::min(key, Index(count));
  return orderByKeys(keys, count + 1);
}

// The vertices at each position.
class VerticesAt {
 public:
  VerticesAt(const TriangleMesh& mesh, const CommonPlaces& places)
      : next_(mesh.positions.size(), kNone), head_(next_) {
    for (Index v = Index(next_.size()); v-- > 0;) {
      next_[v] = head_[places.ofGiven(v)];
      head_[places.ofGiven(v)] = v;
    }
  }

  // Takes the first that is wanted; kNone if none is.
  template <typename IsWanted>
  Index take(Index place, IsWanted isWanted) {
    if (place >= head_.size()) return kNone;
    Index* at = &head_[place];
    while (*at != kNone && !isWanted(*at)) at = &next_[*at];
    const Index found = *at;
    if (found != kNone) *at = next_[found];
    return found;
  }

 private:
  std::vector<Index> next_, head_;
};

// Per vertex that was made the given one of the same position and attributes; if there is none, of
// the same position, since repair turns normals over; else kNone.
std::vector<Index> givenVertices(const TriangleMesh& made, const TriangleMesh& given,
                                 const CommonPlaces& places) {
  VerticesAt vertices(given, places);
  std::vector<Index> found(made.positions.size(), kNone);
  for (Index v = 0; v < found.size(); ++v)
    found[v] =
        vertices.take(places.ofMade(v), [&](Index w) { return areAlike(made, v, given, w); });
  for (Index v = 0; v < found.size(); ++v)
    if (found[v] == kNone) found[v] = vertices.take(places.ofMade(v), [](Index) { return true; });
  return found;
}

struct KeyedTriangle {
  std::array<Index, 3> places;  // sorted
  Index number;

  bool operator<(const KeyedTriangle& other) const {
    return places != other.places ? places < other.places : number < other.number;
  }
};

template <typename PlaceOf>
std::vector<KeyedTriangle> keyed(const TriangleMesh& mesh, std::size_t places, PlaceOf placeOf) {
  std::vector<KeyedTriangle> triangles;
  triangles.reserve(mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    triangles.push_back({{placeOf(v[0]), placeOf(v[1]), placeOf(v[2])}, t});
    std::sort(triangles.back().places.begin(), triangles.back().places.end());
  }
  sortInBuckets(
      triangles, places, [](const KeyedTriangle& t) { return t.places.front(); },
      [](const KeyedTriangle& a, const KeyedTriangle& b) { return a < b; });
  return triangles;
}

// Per triangle that was made the given one of the same corners, either way round; kNone for none.
std::vector<Index> givenTriangles(const TriangleMesh& made, const TriangleMesh& given,
                                  const CommonPlaces& places) {
  const auto ofGiven = keyed(given, places.size(), [&](Index v) { return places.ofGiven(v); });
  const auto ofMade = keyed(made, places.size(), [&](Index v) { return places.ofMade(v); });
  std::vector<Index> found(made.triangleCount(), kNone);
  auto at = ofGiven.begin();
  for (const KeyedTriangle& triangle : ofMade) {
    while (at != ofGiven.end() && at->places < triangle.places) ++at;
    if (at == ofGiven.end() || at->places != triangle.places) continue;
    found[triangle.number] = at->number;
    ++at;
  }
  return found;
}

class Reordering {
 public:
  Reordering(const TriangleMesh& made, const TriangleMesh& given)
      : made_(made), given_(given), places_(made, given) {}

  TriangleMesh run() const {
    CanonicalOrder order;
    order.vertices = sortedBy(givenVertices(made_, given_, places_), given_.positions.size());
    order.numbers.resize(order.vertices.size());
    for (Index v = 0; v < order.vertices.size(); ++v) order.numbers[order.vertices[v]] = v;
    const std::vector<Index> triangles = givenTriangles(made_, given_, places_);
    order.triangles =
        made_.isQuads ? quadsInOrder(triangles) : sortedBy(triangles, given_.triangleCount());
    for (const Index t : order.triangles) order.turns.push_back(turnOf(t, triangles[t]));
    return inOrder(made_, order);
  }

 private:
  // The halves of each quad follow each other, swapped where it was made to begin at the opposite
  // corner.
  std::vector<Index> quadsInOrder(const std::vector<Index>& given) const {
    std::vector<Index> keys, order;
    for (std::size_t t = 0; t + 1 < given.size(); t += 2)
      keys.push_back(std::min(given[t], given[t + 1]));
    for (const Index quad : sortedBy(keys, given_.triangleCount())) {
      const Index a = 2 * quad, b = a + 1;
      const bool isGiven = given[a] != kNone && given[b] != kNone && given[a] / 2 == given[b] / 2;
      // The second half comes first where the quad is turned over, cut from the same corner.
      const bool isSwapped = isGiven && (given[a] % 2 == 1) != isTurnedOver(a, given[a]);
      order.push_back(isSwapped ? b : a);
      order.push_back(isSwapped ? a : b);
    }
    return order;
  }

  bool isTurnedOver(Index triangle, Index given) const {
    const std::size_t second = (turnOf(triangle, given) + std::size_t{1}) % 3;
    return places_.ofMade(made_.indices[3 * std::size_t{triangle} + second]) !=
           places_.ofGiven(given_.indices[3 * std::size_t{given} + 1]);
  }

  // Which corner of the triangle is the given one's first.
  std::uint8_t turnOf(Index triangle, Index given) const {
    if (given == kNone) return 0;
    const Index place = places_.ofGiven(given_.indices[3 * std::size_t{given}]);
    for (std::uint8_t k = 0; k < 3; ++k)
      if (places_.ofMade(made_.indices[3 * std::size_t{triangle} + k]) == place) return k;
    return 0;
  }

  const TriangleMesh &made_, &given_;
  const CommonPlaces places_;
};

}  // namespace

TriangleMesh inCanonicalOrder(const TriangleMesh& mesh) {
  CanonicalOrder order = canonicalOrder(mesh);
  for (Index v = 0; v < order.vertices.size(); ++v) order.numbers[order.vertices[v]] = v;
  return inOrder(mesh, order);
}

TriangleMesh inGivenOrder(const TriangleMesh& made, const TriangleMesh& given) {
  return Reordering(made, given).run();
}

}  // namespace remesher
