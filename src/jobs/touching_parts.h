// SPDX-License-Identifier: MIT
// The parts of a file whose bodies touch, as one part: a complex of surfaces that has each common
// face once. The remeshed complex is split into the bodies again.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "contact/common_faces.h"
#include "io/model/model.h"
#include "jobs/body_parts.h"
#include "jobs/scene_run.h"

namespace remesher {

class TouchingParts {
 public:
  // Does nothing unless the options ask for it, and only warns where no bodies touch. `given` must
  // outlive the object. Throws the Errors of requireValid.
  TouchingParts(const std::vector<io::Part>& given, const PartOptions& options);

  // What is to be remeshed: the complex in the place of its first part, and the parts that touch
  // nothing.
  const std::vector<io::Part>& parts() const { return isActive() ? parts_ : given_; }

  // The options for these parts.
  PartOptions applied(PartOptions options) const;

  // Tells the bodies apart again, and describes them.
  void finish(std::vector<SceneRun>& runs) const;

 private:
  bool isActive() const { return complexAt_ < parts_.size(); }
  void find(const PartOptions& options);
  void gather();
  void build(const PartOptions& options);
  void warnOfTouching();
  void warnOfCrossings();
  std::vector<char> partsThatTouch() const;
  void setParts(const std::vector<char>& isMember, const PartOptions& options);
  std::size_t partOf(Index group) const;
  std::vector<std::vector<OwnTriangle>> toldApart(const TriangleMesh& made) const;
  // ofPart: per part given its bodies.
  void replaceParts(SceneRun& run, const std::vector<std::vector<TriangleMesh>>& ofPart) const;
  void describe(SceneRun& run, const std::vector<std::vector<TriangleMesh>>& ofPart,
                std::size_t places) const;

  const std::vector<io::Part>& given_;
  std::vector<Index> firstGroups_;  // per part given, in `all_`
  TriangleMesh all_;                // the parts that may touch, in the world
  BodyComplex complex_;
  std::vector<BodySides> sides_;  // per group of the complex
  std::vector<io::Part> parts_;
  std::size_t complexAt_ = 0;         // its number among `parts_`
  std::vector<std::size_t> numbers_;  // per part given that of `parts_`
  std::vector<Warning> warnings_;
  bool isLedByAngle_ = false;  // the smallest angle that is wanted decides the number of vertices
};

}  // namespace remesher
