// SPDX-License-Identifier: MIT
#include "jobs/checks/precision.h"

#include <utility>
#include <vector>

#include "base/place.h"
#include "jobs/checks/whole_steps.h"
#include "mesh/joining.h"

namespace remesher {

namespace {

// As it is written: what is less than a few roundings beside the middle that is added is nothing.
Vec3 writtenFrom(const Frame& frame, const Vec3& here) {
  constexpr double kRounding = 0x1p-50;
  const Vec3 nothing = kRounding * frame.written(Vec3::Zero()).cwiseAbs();
  const Vec3 p = frame.written(here);
  return (p.array().abs() <= nothing.array()).select(0, p);
}

// Where it is too large for single precision it stays: the writer refuses it, and says why.
Vec3 roundedToSingle(const Vec3& p) {
  const Vec3 single = p.cast<float>().cast<double>();
  return single.allFinite() ? single : p;
}

}  // namespace

RoundedMesh inPrecisionOf(const TriangleMesh& original, TriangleMesh result) {
  const std::size_t places = countPlaces(result.positions);
  const Frame& frame = original.frame;
  for (Vec3& p : result.positions) p = writtenFrom(frame, p);
  if (original.steps)
    if (std::optional<std::vector<Vec3>> whole = inWholeSteps(result, *original.steps))
      result.positions = std::move(*whole);
  if (original.isSingle)
    for (Vec3& p : result.positions) p = roundedToSingle(p);
  result.isSingle = original.isSingle;
  result.steps = original.steps;
  joinNoise(result);
  unifyPlaces(result.positions);  // so that every reader finds the vertices joined
  const std::size_t left = countPlaces(result.positions);
  for (Vec3& p : result.positions) p = frame.here(p);
  result.frame = frame;
  return {std::move(result), places - left};
}

}  // namespace remesher
