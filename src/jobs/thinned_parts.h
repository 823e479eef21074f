// SPDX-License-Identifier: MIT
// Before anything is built of a scan that is far finer than its result: it is thinned out in plain
// arrays. The report still describes what was given.
#pragma once

#include <cstddef>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"

namespace remesher {

// What is thinned out: parts of more triangles than these, and of more than `perVertex` for each
// vertex of the result; to `kept` vertices for each vertex of the result, at least `fewest`.
struct ThinningLimits {
  std::size_t triangles = 1'500'000, perVertex = 30;
  std::size_t kept = 16, fewest = 300'000;
};

class ThinnedParts {
 public:
  // Thins out in place. Parts stay as they are if an option asks for the original: bounds on the
  // error, densities and edges by the numbers of its vertices, repair, baking, quads.
  ThinnedParts(std::vector<io::Part>& parts, const RemeshOptions& options,
               const ThinningLimits& limits = {});

  bool isThinned() const { return given_ > left_; }

  // The options with a ratio of the given vertices as their number.
  RemeshOptions applied(RemeshOptions options) const;

  // Describes the given parts in the reports, adds the distance of the only part's vertices from
  // the results, and warns.
  void note(std::vector<SceneRun>& runs) const;

 private:
  void thinOut(io::Part& part, std::size_t wanted, bool isAlone);
  FidelityReport measured(const SceneRun& run) const;

  MeshReport input_;
  std::size_t given_ = 0, left_ = 0;  // vertices of the parts that were thinned out
  std::size_t removed_ = 0;           // triangles without three places
  std::vector<Vec3> samples_;         // vertices of the only part
};

}  // namespace remesher
