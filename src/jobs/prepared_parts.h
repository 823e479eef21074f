// SPDX-License-Identifier: MIT
// The steps before parts are remeshed, and what the results need afterwards, in reverse order: near
// vertices are joined, quads cut, scans far finer than the result thinned out, surfaces mended, and
// bodies that touch made one complex.
#pragma once

#include <memory>
#include <vector>

#include "base/part_options.h"
#include "base/progress.h"
#include "io/model/model.h"
#include "jobs/mending.h"
#include "jobs/thinned_parts.h"
#include "jobs/touching_parts.h"

namespace remesher {

struct PreparationInput {
  std::vector<io::Part>& parts;
  ScanSlabs slabs = {};
  bool keepsGiven = false;  // the parts before they were mended
};

class PreparedParts {
 public:
  // Changes the parts of the input in place; these must outlive the object. Throws the Errors of
  // the steps.
  PreparedParts(PreparationInput input, const PartOptions& options, const Progress& progress);

  // The parts to be remeshed, and the options for them.
  const std::vector<io::Part>& parts() const { return touching_.parts(); }
  const PartOptions& options() const { return chosen_; }

  const Mending& mending() const { return mending_; }
  // The parts before they were mended, those that are left; empty if they were not kept.
  const std::vector<io::Part>& given() const { return given_; }

  // Tells bodies apart again, and describes in the reports what was done before.
  void finish(std::vector<SceneRun>& runs, Held held) const;

 private:
  std::unique_ptr<const ThinnedParts> thinned_;  // null if nothing is thinned out
  std::vector<io::Part> given_;
  Mending mending_;
  TouchingParts touching_;
  PartOptions chosen_;
};

}  // namespace remesher
