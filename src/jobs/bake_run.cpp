// SPDX-License-Identifier: MIT
#include "jobs/bake_run.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "io/model/appending.h"
#include "io/model/bake.h"
#include "jobs/baking.h"
#include "jobs/checks/repair_room.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/bare_materials.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "textures/bake_onto.h"
#include "textures/new_texcoords.h"

namespace remesher {

namespace {

// The shares of a run's time.
constexpr double kInspected = 0.05, kPainted = 0.95;
// Of the square for new texture coordinates, if no size is given: it only sets how far charts stay
// apart.
constexpr Index kSquare = 1024;

// All that a model shows, in the world, as one mesh with the materials of all its parts.
io::Part shownAsOne(io::Model& model) {
  io::makeBodies(model);
  io::Part one{"", {}, {Transform::Identity()}};
  for (io::Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    requireValid(part.mesh);
    const TriangleMesh mesh =
        io::converted(std::move(part.mesh), model.conventions, io::Conventions::Gltf);
    appendGroups(one.mesh.groups, mesh, Index(one.groups.size()));
    appendMesh(one.mesh, mesh);
    part.groups.resize(groupCount(mesh));
    one.groups.insert(one.groups.end(), part.groups.begin(), part.groups.end());
  }
  if (one.mesh.indices.empty())
    throw Error(ErrorCode::NoTriangles, "There are no triangles to bake from.");
  return one;
}

// The shown surface in the space of each part; parts at the same place share it.
BakeOriginals originalsFor(const std::vector<io::Part>& parts, const io::Part& shown) {
  BakeOriginals from{{}, {}, {}, Unshaded::Flat};
  std::vector<Transform> places;
  for (const io::Part& part : parts) {
    const Transform place = firstPlace(part);
    const auto isIt = [&](const Transform& known) { return known.matrix() == place.matrix(); };
    const auto found = std::find_if(places.begin(), places.end(), isIt);
    from.originalOf.push_back(Index(found - places.begin()));
    if (found != places.end()) continue;
    places.push_back(place);
    from.originals.push_back(shown);
    if (place.matrix() == Eigen::Matrix4d::Identity()) continue;
    if (!(std::abs(place.linear().determinant()) > 0))
      throw Error(ErrorCode::InvalidMesh,
                  "A mesh of the file to bake onto is shown flattened, where nothing can be found.",
                  "Give its node a scale that is not 0.");
    io::transformMesh(from.originals.back().mesh, place.inverse());
  }
  return from;
}

void requireParts(const io::Model& model, const char* what) {
  if (model.parts.empty())
    throw Error(ErrorCode::NoTriangles, std::string("There are no triangles to ") + what + ".");
  for (const io::Part& part : model.parts) requireValid(part.mesh);
}

double trianglesOf(const std::vector<io::Part>& parts) {
  double count = 0;
  for (const io::Part& part : parts) count += double(part.mesh.triangleCount());
  return count;
}

void eraseWarning(std::vector<Warning>& warnings, const char* code) {
  std::erase_if(warnings, [&](const Warning& warning) { return warning.code == code; });
}

}  // namespace

Report runBake(BakeSource high, io::Model& low, const RemeshOptions& options,
               const Progress& progress) {
  Report report;
  progress.phase("inspect", 0, kInspected);
  requireParts(low, "bake onto");
  const double shownFrom = trianglesOf(high.model.parts), onto = trianglesOf(low.parts);
  requireRoomForTwo({shownFrom + onto, kBakeBytes * shownFrom + kUnwrapBytes * onto}, "bake");
  report.input = inspectScaled(low.parts);
  requireImages(high.model, high.pictures);
  const Unshaded unshaded =
      high.model.conventions == io::Conventions::Gltf ? Unshaded::Flat : Unshaded::Smooth;
  const io::Part shown = shownAsOne(high.model);
  for (io::Part& part : low.parts)
    part.mesh = io::converted(std::move(part.mesh), low.conventions, io::Conventions::Gltf);
  low.conventions = io::Conventions::Gltf;
  for (io::Model* model : {&high.model, &low})
    eraseWarning(model->warnings, "MATERIAL_IMAGES_NOT_READ");
  BakeOriginals from = originalsFor(low.parts, shown);
  from.images = imagesFrom(std::move(high.pictures));
  from.unshaded = unshaded;
  report.atlas = withinMemory(
      [&] { return bakeOnto(low, from, options, progress.phase("paint", kInspected, kPainted)); });
  progress.phase("measure", kPainted, 1);
  report.output = inspectScaled(low.parts);
  report.warnings = high.model.warnings;
  return report;
}

void requireRoomToUnwrap(const std::vector<io::Part>& parts, double addresses) {
  const double triangles = trianglesOf(parts);
  const RoomNeeds needs = {triangles, kUnwrapBytes * triangles};
  if (haveRoom(needs, addresses)) return;
  refuseSize(needs, "unwrap", "Remesh it to fewer vertices first, or give it in parts.", addresses);
}

Report runUnwrap(io::Model& model, const RemeshOptions& options, const Progress& progress) {
  Report report;
  progress.phase("inspect", 0, kInspected);
  requireParts(model, "unwrap");
  requireRoomToUnwrap(model.parts);
  report.input = inspectScaled(model.parts);
  std::size_t imaged = 0;
  for (const io::Part& part : model.parts)
    for (const io::GroupInfo& group : part.groups) imaged += hasImages(group.look);
  dropTextures(model);
  if (imaged > 0)
    model.warnings.push_back({"IMAGES_NOT_FITTING",
                              "The images of the materials are left out: they do not fit the new "
                              "texture coordinates. Bake the file onto the result to have them.",
                              imaged});
  progress.phase("unwrap", kInspected, kPainted);
  report.atlas =
      withinMemory([&] { return unwrapParts(model.parts, options.textureSize.value_or(kSquare)); });
  model.hasNewTexcoords = true;
  for (io::Part& part : model.parts)
    for (io::GroupInfo& group : part.groups) std::erase(group.lacks, "TEXCOORD_0");
  if (model.conventions == io::Conventions::Classic)
    for (io::Part& part : model.parts)
      for (Attribute& attribute : part.mesh.attributes)
        if (attribute.semantic == "TEXCOORD_0")
          for (std::size_t i = 1; i < attribute.values.size(); i += 2)
            attribute.values[i] = 1 - attribute.values[i];
  progress.phase("measure", kPainted, 1);
  report.output = inspectScaled(model.parts);
  return report;
}

}  // namespace remesher
