// SPDX-License-Identifier: MIT
#include "contact/met_borders.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

struct BorderEdge {
  Index a, b;
  double low, high;  // along the first axis
};

class BorderMeeting {
 public:
  BorderMeeting(BodySoup& soup, const FlatFaces& flat, double tolerance)
      : soup_(soup), flat_(flat), tolerance_(tolerance) {
    bodyOf_.assign(soup.points.size(), 0);
    for (const BodyTriangle& t : soup.triangles)
      for (const Index p : t.corners) bodyOf_[p] = t.body;
  }

  DividedEdges run() {
    joinPoints();
    for (const std::vector<Index>& cluster : flat_.clusters)
      for (const Index p : pointsOf(cluster)) byX_.emplace_back(at(p).x(), p);
    std::sort(byX_.begin(), byX_.end());
    for (const std::vector<Index>& cluster : flat_.clusters) {
      const std::vector<BorderEdge> edges = edgesOf(cluster);
      divideAtPoints(edges, pointsOf(cluster));
      divideAtCrossings(edges, flat_.faces[cluster.front()].normal);
    }
    return std::move(divided_);
  }

 private:
  const Vec3& at(Index p) const { return soup_.points[p]; }

  template <class Visit>
  void forEachEdge(const std::vector<Index>& cluster, Visit visit) const {
    for (const Index f : cluster)
      for (const Index h : flat_.faces[f].border)
        visit(soup_.triangles[h / 3].corners[h % 3],
              soup_.triangles[h / 3].corners[nextCorner(h) % 3]);
  }

  // By the first axis.
  std::vector<Index> pointsOf(const std::vector<Index>& cluster) const {
    std::vector<Index> points;
    forEachEdge(cluster, [&](Index a, Index) { points.push_back(a); });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::stable_sort(points.begin(), points.end(),
                     [this](Index p, Index q) { return at(p).x() < at(q).x(); });
    return points;
  }

  std::vector<BorderEdge> edgesOf(const std::vector<Index>& cluster) const {
    std::set<std::pair<Index, Index>> all;
    forEachEdge(cluster, [&](Index a, Index b) { all.insert(std::minmax(a, b)); });
    std::vector<BorderEdge> edges;
    for (const auto& [a, b] : all)
      edges.push_back({a, b, std::min(at(a).x(), at(b).x()) - tolerance_,
                       std::max(at(a).x(), at(b).x()) + tolerance_});
    std::stable_sort(edges.begin(), edges.end(),
                     [](const BorderEdge& e, const BorderEdge& f) { return e.low < f.low; });
    return edges;
  }

  // Each point with the nearest of each other body, as far as no two of one body become one.
  void joinPoints() {
    DisjointSets sets(soup_.points.size());
    std::vector<std::vector<Index>> bodies(soup_.points.size());
    for (Index p = 0; p < bodies.size(); ++p) bodies[p] = {bodyOf_[p]};
    const auto join = [&](Index p, Index q) {
      const Index a = sets.find(p), b = sets.find(q);
      if (a == b) return;
      std::vector<Index> both;
      std::set_union(bodies[a].begin(), bodies[a].end(), bodies[b].begin(), bodies[b].end(),
                     std::back_inserter(both));
      if (both.size() < bodies[a].size() + bodies[b].size()) return;
      sets.unite(a, b);
      bodies[std::min(a, b)] = std::move(both);
    };
    for (const std::vector<Index>& cluster : flat_.clusters) {
      struct Near {
        double distance;
        Index p, q;
      };
      std::vector<Near> pairs;
      const std::vector<Index> points = pointsOf(cluster);
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1;
             j < points.size() && at(points[j]).x() <= at(points[i]).x() + tolerance_; ++j)
          if (const double far = (at(points[i]) - at(points[j])).norm(); far <= tolerance_)
            pairs.push_back({far, points[i], points[j]});
      std::stable_sort(pairs.begin(), pairs.end(),
                       [](const Near& a, const Near& b) { return a.distance < b.distance; });
      for (const Near& near : pairs) join(near.p, near.q);
    }
    joinEqual(join);
    for (BodyTriangle& t : soup_.triangles)
      for (Index& corner : t.corners) corner = sets.find(corner);
  }

  // Points at one place: edges of one set of faces are divided at points of others, too.
  template <class Join>
  void joinEqual(Join join) const {
    const std::vector<Index> first = weld(soup_.points);
    std::vector<Index> known(first.size(), kNone);
    for (const std::vector<Index>& cluster : flat_.clusters)
      for (const Index p : pointsOf(cluster)) {
        Index& at = known[first[p]];
        if (at == kNone) at = p;
        join(at, p);
      }
  }

  // The nearest place of the edge, as a share of the way from a to b.
  double shareAt(const BorderEdge& e, const Vec3& p) const {
    const Vec3 way = at(e.b) - at(e.a);
    return way.dot(p - at(e.a)) / way.squaredNorm();
  }
  bool isOn(const BorderEdge& e, const Vec3& p) const {
    const double share = shareAt(e, p);
    if (share < 0 || share > 1) return false;
    return (at(e.a) + share * (at(e.b) - at(e.a)) - p).norm() <= tolerance_;
  }
  bool isEnd(const BorderEdge& e, Index p) const { return p == e.a || p == e.b; }

  void divideAtPoints(const std::vector<BorderEdge>& edges, const std::vector<Index>& points) {
    for (const BorderEdge& e : edges) {
      auto p = std::lower_bound(points.begin(), points.end(), e.low,
                                [this](Index q, double x) { return at(q).x() < x; });
      for (; p != points.end() && at(*p).x() <= e.high; ++p)
        if (!isEnd(e, *p) && isOn(e, at(*p))) divided_.add(e.a, e.b, shareAt(e, at(*p)), *p);
    }
  }

  void divideAtCrossings(const std::vector<BorderEdge>& edges, const Vec3& normal) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size() && edges[j].low <= edges[i].high; ++j)
        cross(edges[i], edges[j], normal);
  }

  // A crossing at the end of either edge is found as a point on the other.
  void cross(const BorderEdge& e, const BorderEdge& f, const Vec3& normal) {
    if (isEnd(e, f.a) || isEnd(e, f.b)) return;
    if (isOn(e, at(f.a)) || isOn(e, at(f.b)) || isOn(f, at(e.a)) || isOn(f, at(e.b))) return;
    const auto turn = [&](const BorderEdge& edge, Index p) {
      return normal.dot((at(edge.b) - at(edge.a)).cross(at(p) - at(edge.a)));
    };
    const double fromA = turn(f, e.a), fromB = turn(f, e.b);
    if (!(fromA * fromB < 0) || !(turn(e, f.a) * turn(e, f.b) < 0)) return;
    const double share = fromA / (fromA - fromB);
    const Vec3 place = at(e.a) + share * (at(e.b) - at(e.a));
    const Index point = pointAt(e, f, place);
    divided_.add(e.a, e.b, share, point);
    divided_.add(f.a, f.b, shareAt(f, place), point);
  }

  // One that divides either edge there already, or lies there, or a new one.
  Index pointAt(const BorderEdge& e, const BorderEdge& f, const Vec3& place) {
    for (const BorderEdge& edge : {e, f})
      for (const Index p : divided_.between(edge.a, edge.b))
        if ((at(p) - place).norm() <= tolerance_) return p;
    const auto from =
        std::lower_bound(byX_.begin(), byX_.end(), std::pair(place.x() - tolerance_, Index{0}));
    for (auto p = from; p != byX_.end() && p->first <= place.x() + tolerance_; ++p)
      if ((at(p->second) - place).norm() <= tolerance_) return p->second;
    const std::pair made(place.x(), Index(soup_.points.size()));
    soup_.points.push_back(place);
    byX_.insert(std::lower_bound(from, byX_.end(), made), made);
    return made.second;
  }

  BodySoup& soup_;
  const FlatFaces& flat_;
  const double tolerance_;
  std::vector<Index> bodyOf_;                  // per point given
  std::vector<std::pair<double, Index>> byX_;  // the points on borders, ascending
  DividedEdges divided_;
};

}  // namespace

DividedEdges meetBorders(BodySoup& soup, const FlatFaces& flat, double tolerance) {
  return BorderMeeting(soup, flat, tolerance).run();
}

}  // namespace remesher
