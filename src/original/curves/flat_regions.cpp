// SPDX-License-Identifier: MIT
#include "original/curves/flat_regions.h"

#include <algorithm>
#include <cmath>

#include "base/options.h"
#include "geometry/triangle.h"
#include "original/curves/facets.h"
#include "original/curves/shape_angles.h"

namespace remesher {

namespace {

const double kSharp = std::cos(radians(kFeatureAngle));  // between normals
// A neighbor more than half as wide as a region is its like; a region with most of its border to
// its likes is a facet.
constexpr double kLike = 2;
// A body with a smaller flat share of its area is round, with places that hardly bend; of one that
// is made of facets, such as a turned part, small ends are flat as well.
constexpr double kLeastShare = 0.25, kLeastOfFacets = 0.01;
// Triangles of a region, and of an end: a facet is a quad, that is two.
constexpr std::size_t kFewest = 2, kFewestOfEnds = 3;
// A body is made of facets if this share of its area lies in one plane with a neighbor.
constexpr double kMadeOfFacets = 0.5;

struct Plane {
  Vec3 normal = Vec3::Zero();  // unit
  Vec3 point = Vec3::Zero();
};

class RegionGrowth {
 public:
  RegionGrowth(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double tolerance)
      : mesh_(mesh),
        positions_(positions),
        bearers_(bearingFaces(mesh, positions)),
        areas_(areaVectors(mesh, positions)),
        tolerance_(tolerance),
        seen_(mesh.faceCapacity(), 0),
        of_(mesh.faceCapacity(), kNone) {}

  FlatRegions run(double width, bool isMadeOfFacets) {
    FlatRegions result{{}, growAll(width)};
    dropFacets(result.widths);
    const std::size_t regions = result.widths.size();
    const bool isFlat = flatShare(kFewest, regions) >= kLeastShare ||
                        (isMadeOfFacets && flatShare(kFewestOfEnds, regions) >= kLeastOfFacets);
    if (regions == 0 || !isFlat) return {};
    result.of = ofBearers();
    return result;
  }

  FaceData<Index> facets() {
    auto count = Index(growAll(0).size());
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (of_[Face(i)] == kNone && hasArea(Face(i))) of_[Face(i)] = count++;
    return ofBearers();
  }

 private:
  // Returns the widths of the regions.
  std::vector<double> growAll(double width) {
    std::vector<double> widths;
    for (const Face seed : seeds()) {
      if (of_[seed] != kNone || seen_[seed] != 0) continue;
      grow(seed, planeOf(seed));
      grow(seed, meanPlane());
      const double own = widthOfGrown();
      if (faces_.size() < kFewest || own < width) continue;
      for (const Face f : faces_) of_[f] = Index(widths.size());
      widths.push_back(own);
    }
    return widths;
  }

  FaceData<Index> ofBearers() const {
    FaceData<Index> result(mesh_.faceCapacity(), kNone);
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) result[Face(i)] = of_[bearers_[Face(i)]];
    return result;
  }

  bool hasArea(Face f) const { return bearers_[f] == f; }

  static FaceData<Vec3> areaVectors(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
    FaceData<Vec3> result(mesh.faceCapacity());
    for (Index i = 0; i < mesh.faceCapacity(); ++i) {
      const auto [a, b, c] = mesh.vertices(Face(i));
      result[Face(i)] = 0.5 * areaVector(positions[a], positions[b], positions[c]);
    }
    return result;
  }

  Plane planeOf(Face f) const { return {areas_[f].normalized(), positions_[mesh_.vertices(f)[0]]}; }

  bool isOn(const Plane& plane, Vertex v) const {
    return std::abs(plane.normal.dot(positions_[v] - plane.point)) <= tolerance_;
  }

  bool facesAlike(const Plane& plane, Face f) const {
    return !hasArea(f) || areas_[f].dot(plane.normal) > 0;
  }

  // Faces that lie in one plane with a neighbor, the largest first, because their planes are the
  // most accurate.
  std::vector<Face> seeds() const {
    std::vector<std::pair<double, Face>> found;
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
      const Face f(i);
      if (!hasArea(f) || areas_[f].isZero(0)) continue;
      const Plane plane = planeOf(f);
      for (int k = 0; k < 3; ++k) {
        const Halfedge across = mesh_.twin(HalfedgeMesh::halfedge(f, k));
        if (!across || !isOn(plane, mesh_.opposite(across))) continue;
        if (!facesAlike(plane, HalfedgeMesh::face(across))) continue;
        found.emplace_back(-areas_[f].squaredNorm(), f);
        break;
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<Face> result;
    for (const auto& [size, f] : found) result.push_back(f);
    return result;
  }

  bool contains(const Plane& plane, Face f) const {
    const auto corners = mesh_.vertices(f);
    return std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return isOn(plane, v); }) &&
           facesAlike(plane, f);
  }

  // Collects the faces in the plane that are connected with the seed; faces without area only
  // connect.
  void grow(Face seed, const Plane& plane) {
    ++round_;
    faces_.clear();
    stack_ = {seed};
    seen_[seed] = round_;
    while (!stack_.empty()) {
      const Face f = stack_.back();
      stack_.pop_back();
      if (hasArea(f)) faces_.push_back(f);
      for (int k = 0; k < 3; ++k) {
        const Halfedge across = mesh_.twin(HalfedgeMesh::halfedge(f, k));
        if (!across) continue;
        const Face next = HalfedgeMesh::face(across);
        if (seen_[next] == round_ || of_[next] != kNone || !contains(plane, next)) continue;
        seen_[next] = round_;
        stack_.push_back(next);
      }
    }
  }

  Plane meanPlane() const {
    Vec3 normal = Vec3::Zero(), point = Vec3::Zero();
    double total = 0;
    for (const Face f : faces_) {
      const Vec3& area = areas_[f];
      const auto [a, b, c] = mesh_.vertices(f);
      normal += area;
      point += area.norm() / 3 * (positions_[a] + positions_[b] + positions_[c]);
      total += area.norm();
    }
    return {normal.normalized(), point / total};
  }

  // The width of the face's region, or of the face if it is in none.
  double widthAt(Face f, const std::vector<double>& widths) const {
    if (of_[f] != kNone) return widths[of_[f]];
    double rim = 0;
    for (int k = 0; k < 3; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, k);
      rim += distance(positions_[mesh_.origin(h)], positions_[mesh_.tip(h)]);
    }
    return rim > 0 ? 2 * areas_[f].norm() / rim : 0;
  }

  // Per region, the share of its border that is not sharp and has its like on the other side.
  std::vector<double> sharesOfLikes(const std::vector<double>& widths) const {
    std::vector<double> like(widths.size(), 0), all(widths.size(), 0);
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i), t = mesh_.isAlive(h) ? mesh_.twin(h) : Halfedge();
      if (!t) continue;
      const Face own = bearers_[mesh_.face(h)], other = bearers_[mesh_.face(t)];
      const Index region = of_[own];
      if (region == kNone || region == of_[other]) continue;
      const double length = distance(positions_[mesh_.origin(h)], positions_[mesh_.tip(h)]);
      all[region] += length;
      const bool isSharp = areas_[own].normalized().dot(areas_[other].normalized()) < kSharp;
      if (!isSharp && kLike * widthAt(other, widths) > widths[region]) like[region] += length;
    }
    for (std::size_t r = 0; r < like.size(); ++r) like[r] = all[r] > 0 ? like[r] / all[r] : 0;
    return like;
  }

  // Drops facets among their likes, which make up round surfaces.
  void dropFacets(std::vector<double>& widths) {
    const std::vector<double> shares = sharesOfLikes(widths);
    std::vector<Index> kept(widths.size(), kNone);
    std::vector<double> left;
    for (std::size_t r = 0; r < widths.size(); ++r) {
      if (2 * shares[r] > 1) continue;
      kept[r] = Index(left.size());
      left.push_back(widths[r]);
    }
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (of_[Face(i)] != kNone) of_[Face(i)] = kept[of_[Face(i)]];
    widths = std::move(left);
  }

  // The share of the area in regions of so many triangles and more.
  double flatShare(std::size_t fewest, std::size_t regions) const {
    std::vector<std::size_t> triangles(regions);
    for (Index i = 0; i < mesh_.faceCapacity(); ++i)
      if (of_[Face(i)] != kNone) ++triangles[of_[Face(i)]];
    double flat = 0, all = 0;
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
      const double area = areas_[Face(i)].norm();
      all += area;
      if (of_[Face(i)] != kNone && triangles[of_[Face(i)]] >= fewest) flat += area;
    }
    return all > 0 ? flat / all : 0;
  }

  double widthOfGrown() const {
    double area = 0, rim = 0;
    for (const Face f : faces_) {
      area += areas_[f].norm();
      for (int k = 0; k < 3; ++k) {
        const Halfedge h = HalfedgeMesh::halfedge(f, k), across = mesh_.twin(h);
        if (across && seen_[bearers_[HalfedgeMesh::face(across)]] == round_) continue;
        rim += distance(positions_[mesh_.origin(h)], positions_[mesh_.tip(h)]);
      }
    }
    return rim > 0 ? 2 * area / rim : 0;
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  const FaceData<Face> bearers_;
  const FaceData<Vec3> areas_;  // along the normals
  const double tolerance_;
  Index round_ = 0;
  FaceData<Index> seen_;  // the last round that saw the face, from 1
  FaceData<Index> of_;
  std::vector<Face> faces_;  // of the region being grown
  std::vector<Face> stack_;  // its faces whose neighbors are still to be checked
};

}  // namespace

FlatRegions findFlatRegions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                            double width) {
  const double coplanar = coplanarShare(mesh, positions);
  if (coplanar < kLeastShare) return {};
  return RegionGrowth(mesh, positions, flatTolerance(mesh, positions))
      .run(width, coplanar >= kMadeOfFacets);
}

FaceData<Index> findFacets(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                           double tolerance) {
  return RegionGrowth(mesh, positions, tolerance).facets();
}

std::vector<Halfedge> bordersOf(const FlatRegions& regions, const HalfedgeMesh& mesh) {
  std::vector<Halfedge> borders;
  for (Index i = 0; i < mesh.halfedgeCapacity() && !regions.empty(); ++i) {
    const Halfedge h(i), t = mesh.twin(h);
    if (!mesh.isEdge(h) || !t) continue;
    if (regions.of[mesh.face(h)] != regions.of[mesh.face(t)]) borders.push_back(h);
  }
  return borders;
}

}  // namespace remesher
