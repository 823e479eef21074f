// SPDX-License-Identifier: MIT
#include "jobs/face_budget.h"

#include <algorithm>
#include <cmath>

namespace remesher {

namespace {

// Quads meet their number of vertices only nearly, and take long.
constexpr int kMostTries = 5, kMostTriesOfQuads = 3;
// So many times fewer faces than the budget are near enough: a vertex more changes the number of
// open edges as well.
constexpr std::size_t kNearTriangles = 2000, kNearQuads = 25;
// Parts of a scene that have as few vertices as their shape allows take no part: each time that
// there are still too many triangles, twice as many vertices fewer are asked for, up to this power.
constexpr int kMostDoublings = 16;
// Each time that there are still too many quads, by so much more of the budget fewer are asked for:
// neighbouring numbers of vertices give the same quads.
constexpr double kFewerQuads = 0.01;

}  // namespace

std::size_t facesOf(const MeshReport& report) {
  return report.quads ? report.quads->count : report.triangles;
}

// Of triangles F = 2 V - 2 χ - B, of quads F = V - χ - B / 2.
Index verticesFor(Index faces, const RemeshOptions& options, const MeshReport& input) {
  const double own = double(std::max<std::size_t>(input.triangles, 1));
  const double triangles = options.quads ? 2.0 * faces : faces;
  const double open = double(input.boundaryEdges) * std::sqrt(triangles / own) /
                      (options.quads ? std::sqrt(2.0) : 1);
  const double vertices =
      (options.quads ? faces : faces / 2.0) + double(input.eulerCharacteristic) + open / 2;
  return Index(std::max(1.0, std::floor(vertices)));
}

FaceSearch::FaceSearch(const RemeshOptions& options, const MeshReport& input)
    : budget_(*options.faces),
      areQuads_(options.quads),
      facesPerVertex_(options.quads ? 1 : 2),
      closeEnough_(
          std::max<std::size_t>(1, budget_ / (options.quads ? kNearQuads : kNearTriangles))),
      next_(verticesFor(*options.faces, options, input)),
      tries_(options.quads ? kMostTries - kMostTriesOfQuads : 0) {}

bool FaceSearch::isBetter(std::size_t faces) const {
  if (best_ == 0) return true;
  if (faces > budget_ || best_ > budget_) return faces < best_;
  return faces > best_;
}

bool FaceSearch::take(const MeshReport& made) {
  const std::size_t faces = facesOf(made);
  const bool isBest = isBetter(faces);
  if (isBest) best_ = faces;
  ++tries_;
  double missing = std::floor((double(budget_) - double(faces)) / facesPerVertex_);
  if (areQuads_ && faces > budget_)
    missing = std::min(missing, -std::ceil(kFewerQuads * beyond_++ * double(budget_)));
  else if (faces > budget_)
    missing = std::min(missing, -std::ldexp(1.0, std::min(beyond_++, kMostDoublings)));
  const double vertices = double(next_) + missing;
  const bool isNear = faces <= budget_ && budget_ - faces <= closeEnough_;
  const int most = best_ <= budget_ ? kMostTries : kMostTries + kMostTriesOfQuads - 1;
  isSettled_ = isNear || missing == 0 || vertices < 1 || tries_ >= most;
  if (!isSettled_) next_ = Index(vertices);
  return isBest;
}

}  // namespace remesher
