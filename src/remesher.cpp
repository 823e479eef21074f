// SPDX-License-Identifier: MIT
#include "remesher.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/legible.h"
#include "io/formats.h"
#include "io/model/levels.h"
#include "jobs/fewest_vertices.h"
#include "jobs/mending.h"
#include "jobs/part_joining.h"
#include "jobs/part_report.h"
#include "jobs/part_run.h"
#include "jobs/part_scale.h"
#include "jobs/part_targets.h"
#include "jobs/part_unions.h"
#include "jobs/result_check.h"
#include "jobs/run_guards.h"
#include "remesh/schemes/remesh.h"
#include "textures/repaint.h"

namespace remesher {
namespace {

// The approximate shares of a run's time.
constexpr double kMeasureShare = 0.15, kPaintShare = 0.4;

// All parts remeshed, and the report without reading and writing.
struct Run {
  std::vector<io::Part> parts;
  std::vector<Welding> weldings;                // of the given parts that are not remeshed yet
  std::vector<std::vector<InputPlace>> places;  // of each part's corners, where textures are baked
  Report report;
  std::size_t mirrors = 0;  // of all parts; see RemeshOutcome
};

void take(Run& run, std::size_t part, RemeshOutcome& outcome, RoundedMesh rounded) {
  if (const std::size_t count = std::max(rounded.coincident, outcome.coincident); count > 0)
    outcome.warnings.push_back({"VERTICES_COINCIDE",
                                "Vertices of the result lie where others do: parts of the surface "
                                "are nearer to each other than its coordinates can tell apart.",
                                count});
  run.parts[part].mesh = std::move(rounded.mesh);
  run.places[part] = std::move(outcome.places);
  run.report.warnings = joined(std::move(run.report.warnings), outcome.warnings);
  if (outcome.stopped != Stopped::Target) run.report.stopped = outcome.stopped;
  run.report.prefer[part] = outcome.prefer;
  run.mirrors += outcome.mirrors;
}

// Remeshes each part, and parts with coincident borders as one. Returns the last part's tree.
std::optional<ListedTree> remeshSurfaces(Run& run, const std::vector<io::Part>& originals,
                                         const RemeshOptions& options, const Progress& progress) {
  const PartUnions unions(originals, options);
  const std::vector<io::Part>& surfaces = unions.surfaces();
  const std::vector<PartPlace> places = placesOf(surfaces);
  PartTargets targets(surfaces, places, options);
  double total = 0;
  for (const io::Part& part : surfaces)
    total += double(part.mesh.triangleCount()) / (1 - kMeasureShare);
  double done = 0;
  std::optional<ListedTree> tree;
  for (const std::size_t i : targets.order()) {
    const std::vector<std::size_t>& members = unions.membersOf(i);
    const TriangleMesh& mesh = surfaces[i].mesh;
    const double share = double(mesh.triangleCount()) / total;
    Welding welding = members.size() > 1 ? Welding(mesh) : std::move(run.weldings[members.front()]);
    RemeshOutcome outcome = remeshAsShown({mesh, std::move(welding), places[i]},
                                          {targets, unions, i}, progress.part(done, done + share));
    targets.given(i, outcome.vertices);
    tree = std::move(outcome.tree);
    std::vector<RemeshOutcome> parted = unions.parted(i, std::move(outcome));
    for (std::size_t k = 0; k < parted.size(); ++k)
      take(run, members[k], parted[k],
           roundedOutcome(originals[members[k]].mesh, parted[k], options.repair));
    done += share;
  }
  return tree;
}

Run remeshParts(const std::vector<io::Part>& originals, const RemeshOptions& options,
                const Progress& progress) {
  progress.phase("inspect", 0, 0);
  Run run{{}, weldingsOf(originals), std::vector<std::vector<InputPlace>>(originals.size()), {}};
  for (const io::Part& part : originals) run.parts.push_back(withoutMesh(part));
  run.report.prefer.assign(originals.size(), Prefer::Even);
  const std::vector<PartPlace> places = placesOf(originals);
  run.report.input = inspectParts(originals, run.weldings, places);
  run.report.warnings = looseTriangles(run.report.input, originals);
  std::optional<ListedTree> tree = remeshSurfaces(run, originals, options, progress);
  progress.phase("measure", 1 - kMeasureShare, 1);
  run.report.output = inspectParts(run.parts, weldingsOf(run.parts), placesOf(run.parts));
  if (run.report.output->quads) run.report.output->quads->symmetry = run.mirrors;
  // Only the two-sided distance shows whether a bound is kept.
  const bool isGlimpsed = options.quality == Quality::Draft && !options.maxError;
  if (!originals.empty())
    run.report.fidelity =
        fidelityOf({originals, run.parts, places},
                   isGlimpsed ? Maximum::Glimpsed : Maximum::Sampled, std::move(tree));
  return run;
}

// Remeshes parts of any size, and adds the warnings on the result.
Run remeshScaled(const std::vector<io::Part>& originals, const RemeshOptions& options,
                 const Progress& progress) {
  const PartScale scale(originals);
  Run run = withinMemory([&] {
    return scale.isNeeded()
               ? remeshParts(scale.applied(originals), scale.applied(options), progress)
               : remeshParts(originals, options, progress);
  });
  if (scale.isNeeded()) run.parts = scale.undone(std::move(run.parts), originals);
  run.report.warnings =
      joined(std::move(run.report.warnings), resultWarnings(run.report, run.parts, options));
  return run;
}

// The options of a level of detail: a share of the whole's target, raised to the fewest vertices
// that the surface needs.
RemeshOptions optionsOfLod(RemeshOptions options, double share) {
  options.lods.clear();
  options.tooFew = TooFew::Raise;
  if (options.vertices)
    options.vertices = Index(std::max(1LL, std::llround(share * double(*options.vertices))));
  else if (options.edgeLength)
    *options.edgeLength /= std::sqrt(share);
  else
    options.ratio = share * options.ratio.value_or(1);
  return options;
}

// The levels of detail that were asked for, each from the original, with its own report.
std::vector<Run> remeshLods(const std::vector<io::Part>& originals, const RemeshOptions& options,
                            const Progress& progress) {
  std::vector<Run> runs;
  const double count = double(options.lods.size());
  for (const double share : options.lods) {
    PhaseClock clock;
    const double begin = double(runs.size()) / count;
    const Progress part = progress.part(begin, begin + 1 / count).timedBy(clock);
    runs.push_back(remeshScaled(originals, optionsOfLod(options, share), part));
    runs.back().report = timed(std::move(runs.back().report), clock);
  }
  return runs;
}

// All levels, the finest first: that one is remeshed with the options as given.
std::vector<Run> remeshAll(const std::vector<io::Part>& originals, const RemeshOptions& options,
                           const Progress& progress) {
  const double share = 1 / double(1 + options.lods.size());
  std::vector<Run> runs = {remeshScaled(originals, options, progress.part(0, share))};
  if (options.lods.empty()) return runs;
  progress.phase("levels of detail", share, share);
  for (Run& run : remeshLods(originals, optionsOfLevels(options, runs.front().report),
                             progress.part(share, 1))) {
    runs.front().report.lods.push_back(run.report);
    runs.push_back(std::move(run));
  }
  return runs;
}

// Baked textures need an output format with images, and exclude levels of detail.
void requireTextured(const std::string& outputName, const RemeshOptions& options) {
  if (!options.lods.empty())
    throw Error(ErrorCode::InvalidOption, "Baked textures and levels of detail exclude each other.",
                "Ask for one of them: --textures, --lods.");
  if (io::canHold(outputName, io::kHoldsImages)) return;
  throw Error(ErrorCode::Unsupported,
              "Baked textures are written as glTF only, not as " + legible(outputName) + ".",
              "Let the output's name end in .glb or .gltf.");
}

// Materials are read only from glTF and OBJ; colors of vertices from other formats, too.
void requirePaint(const io::Model& model) {
  const auto isPaint = [](const io::Part& part) {
    const auto& groups = part.groups;
    return findAttribute(part.mesh, "COLOR_0") != nullptr ||
           std::any_of(groups.begin(), groups.end(),
                       [](const io::GroupInfo& group) { return !group.look.name.empty(); });
  };
  if (model.conventions == io::Conventions::Gltf) return;
  if (std::all_of(model.parts.begin(), model.parts.end(), isPaint)) return;
  throw Error(ErrorCode::Unsupported,
              "Textures are painted from glTF files, from the materials of OBJ and from colours of "
              "vertices, and this has none.",
              "Give an OBJ with its material library, or convert it to .glb with its textures.");
}

// Requires all images that materials name; for glTF, the decoder of the images checks this.
void requireImages(const io::Model& model, const std::vector<Picture>& pictures) {
  if (model.conventions == io::Conventions::Gltf) return;
  const auto require = [&](const io::Map& map) {
    const auto isIt = [&](const Picture& picture) { return picture.name == map.image; };
    if (!map || std::any_of(pictures.begin(), pictures.end(), isIt)) return;
    throw Error(ErrorCode::MissingResource, "The image " + legible(map.image) + " was not given.",
                "Give the image with the file, or keep the textures.");
  };
  for (const io::Part& part : model.parts)
    for (const io::GroupInfo& group : part.groups)
      for (const io::Map* map :
           {&group.look.baseColorMap, &group.look.emissiveMap, &group.look.normalMap})
        require(*map);
}

std::vector<io::NamedImage> imagesFrom(std::vector<Picture> pictures) {
  std::vector<io::NamedImage> images;
  for (Picture& picture : pictures)
    images.push_back(
        {std::move(picture.name), {picture.width, picture.height, std::move(picture.texels)}});
  return images;
}

std::vector<Picture> picturesFrom(std::vector<io::PaintedImage> images) {
  std::vector<Picture> pictures;
  for (io::PaintedImage& image : images)
    pictures.push_back({std::move(image.name), std::move(image.type), image.image.width,
                        image.image.height, std::move(image.image.texels)});
  return pictures;
}

// Remeshes the model's parts and bakes textures for them.
Run remeshBaked(io::Model& model, std::vector<Picture> pictures, const RemeshOptions& options,
                const Progress& progress) {
  requirePaint(model);
  requireImages(model, pictures);
  std::erase_if(model.warnings,
                [](const Warning& w) { return w.code == "MATERIAL_IMAGES_NOT_READ"; });
  const Repaint repaint(model, imagesFrom(std::move(pictures)));
  Run run = remeshScaled(repaint.bareParts(), options, progress.part(0, 1 - kPaintShare));
  model.parts = std::move(run.parts);
  withinMemory([&] {
    repaint.paint(model, run.places, options, progress.phase("paint", 1 - kPaintShare, 1));
  });
  run.parts = std::move(model.parts);
  return run;
}

void requireRoomForLods(const std::string& outputName, const RemeshOptions& options) {
  if (options.lods.empty() || options.lodFiles || io::canHold(outputName, io::kHoldsScenes)) return;
  throw Error(ErrorCode::InvalidOption, legible(outputName) + " cannot hold levels of detail.",
              "Name the output .glb or .gltf, or ask for a file each: --lod-files, lodFiles.");
}

// The model with the finest level as its parts, which hold the coarser ones.
io::Model withLods(io::Model model, std::vector<Run>& runs) {
  model.parts = std::move(runs.front().parts);
  for (std::size_t level = 1; level < runs.size(); ++level)
    for (std::size_t i = 0; i < model.parts.size(); ++i)
      model.parts[i].lods.push_back(std::move(runs[level].parts[i].mesh));
  return model;
}

// Writes a file for each level. Files beside them, such as textures, are written once.
io::WrittenFiles writeEach(io::Model model, std::vector<Run>& runs, const std::string& outputName) {
  io::WrittenFiles all;
  std::set<std::string> names;
  for (std::size_t level = 0; level < runs.size(); ++level) {
    model.parts = std::move(runs[level].parts);
    io::WrittenFiles written = io::write(model, io::nameOfLevel(outputName, level));
    for (File& file : written.files)
      if (names.insert(file.name).second) all.files.push_back(std::move(file));
    all.warnings = joined(std::move(all.warnings), written.warnings);
  }
  return all;
}

// Reads the model and prepares its coordinates for the output format.
io::Model readFor(const std::string& outputName, const FileBundle& input) {
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  if (model.parts.empty())
    model.warnings.push_back(
        {"NOTHING_TO_REMESH", "There are no triangles: the file is passed on as it came."});
  return model;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  RemeshSceneResult run = remeshScene({{mesh, {}}}, options, progress);
  RemeshResult result{std::move(run.meshes.front()), std::move(run.report), {}};
  for (std::vector<TriangleMesh>& lod : run.lods) result.lods.push_back(std::move(lod.front()));
  return result;
}

RemeshSceneResult remeshScene(std::vector<PlacedMesh> scene, const RemeshOptions& options,
                              const Progress& progress) {
  if (options.textures == Textures::Bake)
    throw Error(ErrorCode::InvalidOption, "textures can be baked of files only.",
                "Give the file, with its images, to remeshFile.");
  PhaseClock clock;
  std::vector<io::Part> parts;
  for (PlacedMesh& placed : scene) {
    parts.push_back({"", std::move(placed.mesh), std::move(placed.places)});
    parts.back().finer = std::move(placed.finer);
  }
  parts = joinedPlaces(std::move(parts), options.weld);
  const Progress whole = progress.timedBy(clock);
  const double mended = mendShare(options);
  const Mending mending(parts, options, whole.part(0, mended));
  std::vector<Run> runs = remeshAll(parts, mending.chosen(options), whole.part(mended, 1));
  mending.note(runs.front().report);
  std::vector<std::vector<TriangleMesh>> levels;
  for (Run& run : runs) {
    levels.emplace_back();
    for (io::Part& part : run.parts) levels.back().push_back(std::move(part.mesh));
  }
  RemeshSceneResult result{
      std::move(levels.front()), timed(std::move(runs.front().report), clock), {}};
  result.lods.assign(levels.begin() + 1, levels.end());
  return result;
}

RepairResult repair(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  PhaseClock clock;
  std::vector<io::Part> parts = {io::Part{"", mesh, {}}};
  Report report = repairOnly(parts, options, progress.timedBy(clock));
  return {std::move(parts.front().mesh), timed(std::move(report), clock)};
}

RemeshFileResult remeshFile(FileBundle input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress) {
  io::requireWritable(outputName);
  if (options.textures == Textures::Bake) requireTextured(outputName, options);
  requireRoomForLods(outputName, options);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model = readFor(outputName, input);
  if (!options.lods.empty()) io::replaceLevels(model);
  std::vector<Run> runs = inFile(input.file.name, [&]() -> std::vector<Run> {
    model.parts = joinedPlaces(std::move(model.parts), options.weld);
    const double mended = kReadShare + (1 - kReadShare) * mendShare(options);
    const Mending mending(model.parts, options, whole.part(kReadShare, mended));
    const Progress body = whole.part(mended, 1);
    std::vector<Run> all;
    RemeshOptions chosen = mending.chosen(options);
    if (!input.pictures.empty() && io::canHold(outputName, io::kHoldsImages))
      chosen = mending.withPaint(std::move(chosen), model);
    if (chosen.textures == Textures::Bake)
      all.push_back(remeshBaked(model, std::move(input.pictures), chosen, body));
    else
      all = remeshAll(model.parts, chosen, body);
    mending.note(all.front().report);
    return all;
  });
  whole.phase("write", 1, 1);
  io::WrittenFiles written = inFile(input.file.name, [&] {
    return options.lodFiles ? writeEach(model, runs, outputName)
                            : io::write(withLods(model, runs), outputName);
  });
  Report report = std::move(runs.front().report);
  report.warnings = joined(joined(model.warnings, report.warnings), written.warnings);
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(report), clock)};
}

ConvertFileResult convertFile(const FileBundle& input, const std::string& outputName) {
  io::requireWritable(outputName);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  io::WrittenFiles written = io::write(model, outputName);
  return {std::move(written.files), joined(model.warnings, written.warnings)};
}

Report inspect(const TriangleMesh& mesh) {
  PhaseClock clock;
  clock.enter("inspect");
  Report report;
  const std::vector<io::Part> parts = joinedPlaces({io::Part{"", mesh, {}}}, {});
  report.input = inspectScaled(parts);
  report.warnings = looseTriangles(report.input, parts);
  return timed(std::move(report), clock);
}

Report inspectFile(const FileBundle& input) {
  PhaseClock clock;
  clock.enter("read");
  io::Model model = io::read(input.file, input.resources);
  clock.enter("inspect");
  Report report;
  report.input = inFile(input.file.name, [&] {
    model.parts = joinedPlaces(std::move(model.parts), {});
    return inspectScaled(model.parts);
  });
  report.warnings = joined(model.warnings, looseTriangles(report.input, model.parts));
  return timed(std::move(report), clock);
}

}  // namespace remesher
