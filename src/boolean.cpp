// SPDX-License-Identifier: MIT
// Booleans of two meshes, or of the bodies of two files.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/legible.h"
#include "io/formats.h"
#include "io/model/bake.h"
#include "io/model/near_origin.h"
#include "io/model/units.h"
#include "jobs/operands.h"
#include "jobs/part_boolean.h"
#include "jobs/parts/bare_materials.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "remesher.h"

namespace remesher {

namespace {

bool holds(const std::string& outputName, io::Holds what) { return io::canHold(outputName, what); }

io::Conventions conventionsOf(const std::string& outputName) {
  return holds(outputName, io::kHoldsImages) ? io::Conventions::Gltf : io::Conventions::Classic;
}

// Sets the model's unit to the operand's, if that is the first that has one; else brings the
// operand to the model's.
void settleUnit(const std::string& unit, GivenOperand& operand, io::Model& model) {
  const double metres = io::metresIn(unit), whole = io::metresIn(io::unitOf(model));
  if (metres == 0 || metres == whole) return;
  if (whole == 0) {
    model.unit = unit;
    return;
  }
  for (io::Part& part : operand.parts) {
    for (Vec3& p : part.mesh.positions) p *= metres / whole;
    part.mesh.isSingle = false;
  }
}

// The file's parts at their places, as the output's format understands their attributes, in the
// unit of the model that they are to be part of.
GivenOperand readOperand(const FileBundle& input, const std::string& outputName, io::Model& whole) {
  io::Model model = io::read(input.file, input.resources);
  io::makeBodies(model);
  if (model.parts.empty())
    throw Error(ErrorCode::NoTriangles, legible(input.file.name) + " has no triangles.");
  for (io::Part& part : model.parts)
    part.mesh = io::converted(std::move(part.mesh), model.conventions, conventionsOf(outputName));
  whole.warnings = mergedByCode(std::move(whole.warnings), model.warnings);
  GivenOperand operand{legible(input.file.name), std::move(model.parts)};
  settleUnit(io::unitOf(model), operand, whole);
  return operand;
}

// Where the result is shown. In single precision it is made near the origin if it is far away.
Transform placeOf(OperandPair& pair, const std::string& outputName) {
  io::Part both{
      "", joinedOperands(pair.parts[0].mesh, pair.parts[1].mesh), {Transform::Identity()}};
  if (both.mesh.isSingle || !holds(outputName, io::kHoldsScenes) || !io::isFarFromOrigin(both.mesh))
    return Transform::Identity();
  io::moveToOrigin(both);
  const Vec3 origin = both.instances.front().translation();
  for (io::Part& part : pair.parts)
    for (Vec3& p : part.mesh.positions) p -= origin;
  return both.instances.front();
}

// Whether the operands' coordinates will be written in single precision.
bool becomeSingle(const OperandPair& pair, const std::string& outputName) {
  io::Model model;
  model.parts.assign(pair.parts.begin(), pair.parts.end());
  io::prepare(model, outputName);
  return std::all_of(model.parts.begin(), model.parts.end(),
                     [](const io::Part& part) { return part.mesh.isSingle; });
}

// Coordinates that will be written in single precision are rounded before anything is cut.
void roundFor(const std::string& outputName, OperandPair& pair) {
  if (!becomeSingle(pair, outputName)) return;
  for (io::Part& part : pair.parts) {
    for (Vec3& p : part.mesh.positions) p = inSingle(p, {});
    part.mesh.isSingle = true;
  }
}

// Writes the materials of both files anew in glTF: colours and factors.
void nameMaterials(io::Model& model, const std::string& outputName) {
  if (!holds(outputName, io::kHoldsImages)) return;
  std::size_t images = 0;
  for (io::GroupInfo& group : model.parts.front().groups) {
    if (group.material.empty()) continue;
    images += hasImages(group.look);
    group.painted = int(numberOf(withoutImages(group.look, group.material), model.paintings));
  }
  if (images > 0)
    model.warnings.push_back({"MATERIAL_IMAGES_NOT_READ",
                              "The images of the materials are not passed on: a Boolean keeps "
                              "their colours and factors only.",
                              images});
}

Carried carriedBy(const std::string& outputName) {
  return holds(outputName, io::kHoldsParts) ? Carried::Scene : Carried::Solid;
}

}  // namespace

BooleanResult boolean(const TriangleMesh& a, const TriangleMesh& b, BooleanOperation operation,
                      const Progress& progress) {
  PhaseClock clock;
  std::vector<io::Part> parts = {io::Part{"", a, {}}, io::Part{"", b, {}}};
  const std::vector<Warning> settled = settleAttributes(parts);
  OperandPair pair = pairOf({GivenOperand{"The first operand", {parts[0]}},
                             GivenOperand{"The second operand", {parts[1]}}},
                            Carried::Arrays);
  BooleanRun run = runBoolean(std::move(pair), operation, progress.timedBy(clock));
  run.report.warnings = mergedByCode(settled, run.report.warnings);
  return {std::move(run.part.mesh), timed(std::move(run.report), clock), run.boolean};
}

BooleanFilesResult booleanFiles(const FileBundle& a, const FileBundle& b,
                                BooleanOperation operation, const std::string& outputName,
                                const Progress& progress) {
  io::requireWritable(outputName);
  PhaseClock clock;
  const Progress whole = progress.timedBy(clock);
  whole.phase("read", 0, kReadShare);
  io::Model model;
  model.conventions = io::Conventions::Classic;  // of no unit, until an operand has one
  model.isExact = true;  // the result must not intersect itself for any reader
  std::array<GivenOperand, 2> given = {readOperand(a, outputName, model),
                                       readOperand(b, outputName, model)};
  model.conventions = conventionsOf(outputName);
  OperandPair pair = pairOf(given, carriedBy(outputName));
  const Transform place = placeOf(pair, outputName);
  roundFor(outputName, pair);
  BooleanRun run = runBoolean(std::move(pair), operation, whole.part(kReadShare, 1));
  run.part.instances = {place};
  model.parts.push_back(std::move(run.part));
  nameMaterials(model, outputName);
  whole.phase("write", 1, 1);
  io::WrittenFiles written = io::write(model, outputName);
  run.report.warnings =
      mergedByCode(mergedByCode(model.warnings, run.report.warnings), written.warnings);
  return {std::move(written.files), timed(std::move(run.report), clock), run.boolean};
}

}  // namespace remesher
