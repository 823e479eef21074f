// SPDX-License-Identifier: MIT
// The coordinates in which a mesh is worked on: about its middle, of about unit size and along axes
// of its own, whatever its place, size and quarter turn in the file. Coordinates in decimals, or of
// few binary digits, are whole steps, so that no digit is lost on the way here and back.
#pragma once

#include "base/quarter_turn.h"
#include "base/types.h"

namespace remesher {

struct Frame {
  double step = 1, parts = 1;  // a step is written as step / parts: powers of two and of ten
  Vec3 middle = Vec3::Zero();  // in steps: what is zero here
  double shared = 1;           // steps: all coordinates differ by multiples
  double unit = 1;             // a power of two: what `shared` is here
  QuarterTurn turn;            // what turns written places

  // A place here, as it is written.
  Vec3 written(const Vec3& p) const {
    return (turn.turnedBack(p) / unit * shared + middle) * step / parts;
  }
  // A written place, here.
  Vec3 here(const Vec3& p) const {
    return turn.turned(Vec3((p * parts / step - middle) / shared * unit));
  }
  // The same of a place in whole steps.
  Vec3 hereInSteps(const Vec3& p) const {
    const Vec3 steps = (p * parts / step).array().round();
    return turn.turned(Vec3((steps - middle) / shared * unit));
  }
  // A length here over the written one.
  double scale() const { return parts / step / shared * unit; }

  bool operator==(const Frame&) const = default;
};

// The place nearest to p that single precision can write.
inline Vec3 inSingle(const Vec3& p, const Frame& frame) {
  return frame.here(frame.written(p).cast<float>().cast<double>());
}

// The frame in which double precision coordinates are rounded as if they were single: the same,
// unless the mesh is so far from the origin, so large or so small that its shape would be lost.
inline Frame nearFrame(const Frame& frame) {
  constexpr double kTooFar = 16;  // in sizes of the mesh, which is about 1 here
  constexpr double kTooLarge = 0x1p100;
  const double far = frame.middle.cwiseAbs().maxCoeff() / frame.shared * frame.unit;
  const bool isUsual = frame.scale() < kTooLarge && frame.scale() > 1 / kTooLarge;
  return far > kTooFar || !isUsual ? Frame{} : frame;
}

}  // namespace remesher
