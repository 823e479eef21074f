// SPDX-License-Identifier: MIT
#include "jobs/part_boolean.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "jobs/checks/precision.h"
#include "jobs/checks/result_check.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/part_frames.h"
#include "jobs/parts/part_joining.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_report.h"
#include "jobs/repair_words.h"
#include "jobs/run_guards.h"
#include "measure/self_intersections.h"
#include "repair/boolean.h"

namespace remesher {

namespace {

// The operands at about unit size, both in the same way.
class Scaled {
 public:
  explicit Scaled(const OperandPair& pair)
      : joint_{"", joinedOperands(pair.parts[0].mesh, pair.parts[1].mesh), {Transform::Identity()}},
        scale_({joint_}, FrameRounding::None) {}

  io::Part applied(const io::Part& part) const {
    return scale_.isNeeded() ? scale_.applied({part}).front() : part;
  }
  io::Part undone(io::Part part) const {
    if (scale_.isNeeded()) part = scale_.undone({std::move(part)}, {joint_}).front();
    part.mesh = inPrecisionOf(joint_.mesh, std::move(part.mesh)).mesh;
    return part;
  }
  Vec3 inWorld(const io::Part& applied, const Vec3& p) const {
    return scale_.isNeeded() ? scale_.inWorld(applied, p) : p;
  }

 private:
  io::Part joint_;
  PartFrames scale_;
};

bool isPowerOfTwo(double x) {
  constexpr double kFraction = 0.5;
  int exponent = 0;
  return std::frexp(x, &exponent) == kFraction;
}

// Whether the written mesh is the scaled one but for a move and a power of two, without rounding:
// then the same triangles intersect.
bool isUnrounded(const TriangleMesh& scaled, const TriangleMesh& written) {
  const Frame& frame = scaled.frame;
  if (frame.parts != 1 || !isPowerOfTwo(frame.shared) || scaled.indices != written.indices)
    return false;
  const double unit = frame.unit / frame.shared;
  for (std::size_t v = 0; v < scaled.positions.size(); ++v)
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double steps = written.positions[v][k] / frame.step, middle = frame.middle[k],
                   moved = scaled.positions[v][k] / unit;
      // A sum of doubles that is undone by both differences has no rounding.
      if (moved + middle != steps || steps - moved != middle || steps - middle != moved)
        return false;
    }
  return true;
}

// Measured at about unit size; diagonal: as written.
MeshReport inspected(const std::vector<io::Part>& scaled, double diagonal) {
  MeshReport report = PlainInspection(scaled).report;
  report.diagonal = diagonal;
  return report;
}

[[noreturn]] void refuseOperand(const OperandPair& pair, std::size_t i, const io::Part& part,
                                const Scaled& scaled) {
  const std::vector<Vec3> open = openPieces(part.mesh);
  std::string message = pair.names[i] + " is no closed body";
  if (open.empty())
    message += ": it intersects itself in ways that cannot be cut exactly.";
  else
    message += (open.size() == 1 ? ": it has a sheet or a large opening near ("
                                 : ": it has " + std::to_string(open.size()) +
                                       " sheets or large openings, the first near (") +
               placeInWords(scaled.inWorld(part, open.front()), {pair.parts[i]}) + ").";
  throw Error(ErrorCode::InvalidMesh, message,
              "Make a body of it first: repair it with --repair wrap, say.");
}

[[noreturn]] void refuseEmpty(BooleanOperation operation) {
  if (operation == BooleanOperation::Subtract)
    throw Error(ErrorCode::NoTriangles,
                "Nothing is left: all of the first operand lies in the second.",
                "Were the operands exchanged?");
  if (operation == BooleanOperation::Intersect)
    throw Error(ErrorCode::NoTriangles, "Nothing is left: the operands have no volume in common.",
                "Are they at the same place, and in the same units?");
  throw Error(ErrorCode::NoTriangles, "Nothing is left: the operands have no volume.");
}

// The repair of both operands.
class OperandRepairs {
 public:
  void note(const RepairedMesh& repaired, double share) {
    const bool isLarger = report_.reason.empty() || report_.reason == "sound";
    add(report_, repaired.report);
    report_.lost += share * repaired.report.lost;
    if (isLarger) {
      report_.mode = repaired.report.mode;
      report_.reason = repaired.report.reason;
    }
    for (const PlacedWarning& warning : repaired.warnings) join(warnings_, warning);
  }

  void tell(Report& report, const OperandPair& pair) const {
    if (report_.reason != "sound") report.repair = report_;
    report.warnings =
        mergedByCode(pair.warnings, inWords(warnings_, {pair.parts.begin(), pair.parts.end()}));
  }

 private:
  RepairReport report_;
  std::vector<PlacedWarning> warnings_;
};

struct Bodies {
  std::array<TriangleMesh, 2> meshes;  // closed, scaled
  OperandRepairs repairs;
  Each each = Each::Sound;
};

// parts: those of the pair, scaled.
Bodies bodiesOf(const OperandPair& pair, const std::vector<io::Part>& parts, const Scaled& scaled) {
  Bodies bodies;
  const double all =
      double(pair.parts[0].mesh.triangleCount() + pair.parts[1].mesh.triangleCount());
  for (std::size_t i = 0; i < 2; ++i) {
    const io::Part& part = parts[i];
    std::optional<RepairedMesh> repaired = exactBodies(part.mesh);
    if (!repaired) refuseOperand(pair, i, part, scaled);
    for (PlacedWarning& warning : repaired->warnings)
      if (warning.at) warning.at = scaled.inWorld(part, *warning.at);
    bodies.meshes[i] = std::move(repaired->mesh);
    if (repaired->report.selfIntersections[1] > 0) bodies.each = Each::MayIntersectItself;
    bodies.repairs.note(*repaired, double(part.mesh.triangleCount()) / all);
  }
  return bodies;
}

United arrangedOf(const OperandPair& pair, const Bodies& bodies, BooleanOperation operation) {
  const auto& [a, b] = bodies.meshes;
  std::optional<United> found =
      booleanOf(joinedOperands(a, b), a.triangleCount(), operation, bodies.each);
  if (!found)
    throw Error(ErrorCode::Unsupported,
                pair.names[0] + " and " + pair.names[1] +
                    " cannot be cut along each other: too many of their triangles meet.",
                "Simplify them first.");
  if (found->mesh.indices.empty()) refuseEmpty(operation);
  return std::move(*found);
}

// Bodies that touch share edges or vertices, which not every reader takes.
void sayTouching(BooleanRun& run) {
  const BeforeAndAfter reports{run.report.input, *run.report.output};
  std::vector<Warning>& warnings = run.report.warnings;
  for (Warning& warning : worseThanGiven(reports, {run.part}))
    if (warning.code == "NON_MANIFOLD_EDGES_MADE") warnings.push_back(std::move(warning));
  for (Warning& warning : touchesLeft(reports, {run.part})) warnings.push_back(std::move(warning));
}

BooleanRun runOf(OperandPair pair, BooleanOperation operation, const Progress& progress) {
  BooleanRun run;
  progress.phase("repair", 0, 0.4);
  for (std::size_t i = 0; i < 2; ++i)
    pair.parts[i] =
        inFile(pair.names[i], [&] { return joinedPlaces({pair.parts[i]}, {}).front(); });
  const Scaled scaled(pair);
  const std::vector<io::Part> parts = {scaled.applied(pair.parts[0]),
                                       scaled.applied(pair.parts[1])};
  run.report.input = inspected(parts, worldDiagonal({pair.parts.begin(), pair.parts.end()}));
  const Bodies bodies = bodiesOf(pair, parts, scaled);
  bodies.repairs.tell(run.report, pair);
  progress.phase("boolean", 0.4, 0.9);
  United found = arrangedOf(pair, bodies, operation);
  progress.phase("measure", 0.9, 1);
  run.part = scaled.undone(
      {pair.parts[0].name, found.mesh, {Transform::Identity()}, std::move(pair.groups)});
  const std::size_t crossings = isUnrounded(found.mesh, run.part.mesh)
                                    ? found.crossings.size()
                                    : selfIntersections(run.part.mesh).size();
  run.boolean = {operation, found.cut, crossings};
  if (crossings > 0)
    run.report.warnings.push_back({"CROSSINGS_LEFT", "Triangles intersect others.", crossings});
  run.report.output = inspected({scaled.applied(run.part)}, worldDiagonal({run.part}));
  sayTouching(run);
  return run;
}

}  // namespace

BooleanRun runBoolean(OperandPair pair, BooleanOperation operation, const Progress& progress) {
  return withinMemory([&] { return runOf(std::move(pair), operation, progress); });
}

}  // namespace remesher
