// SPDX-License-Identifier: MIT
#include "jobs/part_repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/fires.h"
#include "base/place.h"
#include "io/model/bake.h"
#include "jobs/checks/result_check.h"
#include "jobs/part_run.h"
#include "jobs/parts/part_frames.h"
#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_places.h"
#include "jobs/parts/part_report.h"
#include "jobs/repair_words.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/chooser.h"
#include "repair/exact_repair.h"
#include "repair/findings.h"
#include "repair/fineness.h"
#include "repair/repair.h"

namespace remesher {

namespace {

std::vector<Vec3> inWorld(std::vector<Vec3> places, const io::Part& part, const PartFrames& scale) {
  for (Vec3& place : places) place = scale.inWorld(part, place);
  return places;
}

void addPlaces(std::vector<SizedPlace>& all, const std::vector<SizedPlace>& more,
               const io::Part& part, const PartFrames& scale) {
  for (const SizedPlace& place : more)
    all.push_back({scale.inWorld(part, place.at), scale.growth(part) * place.across});
  std::stable_sort(all.begin(), all.end(),
                   [](const SizedPlace& a, const SizedPlace& b) { return a.across > b.across; });
  if (all.size() > kMostSizedPlaces) all.resize(kMostSizedPlaces);
}

void addPlaces(std::vector<Vec3>& all, std::vector<Vec3> more) {
  all.insert(all.end(), more.begin(), more.end());
}

FaultReport withLongestFirst(FaultReport faults) {
  const std::vector<double> lengths = std::move(faults.openLoops);
  const std::vector<Vec3> places = std::move(faults.places.openLoops);
  std::vector<std::pair<double, Index>> order;
  for (Index i = 0; i < lengths.size(); ++i) order.emplace_back(-lengths[i], i);
  std::sort(order.begin(), order.end());
  faults.openLoops.clear(), faults.places.openLoops.clear();
  for (const auto& [length, i] : order) {
    faults.openLoops.push_back(-length);
    faults.places.openLoops.push_back(places[i]);
  }
  return faults;
}

// The box around the part at all its places.
Eigen::AlignedBox3d boxInWorld(const io::Part& part) {
  Eigen::AlignedBox3d own, box;
  for (const Index v : part.mesh.indices) own.extend(part.mesh.positions[v]);
  for (const Transform& place : part.instances)
    for (int corner = 0; corner < 8 && !own.isEmpty(); ++corner)
      box.extend(place * own.corner(Eigen::AlignedBox3d::CornerType(corner)));
  return box;
}

// Per part what is wished for its lattice, in its units: as for one mesh of all parts. None for a
// part alone, unless an edge length in the world is asked for.
std::vector<std::optional<double>> spacingsOf(const std::vector<io::Part>& parts,
                                              const PartOptions& options) {
  std::vector<std::optional<double>> spacings(parts.size());
  if (parts.size() < 2 && !options.edgeLength) return spacings;
  const std::vector<PartPlace> places = placesOf(parts);
  Eigen::AlignedBox3d box;
  Extent extent;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    box.extend(boxInWorld(parts[i]));
    extent.area += places[i].area;
  }
  extent.sides = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
  for (std::size_t i = 0; i < parts.size(); ++i)
    spacings[i] = wishedSpacing(extent, options) /
                  std::cbrt(std::abs(places[i].toWorld.linear().determinant()));
  return spacings;
}

// Where the vertices of a repaired part come from. Numbers that a frame rounds to one are told
// apart by it.
struct Sources {
  bool isUnchanged = false;
  std::vector<Index> vertices;  // per vertex a given one at the same position; kNone: it is new
};

// The first vertex at exactly a position, noise around zero included.
class ExactPositions {
 public:
  explicit ExactPositions(const std::vector<Vec3>& positions) : positions_(positions) {}

  Index find(const Vec3& p) {
    if (order_.empty()) sort();
    const auto at = std::lower_bound(
        order_.begin(), order_.end(), p,
        [&](Index v, const Vec3& wanted) { return isBefore(positions_[v], wanted); });
    return at != order_.end() && positions_[*at] == p ? *at : kNone;
  }

 private:
  static bool isBefore(const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  }

  void sort() {
    order_.resize(positions_.size());
    std::iota(order_.begin(), order_.end(), Index{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](Index v, Index w) { return isBefore(positions_[v], positions_[w]); });
  }

  const std::vector<Vec3>& positions_;
  std::vector<Index> order_;
};

Sources sourcesOf(const TriangleMesh& made, const TriangleMesh& given) {
  Sources sources;
  sources.isUnchanged = haveSameContent(made, given);
  if (sources.isUnchanged) return sources;
  std::vector<Vec3> both = given.positions;
  both.insert(both.end(), made.positions.begin(), made.positions.end());
  const std::vector<Index> first = weld(both);
  const auto count = Index(given.positions.size());
  ExactPositions exact(given.positions);
  for (Index v = count; v < both.size(); ++v) {
    if (first[v] >= count)
      sources.vertices.push_back(kNone);
    else
      sources.vertices.push_back(both[first[v]] == both[v] ? first[v] : exact.find(both[v]));
  }
  return sources;
}

void restore(TriangleMesh& mesh, const TriangleMesh& original, const Sources& sources) {
  if (sources.isUnchanged) mesh = original;
  for (std::size_t v = 0; v < sources.vertices.size(); ++v)
    if (sources.vertices[v] != kNone) mesh.positions[v] = original.positions[sources.vertices[v]];
}

// Bodies that share edges are not sound; even so no edge may come out open.
bool isOpened(const TriangleMesh& closed, const TriangleMesh& result) {
  return inspectMesh(result).boundaryEdges > 0 && inspectMesh(closed).boundaryEdges == 0;
}

}  // namespace

PartsRepair repairParts(std::vector<io::Part> parts, const PartOptions& options,
                        const Progress& progress) {
  const PartFrames scale(parts);
  PartsRepair result{scale.isNeeded() ? scale.applied(parts) : parts, {}, {}};
  double total = 0, done = 0;
  std::size_t most = 0;
  std::vector<PlacedWarning> warnings;
  std::vector<Sources> sources(parts.size());
  for (const io::Part& part : parts) total += double(part.mesh.triangleCount());
  PartOptions own = scale.isNeeded() ? scale.applied(options) : options;
  const std::vector<std::optional<double>> spacings = spacingsOf(result.parts, own);
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    io::Part& part = result.parts[i];
    own.spacing = spacings[i];
    const double growth = scale.growth(part);
    own = withPercentsOf(part.mesh, growth, std::move(own));
    if (options.thickness) own.thickness = *options.thickness / growth;
    progress.at(total > 0 ? done / total : 0);
    const std::size_t triangles = part.mesh.triangleCount();
    if (result.parts.size() > 1 && !isSurface(part.mesh)) continue;
    // Vertices that repair makes are single, so that they are the same in every format of file.
    const bool isSingle = std::exchange(part.mesh.isSingle, true);
    const Frame frame = part.mesh.frame;
    if (!isSingle) part.mesh.frame = nearFrame(frame);
    RepairedMesh repaired = repairSurface(part.mesh, own);
    repaired.mesh.isSingle = isSingle;
    repaired.mesh.frame = frame;
    repaired.mesh.steps = part.mesh.steps;
    if (scale.isNeeded()) sources[i] = sourcesOf(repaired.mesh, part.mesh);
    part.mesh = std::move(repaired.mesh);
    result.isRemade |= repaired.isRemade;
    add(result.report, repaired.report);
    result.report.lost += total > 0 ? repaired.report.lost * double(triangles) / total : 0;
    addPlaces(result.report.closedAt, repaired.report.closedAt, part, scale);
    addPlaces(result.report.rimsAt, repaired.report.rimsAt, part, scale);
    addPlaces(result.report.lostAt, inWorld(repaired.report.lostAt, part, scale));
    if (triangles >= most) {
      result.report.mode = repaired.report.mode;
      result.report.reason = repaired.report.reason;
    }
    most = std::max(most, triangles);
    for (PlacedWarning& warning : repaired.warnings) {
      if (warning.at) warning.at = scale.inWorld(part, *warning.at);
      warning.across *= scale.growth(part);
      join(warnings, std::move(warning));
    }
    done += double(triangles);
  }
  if (scale.isNeeded()) {
    result.parts = scale.undone(std::move(result.parts), parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
      restore(result.parts[i].mesh, parts[i].mesh, sources[i]);
  }
  result.warnings =
      mergedByCode(inWords(std::move(warnings), result.parts), warningsOfMeeting(result.parts));
  return result;
}

std::vector<Warning> warningsOfMeeting(const std::vector<io::Part>& parts) {
  io::Model bodies;
  bodies.parts = parts;
  io::makeBodies(bodies);
  if (bodies.parts.size() < 2) return {};
  const TriangleMesh merged = io::mergeParts(bodies.parts);
  const std::vector<Index> meeting = intersectionsOfGroups(merged);
  if (meeting.empty()) return {};
  const Index corner = merged.indices[3 * std::size_t{meeting.front()}];
  return inWords(
      {{{"PARTS_MEET",
         "Triangles of parts intersect those of other parts: repair mends each part by itself. "
         "In an .stl file all become one surface.",
         meeting.size()},
        merged.positions[corner]}},
      parts);
}

std::vector<Warning> warningsOfOneSided(const std::vector<io::Part>& parts) {
  const PartFrames scale(parts);
  OneSided all;
  for (const io::Part& part : scale.isNeeded() ? scale.applied(parts) : parts) {
    const OneSided found = leftOneSided(part.mesh);
    if (all.edges == 0 && found.edges > 0) all.at = inWorld({found.at}, part, scale).front();
    all.edges += found.edges;
  }
  RepairedMesh said;
  warnOfOneSided(said, all);
  return inWords(std::move(said.warnings), parts);
}

bool isSound(const TriangleMesh& mesh) {
  const MeshReport report = inspectMesh(mesh);
  return report.boundaryEdges + report.nonManifoldEdges + report.degenerateTriangles == 0 &&
         selfIntersections(mesh).empty();
}

RoundedMesh inSoundPrecisionOf(const TriangleMesh& original, RemeshOutcome& outcome) {
  RoundedMesh rounded = inPrecisionOf(original, std::move(outcome.mesh));
  // A body of a few triangles, thinner than single precision tells, may come out inside out.
  if (faceOutwards(rounded.mesh)) fires("part repair: bodies turned after remeshing");
  const Rule& rule = choose(Decision::Written, [&](Fact fact) {
    if (fact == Fact::QuadsAsked) return rounded.mesh.isQuads;
    if (fact == Fact::ResultUnsound) return !isSound(rounded.mesh);
    return fact == Fact::OriginalSound && (isSound(original) || isOpened(original, rounded.mesh));
  });
  if (rule.taken == Candidate::AsMade) return rounded;
  outcome.chosen = inReport(rule);
  outcome.stopped = Stopped::Fidelity;
  if (!outcome.places.empty()) outcome.places = ownPlaces(original);
  outcome.coincident = 0;
  outcome.warnings.push_back(
      {"ONLY_REPAIRED",
       "Parts of the repaired surface are too near to each other to be remeshed in coordinates of "
       "so few digits: the repaired surface is written as it is.",
       1});
  return {original, 0};
}

namespace {

// The faults of a part in its frame, with places in the world.
FaultReport faultsIn(const PartFrames& frame, const io::Part& part) {
  FaultReport faults = faultsOf(part.mesh);
  for (std::vector<Vec3>* places : {&faults.places.openLoops, &faults.places.selfIntersections,
                                    &faults.places.innerShells, &faults.places.insideOut})
    *places = inWorld(*places, part, frame);
  return faults;
}

}  // namespace

FaultReport faultsOf(const std::vector<io::Part>& parts) {
  const PartFrames scale(parts), exact(parts, FrameRounding::None);
  const auto applied = [&](const PartFrames& frame) {
    return frame.isNeeded() ? frame.applied(parts) : parts;
  };
  const std::vector<io::Part> scaled = applied(scale);
  FaultReport sum;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    FaultReport faults = faultsIn(scale, scaled[i]);
    // Roundings of the frame, in which repair decides, may make thin parts intersect.
    if (faults.selfIntersections > 0)
      if (const io::Part part = applied(exact)[i];
          selfIntersections(part.mesh).size() != faults.selfIntersections) {
        FaultReport own = faultsIn(exact, part);
        own.repair = faults.repair, own.needs = faults.needs;
        faults = std::move(own);
      }
    sum.openLoops.insert(sum.openLoops.end(), faults.openLoops.begin(), faults.openLoops.end());
    addPlaces(sum.places.openLoops, faults.places.openLoops);
    sum.selfIntersections += faults.selfIntersections;
    sum.innerShells += faults.innerShells;
    sum.insideOut += faults.insideOut;
    sum.repair = std::max(sum.repair, faults.repair);
    sum.needs.bytes = std::max(sum.needs.bytes, faults.needs.bytes);
    sum.needs.seconds += faults.needs.seconds;
    addPlaces(sum.places.selfIntersections, faults.places.selfIntersections);
    addPlaces(sum.places.innerShells, faults.places.innerShells);
    addPlaces(sum.places.insideOut, faults.places.insideOut);
  }
  return withLongestFirst(std::move(sum));
}

}  // namespace remesher
