// SPDX-License-Identifier: MIT
// Parts whose borders lie on each other are remeshed as one surface, of which each gets its own:
// so their borders still do.
#pragma once

#include <cstddef>
#include <vector>

#include "base/options.h"
#include "io/model/model.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

class PartUnions {
 public:
  // Of valid parts, which must outlive the object.
  PartUnions(const std::vector<io::Part>& parts, const RemeshOptions& options);

  // What is to be remeshed: the parts, those of a union as one, in the world.
  const std::vector<io::Part>& surfaces() const { return unions_.empty() ? parts_ : surfaces_; }

  // The numbers of its parts; of a part that is in no union its own.
  const std::vector<std::size_t>& membersOf(std::size_t surface) const { return members_[surface]; }

  // What is asked of a surface, so that its parts have together what is asked of them. Throws
  // TooFewVertices.
  RemeshOptions optionsOf(std::size_t surface, RemeshOptions options) const;

  // What its parts get of what was made of a surface, in their own spaces.
  std::vector<RemeshOutcome> parted(std::size_t surface, RemeshOutcome outcome) const;

 private:
  void add(std::vector<std::size_t> members, const std::vector<TriangleMesh>& placed);

  struct Union {
    std::size_t surface;
    std::vector<Index> vertices, triangles, groups;  // of each member the first
    std::vector<Index> bodies;                       // per group its member
  };
  const Union* unionOf(std::size_t surface) const;

  const std::vector<io::Part>& parts_;
  std::vector<io::Part> surfaces_;  // none where there are no unions
  std::vector<std::vector<std::size_t>> members_;
  std::vector<Union> unions_;
};

}  // namespace remesher
