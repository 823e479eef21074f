// SPDX-License-Identifier: MIT
// What is asked for mended, before anything else is done with it.
#pragma once

#include <optional>
#include <vector>

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/part_repair.h"

namespace remesher {

// Of a run's time, about.
double mendShare(const RemeshOptions& options);

// Mends the parts in place, if that is asked for, and keeps the report on it.
class Mending {
 public:
  Mending(std::vector<io::Part>& parts, const RemeshOptions& options, const Progress& progress);

  // What is asked for with what was done, where the choice was repair's own. Without a number of
  // vertices the input's counts, of which `ratio` is a share: repair may have made many times that.
  RemeshOptions chosen(RemeshOptions options) const;

  // Textures are painted anew if nobody has a say in it and the surface is another than was given,
  // not that with its holes closed: charts end anywhere on it. The model's warnings say so.
  RemeshOptions withPaint(RemeshOptions options, io::Model& model) const;

  // The input is what was given, not what was made of it.
  void note(Report& report) const;

 private:
  MeshReport input_;
  std::optional<PartsRepair> repair_;
  std::optional<double> ratio_;  // of the mended parts' vertices, where the input's count
};

// Mends the parts in place, and says all but how long it took.
Report repairOnly(std::vector<io::Part>& parts, const RemeshOptions& options,
                  const Progress& progress);

}  // namespace remesher
