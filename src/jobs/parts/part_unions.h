// SPDX-License-Identifier: MIT
// Remeshes parts with coincident borders as one surface, and cuts the result into parts again: so
// the borders still coincide.
#pragma once

#include <cstddef>
#include <vector>

#include "base/part_options.h"
#include "io/model/model.h"
#include "jobs/parts/part_report.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

class PartUnions {
 public:
  // held: how the results will be. The parts must be valid and outlive the object.
  PartUnions(const std::vector<io::Part>& parts, Held held, const PartOptions& options);

  // The surfaces to remesh: single parts, and each union as one part in the world.
  const std::vector<io::Part>& surfaces() const { return unions_.empty() ? parts_ : surfaces_; }

  // The numbers of the surface's parts; one number if the part is in no union.
  const std::vector<std::size_t>& membersOf(std::size_t surface) const { return members_[surface]; }

  // The options of a surface, so that its parts together meet their targets. Throws TooFewVertices.
  PartOptions optionsOf(std::size_t surface, PartOptions options) const;

  // Cuts the outcome of a surface into those of its parts, each in its own space.
  std::vector<RemeshOutcome> parted(std::size_t surface, RemeshOutcome outcome) const;

 private:
  void add(std::vector<std::size_t> members, const std::vector<TriangleMesh>& placed);

  struct Union {
    std::size_t surface;
    std::vector<Index> vertices, triangles, groups;  // per member its first
    std::vector<Index> bodies;                       // per group the member it is of
  };
  const Union* unionOf(std::size_t surface) const;

  const std::vector<io::Part>& parts_;
  const Held held_;
  std::vector<io::Part> surfaces_;  // empty if there are no unions
  std::vector<std::vector<std::size_t>> members_;
  std::vector<Union> unions_;
};

}  // namespace remesher
