// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirrored_guides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/triangle.h"
#include "remesh/guides/surface_guides.h"

namespace remesher {

namespace {

// Points nearer to a plane than this share of its slack lie on it: a guide along a
// plane is not cut into pieces by rounding.
constexpr double kOnPlane = 0.05;
// A guide that is nowhere farther from a plane than this is left out: sides of quads lie on the
// plane there, and no row of quads fits between.
constexpr double kAlongPlane = 0.5;

// The pieces of a guide on either side of a plane.
class GuidePieces {
 public:
  GuidePieces(const Guide& guide, const MirrorPlane& plane, double slack)
      : guide_(guide), plane_(plane), slack_(slack) {
    const std::size_t count = guide.points.size();
    const std::size_t start = guide.isClosed ? firstOn() : 0;
    for (std::size_t i = 0; i <= sideCount(guide); ++i) add(guide.points[(start + i) % count]);
    end();
    joinEnds(front_);
    joinEnds(behind_);
  }

  // Those on the side with more of the guide, mirrored if that is behind the plane.
  std::vector<Guide> inFront() const {
    const auto length = [](const std::vector<Guide>& pieces) {
      double sum = 0;
      for (const Guide& piece : pieces) sum += lengthOf(piece);
      return sum;
    };
    if (length(front_) >= length(behind_)) return front_;
    std::vector<Guide> images = behind_;
    for (Guide& image : images)
      for (Vec3& p : image.points) p = plane_.mirrored(p);
    return images;
  }

 private:
  int sideOf(const Vec3& p) const {
    const double away = plane_.distance(p);
    return away > slack_ ? 1 : away < -slack_ ? -1 : 0;
  }

  // A point of a closed guide from which on it is on one side only.
  std::size_t firstOn() const {
    const std::size_t count = guide_.points.size();
    for (std::size_t i = 0; i < count; ++i)
      if (sideOf(guide_.points[i]) != sideOf(guide_.points[(i + 1) % count]))
        return (i + 1) % count;
    return 0;
  }

  void add(const Vec3& p) {
    const int side = sideOf(p);
    if (!piece_.empty() && side_ != 0 && side != 0 && side != side_) {
      const double before = plane_.distance(piece_.back()), after = plane_.distance(p);
      const Vec3 on = plane_.onto(piece_.back() + before / (before - after) * (p - piece_.back()));
      piece_.push_back(on);
      end();
      piece_.push_back(on);
    }
    piece_.push_back(side == 0 ? plane_.onto(p) : p);
    if (side != 0) side_ = side;
  }

  void end() {
    Guide made = guide_;
    made.isClosed = false;
    made.points = std::exchange(piece_, {});
    if (made.points.size() > 1) (side_ < 0 ? behind_ : front_).push_back(std::move(made));
    side_ = 0;
  }

  // A closed guide was begun at one of its points, where its first and its last piece meet.
  void joinEnds(std::vector<Guide>& pieces) const {
    if (!guide_.isClosed || pieces.size() < 2) return;
    std::vector<Vec3>&first = pieces.front().points, &last = pieces.back().points;
    if (first.front() != last.back()) return;
    last.insert(last.end(), first.begin() + 1, first.end());
    first = std::move(last);
    pieces.pop_back();
  }

  const Guide& guide_;
  const MirrorPlane& plane_;
  const double slack_;
  std::vector<Vec3> piece_;
  int side_ = 0;  // of the piece; 0 as long as it lies on the plane
  std::vector<Guide> front_, behind_;
};

struct Sides {
  bool isInFront = false, isBehind = false;
};

Sides sidesOf(const Guide& guide, const MirrorPlane& plane, double slack) {
  Sides sides;
  for (const Vec3& p : guide.points) {
    sides.isInFront = sides.isInFront || plane.distance(p) > slack;
    sides.isBehind = sides.isBehind || plane.distance(p) < -slack;
  }
  return sides;
}

bool isAlong(const Guide& guide, const Guide& other, double near) {
  return guide.kind == other.kind &&
         std::all_of(guide.points.begin(), guide.points.end(),
                     [&](const Vec3& p) { return nearestOn(other, p).distance <= near; });
}

}  // namespace

GuidesOfHalf guidesInFront(const std::vector<Guide>& guides, const Mirrors& mirrors, double near) {
  GuidesOfHalf half;
  const double slack = std::max(mirrors.slack, kOnPlane * near);
  for (const Guide& guide : guides) {
    std::vector<Guide> pieces = {guide};
    bool isMoved = false;
    for (const MirrorPlane& plane : mirrors.planes) {
      std::vector<Guide> next;
      for (Guide& piece : pieces) {
        const Sides sides = sidesOf(piece, plane, slack);
        isMoved = isMoved || sides.isBehind;
        std::vector<Guide> own;
        if (sides.isInFront && sides.isBehind) {
          own = GuidePieces(piece, plane, slack).inFront();
        } else {
          if (sides.isBehind)
            for (Vec3& p : piece.points) p = plane.mirrored(p);
          own.push_back(std::move(piece));
        }
        next.insert(next.end(), own.begin(), own.end());
      }
      pieces = std::move(next);
    }
    const auto isAlongPlane = [&](const Guide& piece) {
      return std::any_of(mirrors.planes.begin(), mirrors.planes.end(), [&](const auto& plane) {
        return std::all_of(piece.points.begin(), piece.points.end(), [&](const Vec3& p) {
          return std::abs(plane.distance(p)) <= kAlongPlane * near;
        });
      });
    };
    std::erase_if(pieces, isAlongPlane);
    std::erase_if(pieces, [&](const Guide& piece) {
      return std::any_of(half.guides.begin(), half.guides.end(), [&](const Guide& other) {
        return isAlong(piece, other, near) && isAlong(other, piece, near);
      });
    });
    half.moved += isMoved || pieces.empty();
    half.guides.insert(half.guides.end(), pieces.begin(), pieces.end());
  }
  return half;
}

}  // namespace remesher
