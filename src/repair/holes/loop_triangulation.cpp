// SPDX-License-Identifier: MIT
#include "repair/holes/loop_triangulation.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/fires.h"
#include "base/versioned_queue.h"
#include "geometry/polygon.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// The tables take n² entries and n³ / 6 steps: 300 thousand steps for this n, some milliseconds.
constexpr std::size_t kMostByTables = 128;

// The cost of a triangulation: its sharpest fold (1 - cosine between neighbours' normals), then its
// area. In a plane all areas are the same but for rounding: then the edges are short.
struct Cost {
  double fold = 0, area = 0;
  bool operator<(const Cost& other) const {
    return fold != other.fold ? fold < other.fold : area < other.area;
  }
};

// The part of a loop that is not filled yet: its vertices' numbers in the plug, and per edge the
// position of the third corner of the triangle across.
struct Polygon {
  std::vector<Index> vertices;
  std::vector<Vec3> beyond;
};

// Folds below this, 1 - cos 20°, count as none: a plug over a curved surface has many of them, and
// then the least area decides.
constexpr double kNoFold = 0.06;

// So little of the squared edges counts beside the areas.
constexpr double kShortness = 1e-6;

double costlyArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return area(a, b, c) +
         kShortness * ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
}

double foldBetween(const Triangle& t, const Vec3& beyond) {
  if (flatness(t[0], t[1], t[2]) <= kFlattest) return 2;  // a line is as bad as a sharpest fold
  // The edge t[0] → t[1]; the triangle across has it the other way round.
  const Vec3 own = unitNormal(t[0], t[1], t[2]), other = unitNormal(t[1], t[0], beyond);
  return std::max(0.0, 1 - own.dot(other) - kNoFold);
}

class Tables {
 public:
  Tables(const Polygon& polygon, const std::vector<Vec3>& points, const std::vector<char>& taken)
      : polygon_(polygon),
        points_(points),
        taken_(taken),
        n_(polygon.vertices.size()),
        costs_(n_ * n_),
        middles_(n_ * n_, kNone) {
    for (std::size_t length = 2; length < n_; ++length)
      for (std::size_t i = 0; i + length < n_; ++i) choose(i, i + length);
  }

  bool isComplete() const { return costs_[n_ - 1].fold < kInfinity; }

  std::vector<Corners3> triangles() const {
    std::vector<Corners3> result;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      const std::size_t m = middles_[i * n_ + k];
      const std::vector<Index>& v = polygon_.vertices;
      result.push_back({v[i], v[m], v[k]});
      open.emplace_back(i, m);
      open.emplace_back(m, k);
    }
    return result;
  }

 private:
  const Vec3& at(std::size_t i) const { return points_[polygon_.vertices[i]]; }

  // The third corner of the triangle across the edge or filled chord from i to k.
  const Vec3& beyond(std::size_t i, std::size_t k) const {
    return k == i + 1 ? polygon_.beyond[i] : at(middles_[i * n_ + k]);
  }

  void choose(std::size_t i, std::size_t k) {
    Cost& best = costs_[i * n_ + k];
    best = {kInfinity, kInfinity};
    if (taken_[i * n_ + k]) return;
    for (std::size_t m = i + 1; m < k; ++m) {
      const Cost left = costs_[i * n_ + m], right = costs_[m * n_ + k];
      if (left.fold == kInfinity || right.fold == kInfinity || left.fold > best.fold ||
          right.fold > best.fold)
        continue;
      Cost cost{std::max({left.fold, right.fold, foldBetween({at(i), at(m), at(k)}, beyond(i, m)),
                          foldBetween({at(m), at(k), at(i)}, beyond(m, k))}),
                left.area + right.area + costlyArea(at(i), at(m), at(k))};
      if (i == 0 && k == n_ - 1)
        cost.fold = std::max(cost.fold, foldBetween({at(k), at(i), at(m)}, polygon_.beyond[k]));
      if (cost < best) best = cost, middles_[i * n_ + k] = Index(m);
    }
  }

  const Polygon& polygon_;
  const std::vector<Vec3>& points_;
  const std::vector<char>& taken_;
  std::size_t n_;
  std::vector<Cost> costs_;  // of the chord from i to k: at i n + k
  std::vector<Index> middles_;
};

// Cuts ears off a long loop. A vertex is convex if the triangles around it fill more than half a
// turn.
class Ears {
 public:
  Ears(const BuiltMesh& built, const Loop& loop, Plug& plug)
      : mesh_(built.mesh), loop_(loop), plug_(plug) {
    const Index n = Index(loop.vertices.size());
    chords_.resize(n);
    for (Index i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n), prev_.push_back((i + n - 1) % n);
      const Halfedge h = loop.across[i];
      beyond_.push_back(built.positions[mesh_.opposite(h)]);
      filled_.push_back(angleAround(built, loop.vertices[i]));
    }
    for (Index i = 0; i < n; ++i) offer(i);
  }

  Polygon cut(std::size_t down) {
    std::size_t left = next_.size();
    while (left > down) {
      const Index ear = queue_.pop();
      if (ear == kNone) break;
      if (isEdge(ear)) continue;
      take(ear);
      --left;
    }
    return rest();
  }

 private:
  static double angleAround(const BuiltMesh& built, Vertex v) {
    double sum = 0;
    built.mesh.forEachOutgoing(v, [&](Halfedge h) {
      sum += angles(built.positions[v], built.positions[built.mesh.tip(h)],
                    built.positions[built.mesh.opposite(h)])[0];
    });
    return sum;
  }

  void offer(Index i) {
    constexpr double kReflexPenalty = 1e6;  // squared: longer than any convex ear's chord
    const double chord = (plug_.points[prev_[i]] - plug_.points[next_[i]]).squaredNorm();
    const bool isReflex = filled_[i] < std::numbers::pi;
    queue_.push(i, -chord * (isReflex ? kReflexPenalty : 1));
  }

  // Whether the chord that would close the ear is an edge already.
  bool isEdge(Index i) const {
    const Index a = prev_[i], b = next_[i];
    if (mesh_.adjacent(loop_.vertices[a], loop_.vertices[b])) return true;
    const auto& chords = chords_[std::min(a, b)];
    return std::find(chords.begin(), chords.end(), std::max(a, b)) != chords.end();
  }

  void take(Index i) {
    const Index a = prev_[i], b = next_[i];
    plug_.triangles.push_back({a, i, b});
    const auto [atA, atI, atB] = angles(plug_.points[a], plug_.points[i], plug_.points[b]);
    filled_[a] += atA, filled_[b] += atB;
    chords_[std::min(a, b)].push_back(std::max(a, b));
    beyond_[a] = plug_.points[i];
    next_[a] = b, prev_[b] = a;
    alive_ = a;
    offer(a), offer(b);
  }

  Polygon rest() const {
    Polygon polygon;
    Index i = alive_;
    do {
      polygon.vertices.push_back(i);
      polygon.beyond.push_back(beyond_[i]);
      i = next_[i];
    } while (i != alive_);
    return polygon;
  }

  const HalfedgeMesh& mesh_;
  const Loop& loop_;
  Plug& plug_;
  std::vector<Index> next_, prev_;
  std::vector<Vec3> beyond_;  // of the edge that begins at each vertex
  std::vector<double> filled_;
  std::vector<std::vector<Index>> chords_;  // per vertex: to vertices of higher numbers
  VersionedQueue queue_;                    // vertices by the negative costs of their ears
  Index alive_ = 0;
};

// Per pair of the polygon's vertices: whether they are joined already, so that no chord may be.
std::vector<char> takenChords(const HalfedgeMesh& mesh, const Loop& loop, const Plug& plug,
                              const Polygon& polygon) {
  const std::size_t n = polygon.vertices.size();
  std::vector<char> taken(n * n, 0);
  std::vector<Index> placeOf(loop.vertices.size(), kNone);
  VertexData<Index> numbers(mesh.vertexCapacity(), kNone);
  for (Index i = 0; i < n; ++i) {
    placeOf[polygon.vertices[i]] = i;
    numbers[loop.vertices[polygon.vertices[i]]] = i;
  }
  const auto take = [&](Index i, Index k) {
    if (i == kNone || k == kNone || (i + 1) % n == k || (k + 1) % n == i) return;
    taken[i * n + k] = taken[k * n + i] = 1;
  };
  for (Index i = 0; i < n; ++i)
    mesh.forEachNeighbor(loop.vertices[polygon.vertices[i]],
                         [&](Vertex w) { take(i, numbers[w]); });
  for (const Corners3& t : plug.triangles)
    for (std::size_t k = 0; k < 3; ++k) take(placeOf[t[k]], placeOf[t[(k + 1) % 3]]);
  return taken;
}

// Whether the loop's three vertices are the corners of a triangle of the surface. A plug must not
// lie back to back with it.
bool isTriangle(const HalfedgeMesh& mesh, const Loop& loop, const Polygon& polygon) {
  const Halfedge h = loop.across[polygon.vertices[0]];
  return loop.vertices.size() == 3 && mesh.opposite(h) == loop.vertices[polygon.vertices[2]];
}

void joinToMiddle(const Polygon& polygon, Plug& plug) {
  Vec3 sum = Vec3::Zero();
  for (const Index v : polygon.vertices) sum += plug.points[v];
  const Index middle = Index(plug.points.size());
  const std::size_t n = polygon.vertices.size();
  plug.points.push_back(sum / double(n));
  plug.parents.push_back(
      {polygon.vertices[0], polygon.vertices[n / 3], polygon.vertices[2 * n / 3]});
  for (std::size_t i = 0; i < n; ++i)
    plug.triangles.push_back({polygon.vertices[i], polygon.vertices[(i + 1) % n], middle});
}

// Per vertex of a loop the next.
std::vector<Index> nextOf(const Loop& loop) {
  std::vector<Index> next(loop.vertices.size());
  std::iota(next.begin(), next.end(), Index{1});
  Index begin = 0;
  for (const Index end : loop.inner) next[end - 1] = std::exchange(begin, end);
  next.back() = begin;
  return next;
}

// Whether two of the plug's vertices that do not follow each other are joined on the surface, too.
bool repeatsEdges(const HalfedgeMesh& mesh, const Loop& loop, const Plug& plug) {
  const std::vector<Index> next = nextOf(loop);
  const auto isRepeated = [&](Index i, Index k) {
    if (next[i] == k || next[k] == i) return false;
    return mesh.adjacent(loop.vertices[i], loop.vertices[k]);
  };
  return std::any_of(plug.triangles.begin(), plug.triangles.end(), [&](const Corners3& t) {
    return isRepeated(t[0], t[1]) || isRepeated(t[1], t[2]) || isRepeated(t[2], t[0]);
  });
}

// Without triangles.
Plug emptyPlug(const BuiltMesh& built, const Loop& loop) {
  Plug plug;
  for (const Vertex v : loop.vertices) plug.points.push_back(built.positions[v]);
  return plug;
}

}  // namespace

Plug triangulated(const BuiltMesh& built, const Loop& loop) {
  Plug plug = emptyPlug(built, loop);
  const Polygon polygon = Ears(built, loop, plug).cut(kMostByTables);
  if (polygon.vertices.size() <= kMostByTables && !isTriangle(built.mesh, loop, polygon)) {
    const std::vector<char> taken = takenChords(built.mesh, loop, plug, polygon);
    const Tables tables(polygon, plug.points, taken);
    if (!tables.isComplete()) fires("hole triangulation: no triangulation by tables");
    if (tables.isComplete()) {
      const std::vector<Corners3> rest = tables.triangles();
      plug.triangles.insert(plug.triangles.end(), rest.begin(), rest.end());
      return plug;
    }
  }
  joinToMiddle(polygon, plug);
  return plug;
}

Plug triangulatedInPlane(const BuiltMesh& built, const Loop& loop) {
  Plug plug = emptyPlug(built, loop);
  plug.triangles = triangulateEvenly(plug.points, loop.inner);
  if (!repeatsEdges(built.mesh, loop, plug)) return plug;
  return loop.inner.empty() ? triangulated(built, loop) : emptyPlug(built, loop);
}

}  // namespace remesher
