// SPDX-License-Identifier: MIT
#include "remesher.h"

#include <string>
#include <utility>

#include "base/stopwatch.h"
#include "io/formats.h"
#include "measure/hausdorff.h"
#include "parts/part_report.h"
#include "parts/part_scale.h"
#include "parts/part_targets.h"
#include "schemes/remesh.h"

namespace remesher {
namespace {

// The shares of a run's time, about.
constexpr double kReadShare = 0.05;
constexpr double kMeasureShare = 0.15;

// Every part remeshed, and a report on all but reading and writing.
struct Run {
  std::vector<io::Part> parts;
  Report report;
};

// Returns the number of vertices aimed at.
std::size_t remeshPart(Run& run, io::Part& part, const RemeshOptions& options,
                       const Progress& progress) {
  RemeshOutcome outcome = remeshSurface(part.mesh, options, progress);
  part.mesh = std::move(outcome.mesh);
  run.report.timings.build += outcome.buildMilliseconds;
  run.report.warnings = joined(std::move(run.report.warnings), outcome.warnings);
  if (outcome.stopped != Stopped::Target) run.report.stopped = outcome.stopped;
  return outcome.target;
}

Run remeshParts(const std::vector<io::Part>& originals, const RemeshOptions& options,
                const Progress& progress) {
  Run run{originals, {}};
  run.report.input = inspectParts(originals);
  const Stopwatch stopwatch;
  PartTargets targets(originals, options);
  const double total = double(run.report.input.triangles) / (1 - kMeasureShare);
  double done = 0;
  for (const std::size_t i : targets.order()) {
    const double share = double(originals[i].mesh.triangleCount()) / total;
    const Progress part = progress.part("remesh", done, done + share);
    targets.given(i, remeshPart(run, run.parts[i], targets.of(i), part));
    done += share;
  }
  run.report.timings.remesh = stopwatch.milliseconds() - run.report.timings.build;
  progress.part("measure", 1 - kMeasureShare, 1).at(0);
  run.report.output = inspectParts(run.parts);
  if (!originals.empty())
    run.report.fidelity = measureFidelity(gathered(originals), gathered(run.parts));
  return run;
}

// The same for parts of any size.
Run remeshScaled(const std::vector<io::Part>& originals, const RemeshOptions& options,
                 const Progress& progress) {
  const PartScale scale(originals);
  if (!scale.isNeeded()) return remeshParts(originals, options, progress);
  Run run = remeshParts(scale.applied(originals), scale.applied(options), progress);
  run.parts = scale.undone(std::move(run.parts), originals);
  return run;
}

MeshReport inspectScaled(const std::vector<io::Part>& parts) {
  const PartScale scale(parts);
  return inspectParts(scale.isNeeded() ? scale.applied(parts) : parts);
}

// Errors that speak of a vertex or a triangle alone do not say of which file.
template <class Body>
auto inFile(const std::string& name, Body body) {
  try {
    return body();
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool saysWhere = name.empty() || message.find(name) != std::string::npos;
    if (error.code == ErrorCode::Cancelled || saysWhere) throw;
    throw Error(error.code, name + ": " + message, error.hint);
  }
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  Run run = remeshScaled({io::Part{"", mesh, {}}}, options, progress);
  return {std::move(run.parts.front().mesh), std::move(run.report)};
}

RemeshFileResult remeshFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  progress.part("read", 0, kReadShare).at(0);
  const Stopwatch reading;
  io::Model model = io::read(input.file, input.resources);
  const double readingTime = reading.milliseconds();
  Run run = inFile(input.file.name, [&] {
    return remeshScaled(model.parts, options, progress.part("remesh", kReadShare, 1));
  });
  model.parts = std::move(run.parts);
  const Stopwatch writing;
  io::WrittenFiles written = inFile(input.file.name, [&] { return io::write(model, outputName); });
  run.report.timings.write = writing.milliseconds();
  run.report.timings.read = readingTime;
  run.report.warnings = joined(joined(model.warnings, run.report.warnings), written.warnings);
  return {std::move(written.files), std::move(run.report)};
}

std::vector<File> convertFile(const FileBundle& input, const std::string& outputName) {
  io::requireWritable(outputName);
  const io::Model model = io::read(input.file, input.resources);
  return io::write(model, outputName).files;
}

Report inspect(const TriangleMesh& mesh) {
  Report report;
  report.input = inspectScaled({io::Part{"", mesh, {}}});
  return report;
}

Report inspectFile(const FileBundle& input) {
  Report report;
  const Stopwatch stopwatch;
  const io::Model model = io::read(input.file, input.resources);
  report.timings.read = stopwatch.milliseconds();
  report.warnings = model.warnings;
  report.input = inFile(input.file.name, [&] { return inspectScaled(model.parts); });
  return report;
}

}  // namespace remesher
