// SPDX-License-Identifier: MIT
#include "remesher.h"

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/legible.h"
#include "io/formats.h"
#include "measure/hausdorff.h"
#include "parts/part_report.h"
#include "parts/part_scale.h"
#include "parts/part_targets.h"
#include "parts/precision.h"
#include "parts/result_check.h"
#include "repaint.h"
#include "schemes/remesh.h"

namespace remesher {
namespace {

// The shares of a run's time, about.
constexpr double kReadShare = 0.05;
constexpr double kMeasureShare = 0.15;

// Every part remeshed, and a report on all but reading and writing.
struct Run {
  std::vector<io::Part> parts;
  std::vector<std::vector<InputPlace>> places;  // of each part's corners, where textures are baked
  Report report;
};

// Returns the number of vertices aimed at.
std::size_t remeshPart(Run& run, std::size_t part, const RemeshOptions& options,
                       const Progress& progress) {
  io::Part& own = run.parts[part];
  RemeshOutcome outcome = remeshSurface(own.mesh, options, progress);
  RoundedMesh rounded = inPrecisionOf(own.mesh, std::move(outcome.mesh));
  if (rounded.coincident > 0)
    outcome.warnings.push_back({"VERTICES_COINCIDE",
                                "Vertices of the result lie where others do: parts of the surface "
                                "are nearer to each other than coordinates of single precision, as "
                                "they were given, can tell apart.",
                                rounded.coincident});
  own.mesh = std::move(rounded.mesh);
  run.places[part] = std::move(outcome.places);
  run.report.warnings = joined(std::move(run.report.warnings), outcome.warnings);
  if (outcome.stopped != Stopped::Target) run.report.stopped = outcome.stopped;
  return outcome.target;
}

Run remeshParts(const std::vector<io::Part>& originals, const RemeshOptions& options,
                const Progress& progress) {
  Run run{originals, std::vector<std::vector<InputPlace>>(originals.size()), {}};
  progress.phase("inspect", 0, 0);
  run.report.input = inspectParts(originals);
  PartTargets targets(originals, options);
  const double total = double(run.report.input.triangles) / (1 - kMeasureShare);
  double done = 0;
  for (const std::size_t i : targets.order()) {
    const double share = double(originals[i].mesh.triangleCount()) / total;
    const Progress part = progress.part(done, done + share);
    targets.given(i, remeshPart(run, i, targets.of(i), part));
    done += share;
  }
  progress.phase("measure", 1 - kMeasureShare, 1);
  run.report.output = inspectParts(run.parts);
  if (!originals.empty())
    run.report.fidelity =
        measureFidelity(gathered(originals), gathered(run.parts),
                        options.quality == Quality::Draft ? Maximum::Glimpsed : Maximum::Sampled);
  return run;
}

// What the machine cannot hold is said like everything else; all that was held is free again.
template <class Body>
auto withinMemory(Body body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  throw Error(ErrorCode::OutOfMemory, "The run needs more memory than there is.",
              "Ask for fewer vertices, or give the model in parts.");
}

// The same for parts of any size.
Run remeshScaled(const std::vector<io::Part>& originals, const RemeshOptions& options,
                 const Progress& progress) {
  const PartScale scale(originals);
  const bool isScaled = scale.isNeeded();
  Run run = withinMemory([&] {
    return isScaled ? remeshParts(scale.applied(originals), scale.applied(options), progress)
                    : remeshParts(originals, options, progress);
  });
  if (isScaled) run.parts = scale.undone(std::move(run.parts), originals);
  run.report.warnings = joined(std::move(run.report.warnings),
                               worseThanGiven({run.report.input, *run.report.output}, run.parts));
  return run;
}

MeshReport inspectScaled(const std::vector<io::Part>& parts) {
  const PartScale scale(parts);
  return inspectParts(scale.isNeeded() ? scale.applied(parts) : parts);
}

Report timed(Report report, PhaseClock& clock) {
  report.phases = clock.finish();
  report.timings = timingsOf(report.phases);
  return report;
}

// Errors that speak of a vertex or a triangle alone do not say of which file.
template <class Body>
auto inFile(const std::string& name, Body body) {
  try {
    return body();
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool saysWhere = name.empty() || message.find(legible(name)) != std::string::npos;
    if (error.code == ErrorCode::Cancelled || saysWhere) throw;
    throw Error(error.code, legible(name) + ": " + message, error.hint);
  }
}

constexpr double kPaintShare = 0.4;

// Textures can only be painted with what formats say that have materials.
void requireTextured(const std::string& outputName) {
  const std::string extension =
      outputName.substr(std::min(outputName.rfind('.'), outputName.size()));
  if (extension == ".glb" || extension == ".gltf") return;
  throw Error(ErrorCode::Unsupported,
              "Baked textures are written as glTF only, not as " + legible(outputName) + ".",
              "Let the output's name end in .glb or .gltf.");
}

std::vector<io::NamedImage> imagesFrom(const std::vector<Picture>& pictures) {
  std::vector<io::NamedImage> images;
  for (const Picture& picture : pictures)
    images.push_back({picture.name, {picture.width, picture.height, picture.texels}});
  return images;
}

std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images) {
  std::vector<Picture> pictures;
  for (io::PaintedImage& image : images)
    pictures.push_back({std::move(image.name), std::move(image.type), image.image.width,
                        image.image.height, std::move(image.image.texels)});
  return pictures;
}

// The model's parts remeshed, and its textures baked if that is asked for.
Run remeshModel(io::Model& model, const std::vector<Picture>& pictures,
                const RemeshOptions& options, const Progress& progress) {
  if (options.textures == Textures::Keep) {
    Run run = remeshScaled(model.parts, options, progress);
    model.parts = std::move(run.parts);
    return run;
  }
  if (model.conventions != io::Conventions::Gltf)
    throw Error(ErrorCode::Unsupported, "Textures are baked of glTF files only.",
                "Convert the file to .glb first.");
  const Repaint repaint(model, imagesFrom(pictures));
  Run run = remeshScaled(repaint.bareParts(), options, progress.part(0, 1 - kPaintShare));
  model.parts = std::move(run.parts);
  withinMemory([&] {
    repaint.paint(model, run.places, options, progress.phase("paint", 1 - kPaintShare, 1));
  });
  return run;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  RemeshSceneResult run = remeshScene({{mesh, {}}}, options, progress);
  return {std::move(run.meshes.front()), std::move(run.report)};
}

RemeshSceneResult remeshScene(const std::vector<PlacedMesh>& scene, const RemeshOptions& options,
                              const Progress& progress) {
  if (options.textures == Textures::Bake)
    throw Error(ErrorCode::InvalidOption, "textures can be baked of files only.",
                "Give the file, with its images, to remeshFile.");
  PhaseClock clock;
  std::vector<io::Part> parts;
  for (const auto& [mesh, places] : scene) parts.push_back({"", mesh, places});
  Run run = remeshScaled(parts, options, progress.timedBy(clock));
  RemeshSceneResult result;
  for (io::Part& part : run.parts) result.meshes.push_back(std::move(part.mesh));
  result.report = timed(std::move(run.report), clock);
  return result;
}

RemeshFileResult remeshFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  if (options.textures == Textures::Bake) requireTextured(outputName);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = io::read(input.file, input.resources);
  Run run = inFile(input.file.name, [&] {
    return remeshModel(model, input.pictures, options, whole.part(kReadShare, 1));
  });
  whole.phase("write", 1, 1);
  io::WrittenFiles written = inFile(input.file.name, [&] { return io::write(model, outputName); });
  run.report.warnings = joined(joined(model.warnings, run.report.warnings), written.warnings);
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(run.report), clock)};
}

ConvertFileResult convertFile(const FileBundle& input, const std::string& outputName) {
  io::requireWritable(outputName);
  const io::Model model = io::read(input.file, input.resources);
  io::WrittenFiles written = io::write(model, outputName);
  return {std::move(written.files), joined(model.warnings, written.warnings)};
}

Report inspect(const TriangleMesh& mesh) {
  PhaseClock clock;
  clock.enter("inspect");
  Report report;
  report.input = inspectScaled({io::Part{"", mesh, {}}});
  return timed(std::move(report), clock);
}

Report inspectFile(const FileBundle& input) {
  PhaseClock clock;
  clock.enter("read");
  const io::Model model = io::read(input.file, input.resources);
  clock.enter("inspect");
  Report report;
  report.warnings = model.warnings;
  report.input = inFile(input.file.name, [&] { return inspectScaled(model.parts); });
  return timed(std::move(report), clock);
}

}  // namespace remesher
