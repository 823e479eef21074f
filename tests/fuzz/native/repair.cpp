// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "io/formats.h"
#include "laws.h"
#include "remesher.h"
#include "small_mesh.h"
#include "targets.h"

namespace remesher::fuzz {
namespace {

// Limits that keep a run well below a second under sanitizers.
constexpr std::size_t kMostGiven = 48;
constexpr unsigned kMaterials = 5;
constexpr float kSteps = 16;

constexpr std::array kRepairs = {Repair::Auto, Repair::Holes, Repair::Solid, Repair::Wrap};
constexpr std::array kGiven = {"a.obj", "a.ply", "a.glb", "a.off", "a.stl"};
constexpr std::array kAskedFor = {"b.obj", "b.ply", "b.glb", "b.off", "b.stl"};

RemeshOptions takeOptions(ByteSource& bytes) {
  RemeshOptions options;
  options.repair = kRepairs[bytes.byte() % kRepairs.size()];
  const unsigned flags = bytes.byte();
  if (flags & 1) options.cavities = true;
  if (flags & 2) options.sheets = Sheets::Drop;
  if (flags & 4) options.holesUpTo = flags / 4.0;
  if (flags & 8) options.gap = flags / 32.0;
  if (flags & 16) options.weld = flags / 64.0;
  return options;
}

// Numbers by the places of vertices and triangles in their lists: groups, colours, texture
// coordinates and normals, from 0 to 1.
void addTo(TriangleMesh& mesh, unsigned extras) {
  if (extras & 1)
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
      mesh.groups.push_back(Index(t * 7 % kMaterials));
  const std::size_t vertices = mesh.positions.size();
  const auto add = [&](const char* semantic, int width) {
    Attribute attribute{semantic, width, {}};
    for (std::size_t i = 0; i < vertices * std::size_t(width); ++i)
      attribute.values.push_back(float(i * 5 % std::size_t(kSteps)) / kSteps);
    mesh.attributes.push_back(std::move(attribute));
  };
  if (extras & 2) add("COLOR_0", 4);
  if (extras & 4) add("TEXCOORD_0", 2);
  if (extras & 8) add("NORMAL", 3);
}

// What repair has made: its groups are the input's, its values no wilder than those.
void judge(const TriangleMesh& made, const TriangleMesh& input, const Report& report) {
  constexpr float kLargest = 100;
  requireWhole(made);
  require(made.groups.empty() == (input.groups.empty() || made.indices.empty()),
          "groups stay where there are some");
  const bool areKnown = std::all_of(made.groups.begin(), made.groups.end(),
                                    [&](Index group) { return group < kMaterials; });
  require(areKnown, "groups are those of the input");
  for (const Attribute& attribute : made.attributes)
    require(std::all_of(attribute.values.begin(), attribute.values.end(),
                        [&](float x) { return std::abs(x) < kLargest; }),
            "values are made of those of the input");
  require(report.output->triangles == made.triangleCount(), "the report counts the triangles");
}

// The mesh as a file that names its groups.
FileBundle fileOf(const TriangleMesh& mesh, const std::string& name) {
  io::Model model;
  io::Part part{"part", mesh, {Transform::Identity()}};
  for (Index g = 0; !mesh.groups.empty() && g < kMaterials; ++g)
    part.groups.push_back({"group " + std::to_string(g), {}});
  model.parts.push_back(std::move(part));
  io::WrittenFiles written = io::write(model, name);
  FileBundle bundle{std::move(written.files.front()), {}};
  bundle.resources.assign(written.files.begin() + 1, written.files.end());
  return bundle;
}

// Any group that a written file names is one of those above.
void requireNamed(const File& file) {
  const io::Model model = io::read(file);
  for (const io::Part& part : model.parts)
    for (const io::GroupInfo& group : part.groups)
      require(group.material.empty() || group.material.starts_with("group ") ||
                  file.name.ends_with(".stl"),
              "materials are those of the input");
}

}  // namespace

void repairSmallMesh(Input input) {
  ByteSource bytes(input);
  const RemeshOptions options = takeOptions(bytes);
  const unsigned extras = bytes.byte(), given = bytes.byte(), askedFor = bytes.byte();
  TriangleMesh mesh = takeMesh(bytes, kMostGiven);
  addTo(mesh, extras);
  try {
    const RepairResult result = repair(mesh, options);
    judge(result.mesh, mesh, result.report);
    const FileBundle file = fileOf(mesh, kGiven[given % kGiven.size()]);
    requireNamed(repairFile(file, kAskedFor[askedFor % kAskedFor.size()], options).files.front());
  } catch (const Error& error) {
    requireSentence(error);
  }
}

}  // namespace remesher::fuzz
