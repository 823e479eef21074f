// SPDX-License-Identifier: MIT
#include "contact/common_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/fires.h"
#include "base/place.h"
#include "contact/face_overlay.h"
#include "contact/met_borders.h"
#include "geometry/box.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Faces that touch are away from a common plane by so many tolerances at most, each.
constexpr double kOffPlane = 4;

class ComplexBuilding {
 public:
  ComplexBuilding(BodySoup soup, const TouchLimits& limits)
      : soup_(std::move(soup)), limits_(limits) {}

  BodyComplex run() {
    complex_.isClosed = soup_.isClosed;
    complex_.touching = findTouching(soup_, limits_);
    const FlatFaces flat = flatFacesOf(soup_, complex_.touching.pairs, limits_.touching);
    const DividedEdges divided = meetBorders(soup_, flat, limits_.touching);
    isReplaced_.assign(soup_.triangles.size(), 0);
    for (const FlatFace& face : flat.faces) widths_.push_back(widthOf(face));
    for (const std::vector<Index>& cluster : flat.clusters) {
      const auto made = overlaid({soup_, flat, divided}, cluster, kOffPlane * limits_.touching);
      if (made)
        replace(flat, cluster, *made);
      else
        leave(flat, cluster);
    }
    for (Index t = 0; t < soup_.triangles.size(); ++t) {
      if (isReplaced_[t]) continue;
      const BodyTriangle& triangle = soup_.triangles[t];
      for (const auto& corners : remesher::divided(triangle.corners, divided, soup_.points))
        complex_.triangles.push_back({corners, {triangle.body, triangle.group}, {}});
    }
    complex_.points = std::move(soup_.points);
    weldPoints();
    return std::move(complex_);
  }

 private:
  // Bodies may touch along whole edges as well, and in corners.
  void weldPoints() {
    const std::vector<Index> first = weld(complex_.points);
    for (ComplexTriangle& t : complex_.triangles)
      for (Index& corner : t.corners) corner = first[corner];
  }

  BodySide sideOf(const FlatFaces& flat, Index face) const {
    if (face == kNone) return {};
    const BodyTriangle& first = soup_.triangles[flat.faces[face].triangles.front()];
    return {first.body, first.group};
  }

  double widthOf(const FlatFace& face) const {
    Box box;
    double sum = 0;
    for (const Index t : face.triangles) {
      for (std::size_t k = 0; k < 3; ++k) box.extend(soup_.at(t, k));
      sum += area(soup_.at(t, 0), soup_.at(t, 1), soup_.at(t, 2));
    }
    return sum / (box.high - box.low).norm();
  }

  double narrower(Index face, Index other) const {
    return std::min(widths_[face], other == kNone ? kInfinity : widths_[other]);
  }

  void replace(const FlatFaces& flat, const std::vector<Index>& cluster,
               const std::vector<OverlaidTriangle>& made) {
    for (const Index f : cluster)
      for (const Index t : flat.faces[f].triangles) isReplaced_[t] = 1;
    for (const OverlaidTriangle& t : made)
      complex_.triangles.push_back({t.corners, sideOf(flat, t.face), sideOf(flat, t.other), t.face,
                                    narrower(t.face, t.other)});
  }

  void leave(const FlatFaces& flat, const std::vector<Index>& cluster) {
    fires("contact: touching faces left as they are");
    if (complex_.left++ == 0) complex_.leftAt = flat.faces[cluster.front()].origin;
  }

  BodySoup soup_;
  const TouchLimits& limits_;
  std::vector<char> isReplaced_;  // per triangle of the soup
  std::vector<double> widths_;    // per flat face
  BodyComplex complex_;
};

class EdgesOf {
 public:
  explicit EdgesOf(const BodyComplex& complex) {
    for (const ComplexTriangle& t : complex.triangles)
      corners_.insert(corners_.end(), t.corners.begin(), t.corners.end());
    edges_.emplace(complex.points.size(), corners_);
  }

  // visit: (its halfedges, its ends, the lower first).
  template <class Visit>
  void forEach(Visit visit) const {
    for (std::size_t e = 0; e < edges_->size(); ++e) {
      const Index h = (*edges_)[e].front();
      const auto [a, b] = std::minmax(corners_[h], corners_[nextCorner(h)]);
      visit((*edges_)[e], a, b);
    }
  }

 private:
  std::vector<Index> corners_;
  std::optional<EdgeGroups> edges_;
};

void divide(BodyComplex& complex, const DividedEdges& edges) {
  std::vector<ComplexTriangle> triangles;
  for (const ComplexTriangle& t : complex.triangles)
    for (const auto& corners : divided(t.corners, edges, complex.points)) {
      triangles.push_back(t);
      triangles.back().corners = corners;
    }
  complex.triangles = std::move(triangles);
}

}  // namespace

BodyComplex complexOf(const TriangleMesh& mesh, std::span<const Index> pieces,
                      const TouchLimits& limits) {
  return ComplexBuilding(bodiesOf(mesh, pieces), limits).run();
}

std::vector<std::array<Index, 3>> trianglesOf(const BodyComplex& complex, Index body) {
  std::vector<std::array<Index, 3>> triangles;
  for (const ComplexTriangle& t : complex.triangles) {
    if (t.own.body == body) triangles.push_back(t.corners);
    if (t.other.body == body) triangles.push_back({t.corners[0], t.corners[2], t.corners[1]});
  }
  return triangles;
}

ConformReport commonFacesIn(const TriangleMesh& mesh, std::span<const BodySides> sides) {
  ConformReport report;
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<Index> corners, groups;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    if (sides[mesh.groups[t]].second.body == kNone) continue;
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(first[mesh.indices[3 * t + k]]);
    groups.push_back(mesh.groups[t]);
    const auto [a, b, c] = cornersOf(mesh, t);
    report.area += area(a, b, c);
  }
  report.triangles = report.faces = groups.size();
  const auto bodiesOf = [&](Index h) {
    const auto& [own, other] = sides[groups[h / 3]];
    return std::pair(own.body, other.body);
  };
  DisjointSets sets(groups.size());
  const EdgeGroups edges(mesh.positions.size(), corners);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const Index h : edges[e])
      for (const Index g : edges[e])
        if (bodiesOf(h) == bodiesOf(g) && sets.unite(h / 3, g / 3)) --report.faces;
  return report;
}

void divideJunctions(BodyComplex& complex, const JunctionLengths& lengths) {
  DividedEdges divided;
  EdgesOf(complex).forEach([&](std::span<const Index> edge, Index a, Index b) {
    if (edge.size() < 3) return;
    const Vec3 from = complex.points[a], way = complex.points[b] - from;
    const double length = way.norm();
    const double parts =
        std::max(std::round(length / lengths.wanted), std::ceil(length / lengths.longest));
    for (double i = 1; i < parts; ++i) {
      divided.add(a, b, i / parts, Index(complex.points.size()));
      complex.points.push_back(from + i / parts * way);
    }
  });
  divide(complex, divided);
}

void divideWithin(BodyComplex& complex, double longest) {
  constexpr int kMostHalvings = 16;
  for (int i = 0; i < kMostHalvings; ++i) {
    DividedEdges divided;
    EdgesOf(complex).forEach([&](std::span<const Index> edge, Index a, Index b) {
      if (edge.size() != 2 || (complex.points[a] - complex.points[b]).norm() <= longest) return;
      const ComplexTriangle &one = complex.triangles[edge[0] / 3],
                            &other = complex.triangles[edge[1] / 3];
      if (one.face != other.face || one.width <= longest || other.width <= longest) return;
      divided.add(a, b, 0.5, Index(complex.points.size()));
      complex.points.push_back((complex.points[a] + complex.points[b]) / 2);
    });
    if (divided.empty()) return;
    divide(complex, divided);
  }
}

}  // namespace remesher
