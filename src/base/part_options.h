// SPDX-License-Identifier: MIT
// The options by which a part is made: the caller's, and the decisions that the run adds to them on
// the way to the part.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/options.h"

namespace remesher {

enum class TooFew { Refuse, Raise };  // for a target below what the surface needs
// If isotropic triangles exceed an error bound: use those of the original | end the run.
enum class OutOfBound { FromOriginal, GiveUp };

// A plane that mirrors a surface onto itself.
struct MirrorPlane {
  Vec3 normal;  // unit
  double offset = 0;

  // Signed: positive on the side that the normal points to.
  double distance(const Vec3& p) const { return normal.dot(p) - offset; }
  // Both are exact for a plane x = 0, y = 0 or z = 0.
  Vec3 mirrored(const Vec3& p) const { return p - 2 * distance(p) * normal; }
  Vec3 onto(const Vec3& p) const { return p - distance(p) * normal; }
};

// The planes that mirror a half, at right angles to each other.
struct Mirrors {
  std::vector<MirrorPlane> planes;
  double slack = 0;          // vertices nearer to a plane lie on it
  std::size_t vertices = 0;  // of the whole
};

struct PartOptions : RemeshOptions {
  PartOptions() = default;
  explicit PartOptions(RemeshOptions asked) : RemeshOptions(std::move(asked)) {}

  TooFew tooFew = TooFew::Refuse;
  OutOfBound outOfBound = OutOfBound::FromOriginal;
  std::vector<Index> bodies;           // per input group its body; all bodies form one surface
  std::optional<Index> inBodies;       // exact number of positions, each counted once per body
  double longestOfFacets = kInfinity;  // edges of a part's facets from here on are divided first
  Mirrors mirrors;                     // of quads: the input is a half, cut off along these planes
  std::optional<double> spacing;       // wished for repair's lattice; else from the mesh itself
  bool keepsJoints = false;  // edges at which the surface is cut apart stay, and join it again
};

}  // namespace remesher
