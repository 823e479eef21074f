// SPDX-License-Identifier: MIT
// The data that all levels of detail share: the parts of a scene at about unit size and in
// canonical order, welded and inspected.
#pragma once

#include <vector>

#include "base/input_place.h"
#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/parts/part_frames.h"
#include "jobs/parts/part_places.h"
#include "mesh/canonical_order.h"
#include "mesh/welding.h"

namespace remesher {

class InspectedParts {
 public:
  // `parts` must outlive the object. Throws the Errors of requireValid.
  explicit InspectedParts(const std::vector<io::Part>& parts, const Progress& progress = {});

  const std::vector<io::Part>& given() const { return given_; }
  // At about unit size and in canonical order, as are weldings and places.
  const std::vector<io::Part>& parts() const { return parts_; }
  const std::vector<Welding>& weldings() const { return weldings_; }  // per part
  const std::vector<PartPlace>& places() const { return places_; }    // per part
  const MeshReport& report() const { return report_; }

  // The options for these parts: lengths, and numbers of vertices.
  PartOptions applied(PartOptions options) const;

  // Results at the sizes and places of the given parts. A part that is what it was comes back as it
  // was given.
  std::vector<io::Part> undone(std::vector<io::Part> results) const;
  // The same places on the given part.
  std::vector<InputPlace> given(std::size_t part, std::vector<InputPlace> places) const;
  // A place on a part's result, likewise.
  Vec3 given(std::size_t part, const Vec3& p) const;

 private:
  const std::vector<io::Part>& given_;
  PartFrames frames_;
  std::vector<CanonicalOrder> orders_;  // per part
  std::vector<io::Part> parts_;
  std::vector<Welding> weldings_;
  std::vector<PartPlace> places_;
  MeshReport report_;
};

// Parts of millions of triangles as they are given, in a third of the memory: without an order of
// their own, about unit size, and twins. Throws the Errors of requireValid.
struct PlainInspection {
  explicit PlainInspection(const std::vector<io::Part>& parts);

  std::vector<Welding> weldings;  // per part
  MeshReport report;
};

// The report on parts of any size. Throws the Errors of requireValid.
MeshReport inspectScaled(const std::vector<io::Part>& parts, const Progress& progress = {});

}  // namespace remesher
