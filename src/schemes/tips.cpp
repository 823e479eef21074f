// SPDX-License-Identifier: MIT
#include "schemes/tips.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

// A tip is worth a triangle of this angle for now: smoothing and polish follow.
constexpr double kSmallestAngle = radians(20);

// At the end no smoothing follows: only good triangles will do, and only for what decides the
// maximum.
constexpr double kFinalAngle = radians(31);
constexpr double kNearMaximum = 0.8;
constexpr double kWorthAMove = 0.15;  // of the target length
constexpr int kPasses = 5;

struct Tip {
  double distance;  // to the mesh
  SurfacePoint original;
  Face nearest;  // of the mesh
};

// Places spread over the original no farther apart than half a target edge: its vertices, and where
// its triangles are large, points inside them.
template <class Visit>
void forEachPlace(const Run& run, Visit visit) {
  const OriginalSurface& surface = run.mesh.surface();
  const HalfedgeMesh& mesh = surface.mesh();
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    if (mesh.isAlive(Vertex(i))) visit(surface.at(Vertex(i)));
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const auto [a, b, c] = mesh.vertices(Face(i));
    const Vec3 &p = surface.positions()[a], &q = surface.positions()[b],
               &r = surface.positions()[c];
    const double longest =
        std::sqrt(std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()}));
    const int n = int(std::ceil(longest / (0.5 * run.scale * run.sizes.at(a))));
    if (n <= 1) continue;
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k + j <= n; ++k) {
        if (j == n || k == n || j + k == 0) continue;  // a vertex
        const double u = double(j) / n, v = double(k) / n;
        visit(SurfacePoint{Face(i), Vec3(1 - u - v, u, v)});
      }
  }
}

// The distances of places of the original to the mesh as it is now.
class DistanceToMesh {
 public:
  explicit DistanceToMesh(const WorkingMesh& mesh)
      : triangles_(mesh.mesh().triangles()), tree_(mesh.positions().values(), triangles_) {
    faces_.reserve(mesh.mesh().faceCount());
    for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f)
      if (mesh.mesh().isAlive(Face(f))) faces_.push_back(Face(f));
  }

  // Exact where the distance exceeds `beyond`.
  Tip measure(const WorkingMesh& mesh, const SurfacePoint& place, double beyond) {
    near_ = tree_.nearestBeyond(beyond, mesh.surface().position(place),
                                near_.triangle == kNone ? 0 : near_.triangle);
    return {std::sqrt(near_.squaredDistance), place, faces_[near_.triangle]};
  }

 private:
  std::vector<Index> triangles_;
  std::vector<Face> faces_;
  TriangleTree tree_;
  TriangleTree::Nearest near_;
};

void sortFarthestFirst(std::vector<Tip>& tips) {
  std::stable_sort(tips.begin(), tips.end(),
                   [](const Tip& a, const Tip& b) { return a.distance > b.distance; });
}

std::vector<Tip> farTips(const Run& run, double tolerance) {
  DistanceToMesh distances(run.mesh);
  std::vector<Tip> tips;
  forEachPlace(run, [&](const SurfacePoint& place) {
    const double enough = tolerance * run.scale * run.sizes.at(place);
    const Tip tip = distances.measure(run.mesh, place, enough);
    if (tip.distance > enough) tips.push_back(tip);
  });
  sortFarthestFirst(tips);
  return tips;
}

double worstComing(const Run& run) {
  double worst = 10;
  const Vec3& moved = run.change.place.position;
  for (const auto& [v, a, b] : run.change.coming)
    worst = std::min(worst, minAngle(moved, run.mesh.position(a), run.mesh.position(b)));
  return worst;
}

bool moveTo(Run& run, Vertex v, const Placement& place, double smallestAngle) {
  if (run.mesh.kind(v) != VertexKind::Interior || run.mesh.isPinned(v)) return false;
  proposePlacement(run.mesh, v, place, run.change);
  return worstComing(run) >= smallestAngle && commit(run, lenient(run));
}

// Whether one of the corners of the nearest triangle, the nearest first, moved to the tip.
bool reach(Run& run, const Tip& tip, double smallestAngle) {
  const Placement place = run.mesh.onSurface(tip.original);
  auto corners = run.mesh.mesh().vertices(tip.nearest);
  const auto distance = [&](Vertex v) {
    return (run.mesh.position(v) - place.position).squaredNorm();
  };
  std::sort(corners.begin(), corners.end(),
            [&](Vertex a, Vertex b) { return distance(a) < distance(b); });
  // One pinned vertex reaches all the original's places around its tip.
  if (run.mesh.isPinned(corners[0])) return false;
  for (const Vertex v : corners) {
    if (!moveTo(run, v, place, smallestAngle)) continue;
    run.mesh.pin(v);
    return true;
  }
  return false;
}

}  // namespace

void reachTips(Run& run, double tolerance) {
  for (const Tip& tip : farTips(run, tolerance)) reach(run, tip, kSmallestAngle);
}

void lowerHausdorff(Run& run) {
  // Moves are few and local: what was near at first stays near.
  std::vector<Tip> tips = farTips(run, kWorthAMove);
  for (int pass = 0; pass < kPasses && !tips.empty(); ++pass) {
    std::size_t moved = 0;
    for (const Tip& tip : tips)
      if (tip.distance > kNearMaximum * tips[0].distance) moved += reach(run, tip, kFinalAngle);
    if (moved == 0) return;
    DistanceToMesh distances(run.mesh);
    for (Tip& tip : tips) tip = distances.measure(run.mesh, tip.original, 0);
    sortFarthestFirst(tips);
  }
}

}  // namespace remesher
