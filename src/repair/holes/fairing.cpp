// SPDX-License-Identifier: MIT
#include "repair/holes/fairing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/fires.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// Weights of one row of the Laplacian: sum of weight · (x[vertex] - x[row]), over the root of the
// area around the row's vertex.
struct Row {
  Index vertex;
  std::vector<std::pair<Index, double>> neighbors;
  double scale = 0;
};

// The plug's vertices, then the surface's vertices that are adjacent to the loop.
class Neighborhood {
 public:
  Neighborhood(const Plug& plug, const BuiltMesh& built, const Loop& loop)
      : points(plug.points), free_(Index(plug.points.size())) {
    VertexData<Index> numbers(built.mesh.vertexCapacity(), kNone);
    for (Index i = 0; i < loop.vertices.size(); ++i) numbers[loop.vertices[i]] = i;
    std::vector<Corners3> triangles = plug.triangles;
    for (const Vertex v : loop.vertices)
      built.mesh.forEachOutgoing(v, [&](Halfedge h) {
        const auto corners = built.mesh.vertices(HalfedgeMesh::face(h));
        Corners3 t;
        for (std::size_t k = 0; k < 3; ++k) t[k] = numberOf(corners[k], built, numbers);
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        triangles.push_back(t);
      });
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    makeRows(triangles);
  }

  std::vector<Vec3> points;
  std::vector<Row> rows;

 private:
  Index numberOf(Vertex v, const BuiltMesh& built, VertexData<Index>& numbers) {
    if (numbers[v] == kNone) {
      numbers[v] = Index(points.size());
      points.push_back(built.positions[v]);
    }
    return numbers[v];
  }

  // Cotangent weights. Slivers would give huge or negative ones, so they are clamped to bounds that
  // are wide for any triangle that refinement leaves.
  void makeRows(const std::vector<Corners3>& triangles) {
    constexpr double kLeast = 0.05, kMost = 10;
    rows.resize(free_);
    for (Index v = 0; v < free_; ++v) rows[v].vertex = v;
    for (const Corners3& t : triangles) {
      const double share = area(points[t[0]], points[t[1]], points[t[2]]) / 3;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const Vec3 u = points[a] - points[t[k]], v = points[b] - points[t[k]];
        const double sine = u.cross(v).norm();
        const double cotangent = sine > 0 ? u.dot(v) / sine : kMost;
        const double weight = std::clamp(cotangent, kLeast, kMost) / 2;
        add(a, b, weight), add(b, a, weight);
        if (t[k] < free_) rows[t[k]].scale += share;
      }
    }
    for (Row& row : rows) row.scale = row.scale > 0 ? 1 / std::sqrt(row.scale) : 0;
  }

  void add(Index v, Index w, double weight) {
    if (v >= free_) return;
    auto& neighbors = rows[v].neighbors;
    const auto known = std::find_if(neighbors.begin(), neighbors.end(),
                                    [w](const auto& other) { return other.first == w; });
    if (known == neighbors.end())
      neighbors.emplace_back(w, weight);
    else
      known->second += weight;
  }

  Index free_;  // the number of rows; loop vertices have rows, but do not move
};

// Least squares by conjugate gradients on the normal equations; all three coordinates at once.
class Smoothest {
 public:
  Smoothest(const Neighborhood& around, Index rim) : around_(around), rim_(rim) {}

  std::vector<Vec3> solve() const {
    // Where sizes grow with the distance from the loop, 30 to 150 rounds bring the residual of
    // plugs of 10 to 10 000 vertices to a millionth. The limit bounds the work for any other plug.
    constexpr int kMostRounds = 400;
    constexpr double kResidual = 1e-12;  // squared
    std::vector<Vec3> x = around_.points;
    std::vector<Vec3> residual = gradient(x);
    const std::vector<double> diagonal = squaredColumns();
    std::vector<Vec3> step = preconditioned(residual, diagonal);
    double before = dot(residual, step);
    const double enough = kResidual * before;
    for (int round = 0; round < kMostRounds && before > enough; ++round) {
      if (round + 1 == kMostRounds) fires("hole fairing: most rounds");
      const std::vector<Vec3> image = gradient(step);  // zero for fixed vertices
      const double along = dot(step, image);
      if (!(along > 0)) break;
      const double length = before / along;
      for (std::size_t v = rim_; v < image.size(); ++v) {
        x[v] -= length * step[v];
        residual[v] -= length * image[v];
      }
      const std::vector<Vec3> next = preconditioned(residual, diagonal);
      const double after = dot(residual, next);
      for (std::size_t v = rim_; v < next.size(); ++v) step[v] = next[v] + after / before * step[v];
      before = after;
    }
    return x;
  }

 private:
  // The gradient of half the sum of squared rows; zero for fixed vertices.
  std::vector<Vec3> gradient(const std::vector<Vec3>& x) const {
    std::vector<Vec3> result(x.size(), Vec3::Zero());
    for (const Row& row : around_.rows) {
      Vec3 value = Vec3::Zero();
      for (const auto& [w, weight] : row.neighbors) value += weight * (x[w] - x[row.vertex]);
      value *= row.scale * row.scale;
      for (const auto& [w, weight] : row.neighbors) {
        result[w] += weight * value;
        result[row.vertex] -= weight * value;
      }
    }
    for (std::size_t v = 0; v < x.size(); ++v)
      if (v < rim_ || v >= around_.rows.size()) result[v] = Vec3::Zero();
    return result;
  }

  std::vector<double> squaredColumns() const {
    std::vector<double> result(around_.points.size(), 0);
    for (const Row& row : around_.rows) {
      const double scale = row.scale * row.scale;
      double sum = 0;
      for (const auto& [w, weight] : row.neighbors)
        sum += weight, result[w] += scale * weight * weight;
      result[row.vertex] += scale * sum * sum;
    }
    return result;
  }

  static std::vector<Vec3> preconditioned(std::vector<Vec3> values,
                                          const std::vector<double>& diagonal) {
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v] = diagonal[v] > 0 ? Vec3(values[v] / diagonal[v]) : Vec3::Zero();
    return values;
  }

  static double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].dot(b[v]);
    return sum;
  }

  const Neighborhood& around_;
  Index rim_;  // the first vertex that moves
};

}  // namespace

void fair(Plug& plug, const BuiltMesh& built, const Loop& loop) {
  const Index rim = Index(loop.vertices.size());
  if (plug.points.size() == rim) return;
  const Neighborhood around(plug, built, loop);
  const std::vector<Vec3> places = Smoothest(around, rim).solve();
  for (std::size_t v = rim; v < plug.points.size(); ++v)
    if (places[v].allFinite()) plug.points[v] = places[v];
}

}  // namespace remesher
