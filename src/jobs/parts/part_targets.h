// SPDX-License-Identifier: MIT
// Shares the caller's targets for a whole file among its parts. Small parts of a large scene may
// need more vertices than their share by area, to exist at all or to show all of their charts: they
// get them, and the larger parts get fewer.
#pragma once

#include <optional>
#include <vector>

#include "base/part_options.h"
#include "io/model/model.h"
#include "jobs/parts/part_places.h"
#include "jobs/parts/shape_shares.h"
#include "remesh/schemes/targets.h"

namespace remesher {

class PartTargets {
 public:
  // Throws INVALID_OPTION for options that cannot be shared. The arguments must outlive the object.
  PartTargets(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places,
              const PartOptions& options);

  // The numbers of the parts in the order in which they are to be remeshed: the smallest first.
  const std::vector<std::size_t>& order() const { return order_; }

  // The options of one part, to be called in this order. An absolute number of vertices is shared
  // by the needs of charts, then by area in the world, or, where the shape is preferred, by what
  // the shapes of the parts need; an edge length is in units of the world. A coarser level of
  // detail comes after the finest and keeps its proportion to it.
  PartOptions of(std::size_t part) const;

  // Throws the Error for a part that was refused its number; if there are several parts, with a
  // number that is enough for the whole.
  [[noreturn]] void refuse(std::size_t part, const TooFewVertices& error) const;

  // Records a part's result; to be called before of() for the next part.
  void given(std::size_t part, std::size_t vertices);

 private:
  void reserveForCharts();
  PartOptions ofLevel(std::size_t part) const;
  bool isLevel(std::size_t part) const { return !parts_[part].finer.empty(); }
  double shareOf(std::size_t part) const;

  const std::vector<io::Part>& parts_;
  const std::vector<PartPlace>& places_;
  const PartOptions& options_;
  std::optional<ShapeShares> byShape_;  // instead of areas and charts
  std::vector<double> areas_;
  std::vector<double> reserved_;  // least vertices of a part, as far as they are left
  std::vector<std::size_t> order_;
  std::vector<std::size_t> waiting_;  // parts yet to be remeshed, in that order, without levels
  std::size_t last_ = 0;              // of waiting_
  std::vector<double> given_;         // per part its number of vertices, once remeshed
  double verticesLeft_ = 0;
};

}  // namespace remesher
