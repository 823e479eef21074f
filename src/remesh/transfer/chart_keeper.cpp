// SPDX-License-Identifier: MIT
#include "remesh/transfer/chart_keeper.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace remesher {

ChartKeeper::ChartKeeper(const WorkingMesh& mesh, const ChartRules& rules)
    : mesh_(mesh),
      rules_(rules),
      jumps_(mesh.surface().mesh().halfedgeCapacity(), 0),
      seen_(mesh.surface().mesh().faceCapacity(), 0) {
  const FeatureCurves& curves = mesh.surface().curves();
  const std::vector<char>& absorbed = rules.absorbed.values();
  any_ = std::find(absorbed.begin(), absorbed.end(), 1) != absorbed.end();
  for (const Halfedge h : rules.jumps) {
    jumps_[h] = jumps_[mesh.surface().mesh().twin(h)] = 1;
    any_ = any_ || !mesh.followsAll() || !curves.isCurve(h);
  }
}

// The faces that can be reached from `start` inside the ball without crossing a jump; an absorbed
// face shows its neighbour, not the other way round.
void ChartKeeper::collect(Face start, const Ball& ball) {
  const OriginalSurface& surface = mesh_.surface();
  const HalfedgeMesh& original = surface.mesh();
  ++stamp_;
  seen_[start] = stamp_;
  chart_ = {start};
  for (std::size_t i = 0; i < chart_.size(); ++i) {
    const Halfedge first = HalfedgeMesh::halfedge(chart_[i]);
    for (const Halfedge h : {first, HalfedgeMesh::next(first), HalfedgeMesh::prev(first)}) {
      if (original.isBoundary(h) || jumps_[h]) continue;
      const Face across = HalfedgeMesh::face(original.twin(h));
      const Vec3 &a = surface.positions()[original.origin(h)],
                 &b = surface.positions()[original.tip(h)];
      if (contains(across) || rules_.absorbed[across] > rules_.absorbed[start] ||
          (closestPoint(ball.center, a, b, b) - ball.center).norm() > ball.radius)
        continue;
      seen_[across] = stamp_;
      chart_.push_back(across);
    }
  }
}

void ChartKeeper::intoChart(std::span<SurfacePoint> points) const {
  const OriginalSurface& surface = mesh_.surface();
  for (SurfacePoint& point : points) {
    if (contains(point.face)) continue;
    const Vec3 p = surface.position(point);
    double least = kInfinity;
    for (const Face f : chart_) {
      const auto [a, b, c] = surface.mesh().vertices(f);
      const auto at = [&](Vertex v) -> const Vec3& { return surface.positions()[v]; };
      const SurfacePoint near{f, closestBarycentric(p, at(a), at(b), at(c))};
      const double distance = (surface.position(near) - p).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      point = near;
    }
  }
}

// The nearest face that is not absorbed, by the number of sides to cross. Curves are not crossed.
Face ChartKeeper::absorberOf(std::span<const SurfacePoint> points) {
  const OriginalSurface& surface = mesh_.surface();
  ++stamp_;
  chart_.clear();
  const auto meet = [&](Face f) {
    if (!contains(f)) chart_.push_back(f);
    seen_[f] = stamp_;
  };
  for (const SurfacePoint& point : points) meet(point.face);
  for (std::size_t i = 0; i < chart_.size(); ++i) {
    if (!rules_.absorbed[chart_[i]]) return chart_[i];
    for (int side = 0; side < 3; ++side) {
      const Halfedge h = HalfedgeMesh::halfedge(chart_[i], side);
      if (!surface.mesh().isBoundary(h) && !surface.curves().isCurve(h))
        meet(HalfedgeMesh::face(surface.mesh().twin(h)));
    }
  }
  return {};
}

// A face of the chart to show: of the corners' charts that are not absorbed, the one that most
// corners are in; if all are absorbed, their absorber's. None if the corners are within one chart
// already.
Face ChartKeeper::chartFor(std::span<const SurfacePoint> points, const Ball& ball) {
  Face best;
  std::ptrdiff_t most = 0;
  for (const SurfacePoint& point : points) {
    if (rules_.absorbed[point.face]) continue;
    collect(point.face, ball);
    const auto inside = std::count_if(points.begin(), points.end(),
                                      [&](const SurfacePoint& p) { return contains(p.face); });
    if (inside == std::ptrdiff_t(points.size())) return {};
    if (inside <= most) continue;
    most = inside;
    best = point.face;
  }
  return best ? best : absorberOf(points);
}

void ChartKeeper::intoOneChart(std::span<SurfacePoint> points) {
  const Face first = points.front().face;
  const bool isInOneFace = std::all_of(points.begin(), points.end(),
                                       [&](const SurfacePoint& p) { return p.face == first; });
  if (!any_ || (isInOneFace && !rules_.absorbed[first])) return;
  Ball ball{Vec3::Zero(), 0};
  for (const SurfacePoint& point : points) ball.center += mesh_.surface().position(point);
  ball.center /= double(points.size());
  for (const SurfacePoint& point : points)
    ball.radius = std::max(ball.radius, (mesh_.surface().position(point) - ball.center).norm());
  const Face chart = chartFor(points, ball);
  if (!chart) return;
  collect(chart, ball);
  intoChart(points);
}

}  // namespace remesher
