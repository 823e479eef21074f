// SPDX-License-Identifier: MIT
// A file mended, and no more.
#include <utility>

#include "io/formats.h"
#include "jobs/mending.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "remesher.h"

namespace remesher {

RemeshFileResult repairFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  io::unite(model, outputName);
  model.isExact = true;  // a repaired surface must not intersect itself for any reader
  Report report = inFile(
      input.file.name, [&] { return repairOnly(model.parts, options, whole.part(kReadShare, 1)); });
  whole.phase("write", 1, 1);
  io::WrittenFiles written = inFile(input.file.name, [&] { return io::write(model, outputName); });
  report.warnings = joined(joined(model.warnings, report.warnings), written.warnings);
  return {std::move(written.files), {}, timed(std::move(report), clock)};
}

}  // namespace remesher
