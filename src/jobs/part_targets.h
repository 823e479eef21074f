// SPDX-License-Identifier: MIT
// What the caller asks of a whole file, as what is asked of each of its parts. Small parts of a
// large scene may need more vertices than their share by area, to be there at all or to show all of
// their charts: they are given them, and the larger parts do with fewer.
#pragma once

#include <vector>

#include "base/options.h"
#include "io/model/model.h"
#include "jobs/part_places.h"
#include "remesh/schemes/targets.h"

namespace remesher {

class PartTargets {
 public:
  // Throws Error: INVALID_OPTION for what cannot be shared. The arguments must outlive the object.
  PartTargets(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places,
              const RemeshOptions& options);

  // The numbers of the parts in the order in which they are to be remeshed: the smallest first.
  const std::vector<std::size_t>& order() const { return order_; }

  // The options of one part, asked for in this order: an absolute number of vertices is shared out
  // by what charts need, then by area in the world; an edge length is in units of the world. A
  // coarser level of detail comes after the finest and keeps its proportion to that.
  RemeshOptions of(std::size_t part) const;

  // Throws Error for a part that was refused what it was given: of several, with a number for the
  // whole that is enough.
  [[noreturn]] void refuse(std::size_t part, const TooFewVertices& error) const;

  // To be told before the next part is asked about.
  void given(std::size_t part, std::size_t vertices);

 private:
  void reserveForCharts();
  RemeshOptions ofLevel(std::size_t part) const;
  bool isLevel(std::size_t part) const { return !parts_[part].finer.empty(); }
  double shareOf(std::size_t part) const;

  const std::vector<io::Part>& parts_;
  const std::vector<PartPlace>& places_;
  const RemeshOptions& options_;
  std::vector<double> areas_;
  std::vector<double> reserved_;  // vertices that a part has at least, while there are so many
  std::vector<std::size_t> order_;
  std::vector<std::size_t> waiting_;  // those yet to be remeshed, in that order, but for levels
  std::size_t last_ = 0;              // of these
  std::vector<double> given_;         // the numbers of vertices that parts have, once remeshed
  double verticesLeft_ = 0;
};

}  // namespace remesher
