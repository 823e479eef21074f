// SPDX-License-Identifier: MIT
// What all levels of detail share: the parts of a scene at about unit size, welded and inspected.
#pragma once

#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/parts/part_places.h"
#include "jobs/parts/part_scale.h"
#include "mesh/welding.h"

namespace remesher {

class InspectedParts {
 public:
  // `parts` must outlive the object. Throws the Errors of requireValid.
  explicit InspectedParts(const std::vector<io::Part>& parts);

  // At about unit size, as are weldings and places.
  const std::vector<io::Part>& parts() const { return scale_.isNeeded() ? scaled_ : given_; }
  const std::vector<Welding>& weldings() const { return weldings_; }  // per part
  const std::vector<PartPlace>& places() const { return places_; }    // per part
  const MeshReport& report() const { return report_; }

  RemeshOptions scaled(const RemeshOptions& options) const;

  // Results at the sizes and places of the given parts.
  std::vector<io::Part> unscaled(std::vector<io::Part> results) const;
  // A place on a part's result, likewise.
  Vec3 given(std::size_t part, const Vec3& p) const;

 private:
  const std::vector<io::Part>& given_;
  PartScale scale_;
  std::vector<io::Part> scaled_;  // empty unless scaling is needed
  std::vector<Welding> weldings_;
  std::vector<PartPlace> places_;
  MeshReport report_;
};

// The report on parts of any size. Throws the Errors of requireValid.
MeshReport inspectScaled(const std::vector<io::Part>& parts);

}  // namespace remesher
