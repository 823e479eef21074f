// SPDX-License-Identifier: MIT
// Repairs a file without remeshing it.
#include <cctype>
#include <string>
#include <utility>

#include "io/formats.h"
#include "io/model/byte_reader.h"
#include "io/model/same_mesh.h"
#include "jobs/baking.h"
#include "jobs/mending.h"
#include "jobs/parts/bare_materials.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "jobs/scene_run.h"
#include "remesher.h"

namespace remesher {

namespace {

std::string extensionOf(const std::string& name) {
  std::string extension = name.substr(name.find_last_of('.') + 1);
  for (char& letter : extension) letter = char(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

// Whether the input file, unchanged, can be the result: in the same format, without files beside
// it, and with nothing mended in reading.
bool mayStay(const FileBundle& input, const std::string& outputName, const io::Model& model) {
  return extensionOf(input.file.name) == extensionOf(outputName) && input.resources.empty() &&
         !io::isMended(model.warnings);
}

}  // namespace

RemeshFileResult repairFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& asked, const Progress& progress) {
  io::requireWritable(outputName);
  constexpr double kBeforePainting = 0.6;  // the share of a run that paints
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  if (asked.textures == Textures::Bake) requireTextured(outputName);
  io::Model model = io::read(input.file, input.resources);
  io::prepare(model, outputName);
  const PartOptions options = withPercents(asked, model.parts);
  if (options.textures == Textures::Drop) dropTextures(model);
  if (options.unite)
    io::uniteAll(model, outputName);
  else
    io::unite(model, outputName);
  model.isExact = true;  // text keeps all digits: rounded, the surface could intersect itself
  const bool stays = mayStay(input, outputName, model);
  const IfSound ifSound = stays ? IfSound::FileStays : IfSound::IsRounded;
  const bool mayPaint = !input.pictures.empty() && io::canHold(outputName, io::kHoldsImages);
  const Progress own = whole.part(kReadShare, mayPaint ? kBeforePainting : 1);
  RepairedParts repaired = inFile(input.file.name, [&] {
    return repairOnly(model.parts, heldIn(outputName), ifSound, options, own);
  });
  model.leftOut = repaired.leftOut;
  model.polygons += repaired.quadsCut;
  Report& report = repaired.report;
  const PartOptions painting =
      repaired.isRemade && mayPaint ? chooseBaking(options, model) : options;
  if (painting.textures == Textures::Bake)
    inFile(input.file.name, [&] {
      paintRepaired(model, {{}, input.pictures}, painting, whole.part(kBeforePainting, 1));
    });
  whole.phase("write", 1, 1);
  const bool keepsLook = painting.textures == Textures::Auto || painting.textures == Textures::Keep;
  if (keepsLook && repaired.isUnchanged && stays) {
    report.warnings = mergedByCode(io::saidOfWhole(model.warnings), report.warnings);
    return {{{outputName, io::whole(input.file).bytes}}, {}, timed(std::move(report), clock)};
  }
  io::WrittenFiles written = inFile(input.file.name, [&] { return io::write(model, outputName); });
  if (written.isUntouched) model.warnings = io::saidOfWhole(std::move(model.warnings));
  report.warnings = mergedByCode(mergedByCode(model.warnings, report.warnings), written.warnings);
  if (!repaired.isRemade)
    report.warnings = mergedByCode(report.warnings, io::polygonsCut(model, written));
  return {std::move(written.files), picturesFrom(std::move(written.images)),
          timed(std::move(report), clock)};
}

}  // namespace remesher
