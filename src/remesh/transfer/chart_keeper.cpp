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

std::array<SurfacePoint, 3> ChartKeeper::intoChart(
    const std::array<SurfacePoint, 3>& points) const {
  const OriginalSurface& surface = mesh_.surface();
  std::array<SurfacePoint, 3> result = points;
  for (SurfacePoint& point : result) {
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
  return result;
}

// The nearest face that is not absorbed, by the number of sides to cross. Curves are not crossed.
Face ChartKeeper::absorberOf(const std::array<SurfacePoint, 3>& points) {
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
Face ChartKeeper::chartFor(const std::array<SurfacePoint, 3>& points, const Ball& ball) {
  Face best;
  std::ptrdiff_t most = 0;
  for (const SurfacePoint& point : points) {
    if (rules_.absorbed[point.face]) continue;
    collect(point.face, ball);
    const auto inside = std::count_if(points.begin(), points.end(),
                                      [&](const SurfacePoint& p) { return contains(p.face); });
    if (inside == 3) return {};
    if (inside <= most) continue;
    most = inside;
    best = point.face;
  }
  return best ? best : absorberOf(points);
}

std::array<SurfacePoint, 3> ChartKeeper::corners(Face f) {
  const Halfedge h = HalfedgeMesh::halfedge(f);
  const std::array<SurfacePoint, 3> points = {mesh_.cornerPoint(h),
                                              mesh_.cornerPoint(HalfedgeMesh::next(h)),
                                              mesh_.cornerPoint(HalfedgeMesh::prev(h))};
  if (!any_ || (points[0].face == points[1].face && points[0].face == points[2].face &&
                !rules_.absorbed[points[0].face]))
    return points;
  std::array<Vec3, 3> places;
  for (int k = 0; k < 3; ++k) places[k] = mesh_.surface().position(points[k]);
  Ball ball{(places[0] + places[1] + places[2]) / 3, 0};
  for (const Vec3& p : places) ball.radius = std::max(ball.radius, (p - ball.center).norm());
  const Face chart = chartFor(points, ball);
  if (!chart) return points;
  collect(chart, ball);
  return intoChart(points);
}

}  // namespace remesher
