// SPDX-License-Identifier: MIT
// Bodies that touch share the triangles of their common face, if the options ask for it.
#pragma once

#include <memory>
#include <vector>

#include "base/options.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"

namespace remesher {

class TouchingParts;

class ConformRun {
 public:
  // `given` must outlive the object. Throws the Errors of requireValid, and INVALID_OPTION for
  // options that exclude `conform`.
  ConformRun(const std::vector<io::Part>& given, const RemeshOptions& options);

  // What is to be remeshed: see TouchingParts.
  const std::vector<io::Part>& parts() const { return *parts_; }

  // The options for these parts.
  RemeshOptions applied(RemeshOptions options) const;

  // Tells the bodies apart again, and describes them.
  void finish(std::vector<SceneRun>& runs) const;

 private:
  std::shared_ptr<const TouchingParts> touching_;  // null unless asked for
  const std::vector<io::Part>* parts_;
};

}  // namespace remesher
