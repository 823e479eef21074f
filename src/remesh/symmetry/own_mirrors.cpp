// SPDX-License-Identifier: MIT
#include "remesh/symmetry/own_mirrors.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "geometry/triangle.h"
#include "mesh/welding.h"

namespace remesher {

namespace {

// How far an image may be from a corner, in lengths of the shortest side.
constexpr double kOff = 0.1;

class OwnMirrors {
 public:
  explicit OwnMirrors(TriangleMesh& mesh) : mesh_(mesh), first_(Welding(mesh).first) {
    const std::vector<Index> corners = quadsOf(mesh);
    double shortest = kInfinity;
    for (std::size_t q = 0; q < corners.size(); q += 4) {
      std::array<Index, 4> quad{};
      for (std::size_t k = 0; k < 4; ++k) quad[k] = first_[corners[q + k]];
      for (std::size_t k = 0; k < 4; ++k) {
        shortest = std::min(shortest,
                            distance(mesh.positions[quad[k]], mesh.positions[quad[(k + 1) % 4]]));
        byX_.emplace(mesh.positions[quad[k]].x(), quad[k]);
      }
      std::sort(quad.begin(), quad.end());
      quads_.insert(quad);
    }
    tolerance_ = kOff * shortest;
  }

  bool isMirrored(const MirrorPlane& plane) {
    imageOf_.clear();
    std::set<Index> images;
    for (const auto& [x, v] : byX_) {
      if (imageOf_.count(v) > 0) continue;
      const Index image = vertexNear(plane.mirrored(mesh_.positions[v]));
      if (image == kNone || !images.insert(image).second) return false;
      imageOf_[v] = image;
    }
    return std::all_of(quads_.begin(), quads_.end(), [&](std::array<Index, 4> quad) {
      for (Index& v : quad) v = imageOf_.at(v);
      std::sort(quad.begin(), quad.end());
      return quads_.count(quad) > 0;
    });
  }

  // About the plane of the last question.
  void mirror(const MirrorPlane& plane) {
    std::vector<Vec3>& at = mesh_.positions;
    for (const auto& [v, image] : imageOf_) {
      if (image < v) continue;
      at[v] = v == image ? plane.onto(at[v]) : Vec3((at[v] + plane.mirrored(at[image])) / 2);
      if (v != image) at[image] = plane.mirrored(at[v]);
    }
    for (std::size_t v = 0; v < at.size(); ++v) at[v] = at[first_[v]];
  }

 private:
  Index vertexNear(const Vec3& p) const {
    Index nearest = kNone;
    double least = tolerance_;
    for (auto i = byX_.lower_bound(p.x() - tolerance_);
         i != byX_.end() && i->first <= p.x() + tolerance_; ++i) {
      const double off = distance(mesh_.positions[i->second], p);
      if (off > least || (off == least && nearest != kNone)) continue;
      nearest = i->second;
      least = off;
    }
    return nearest;
  }

  TriangleMesh& mesh_;
  const std::vector<Index> first_;
  std::multimap<double, Index> byX_;  // the places before any was moved
  std::set<std::array<Index, 4>> quads_;
  std::map<Index, Index> imageOf_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<MirrorPlane> mirrorOwn(TriangleMesh& quads, const std::vector<MirrorPlane>& planes) {
  OwnMirrors own(quads);
  std::vector<MirrorPlane> kept;
  for (const MirrorPlane& plane : planes) {
    if (!own.isMirrored(plane)) continue;
    own.mirror(plane);
    kept.push_back(plane);
  }
  return kept;
}

}  // namespace remesher
