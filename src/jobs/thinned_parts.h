// SPDX-License-Identifier: MIT
// Before anything is built of a scan that is far finer than its result: it is thinned out in plain
// arrays. The report still describes what was given.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "base/room.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"
#include "simplify/thin_out.h"

namespace remesher {

// What is thinned out: parts of more triangles than these, and of more than `perVertex` for each
// vertex of the result; to `kept` vertices for each vertex of the result, at least `fewest`.
struct ThinningLimits {
  std::size_t triangles = 1'500'000, perVertex = 30;
  std::size_t kept = 16, fewest = 300'000;
  double addresses = kAddresses;  // bytes that there are
};

// NEEDS_THINNING if the parts have no room unless they are thinned out, FAULTS_NOT_SOUGHT if none
// to be repaired. Throws OUT_OF_MEMORY if not even thinned out.
std::vector<Warning> roomWarnings(const std::vector<io::Part>& parts,
                                  const ThinningLimits& limits = {});

class ThinnedParts {
 public:
  // Thins out in place. Parts stay as they are if an option asks for the original: bounds on the
  // error, densities and edges by the numbers of its vertices, repair, baking, quads. Throws
  // OUT_OF_MEMORY, before the work, for what then has no room. If slabs are asked for, the only
  // part is thinned out in these, whatever its size, or becomes the slab asked for; throws
  // INVALID_OPTION if that cannot be.
  ThinnedParts(std::vector<io::Part>& parts, const PartOptions& options,
               const ThinningLimits& limits = {}, const ScanSlabs& slabs = {});

  bool isThinned() const { return given_ > left_; }

  // The options with a ratio of the given vertices as their number.
  PartOptions applied(PartOptions options) const;

  // Describes the given parts in the reports, adds the distance of the only part's vertices from
  // the results, and warns.
  void note(std::vector<SceneRun>& runs) const;

 private:
  void thinOutFine(std::vector<io::Part>& parts, const PartOptions& options,
                   const ThinningLimits& limits);
  std::vector<std::vector<Index>> inspect(const std::vector<io::Part>& parts);
  void noteGiven(const TriangleMesh& mesh);
  void noteLeft(const TriangleMesh& mesh);
  FidelityReport measured(const SceneRun& run) const;

  ScanSlabs slabs_;
  MeshReport input_;
  std::size_t given_ = 0, left_ = 0;  // vertices of the parts that were thinned out
  std::size_t removed_ = 0;           // triangles without three places
  std::size_t repeated_ = 0;          // triangles that repeated others
  std::vector<Vec3> samples_;         // vertices of the only part
};

// Null if nothing is thinned out.
std::unique_ptr<const ThinnedParts> thinnedParts(std::vector<io::Part>& parts,
                                                 const PartOptions& options,
                                                 const ScanSlabs& slabs);

}  // namespace remesher
