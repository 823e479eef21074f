// SPDX-License-Identifier: MIT
// Bakes one mesh onto another, and gives meshes new texture coordinates: of arrays and of files.
#include <string>
#include <utility>
#include <vector>

#include "base/legible.h"
#include "io/formats.h"
#include "jobs/bake_run.h"
#include "jobs/baking.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "remesher.h"

namespace remesher {

namespace {

io::Model modelOf(const TriangleMesh& mesh) {
  io::Model model;
  model.parts.push_back({"", mesh, {Transform::Identity()}});
  model.warnings = settleAttributes(model.parts);
  return model;
}

void requireTexcoords(const std::string& outputName) {
  if (io::canHold(outputName, io::kHoldsTexcoords)) return;
  throw Error(ErrorCode::Unsupported,
              "Texture coordinates cannot be written to " + legible(outputName) + ".",
              "Let the output's name end in .glb, .gltf, .obj, .ply or .off.");
}

}  // namespace

BakeResult bake(const TriangleMesh& high, const TriangleMesh& low, const RemeshOptions& options,
                const Progress& progress) {
  PhaseClock clock;
  io::Model model = modelOf(low);
  Report report = runBake({modelOf(high), {}}, model, options, progress.timedBy(clock));
  report.warnings = mergedByCode(report.warnings, model.warnings);
  std::vector<Picture> maps = picturesFrom(std::move(model.images));
  return {std::move(model.parts.front().mesh), std::move(maps), timed(std::move(report), clock)};
}

RemeshFileResult bakeFiles(FileBundle high, const FileBundle& low, const std::string& outputName,
                           const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  requireTextured(outputName);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model source = io::read(high.file, high.resources);
  io::Model model = io::read(low.file, low.resources);
  io::prepare(model, outputName);
  Report report = inFile(high.file.name, [&] {
    return runBake({std::move(source), std::move(high.pictures)}, model, options,
                   whole.part(kReadShare, 1));
  });
  whole.phase("write", 1, 1);
  io::WrittenFiles written = io::write(model, outputName);
  report.warnings = mergedByCode(mergedByCode(report.warnings, model.warnings), written.warnings);
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(report), clock)};
}

UnwrapResult unwrap(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  PhaseClock clock;
  io::Model model = modelOf(mesh);
  Report report = runUnwrap(model, options, progress.timedBy(clock));
  report.warnings = mergedByCode(report.warnings, model.warnings);
  return {std::move(model.parts.front().mesh), timed(std::move(report), clock)};
}

RemeshFileResult unwrapFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  requireTexcoords(outputName);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  Report report =
      inFile(input.file.name, [&] { return runUnwrap(model, options, whole.part(kReadShare, 1)); });
  whole.phase("write", 1, 1);
  io::WrittenFiles written = io::write(model, outputName);
  const std::vector<Warning> lost = mergedByCode(written.warnings, io::polygonsCut(model, written));
  report.warnings = mergedByCode(mergedByCode(report.warnings, model.warnings), lost);
  return {std::move(written.files), {}, timed(std::move(report), clock)};
}

}  // namespace remesher
