// SPDX-License-Identifier: MIT
#include "jobs/touching_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/fires.h"
#include "base/legible.h"
#include "base/place.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle.h"
#include "io/model/appending.h"
#include "io/model/bake.h"
#include "jobs/angle_number.h"
#include "jobs/body_parts.h"
#include "jobs/checks/result_check.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/part_report.h"
#include "jobs/run_guards.h"
#include "measure/self_intersections.h"
#include "mesh/coordinate_step.h"
#include "mesh/joining.h"
#include "mesh/used_vertices.h"
#include "remesh/schemes/targets.h"

namespace remesher {

namespace {

// Two bodies that were rounded in one file differ by so many steps of its coordinates at most.
constexpr double kStepsOff = 4;
// The longest edges within faces that touch others, in lengths of edges between faces.
constexpr double kWithin = 2;
// A smallest angle of every triangle takes edges between faces that are no longer than those of a
// mesh of so many vertices.
constexpr double kFewestOfAngle = 500;
// Surfaces no farther apart than this share of the diagonal nearly touch.
constexpr double kNearlyTouching = 5e-3;

// A level of detail shows the same as other parts, and of several places each has its own
// neighbours.
bool mayTouch(const io::Part& part) {
  constexpr double kSingular = 1e-9;
  const Eigen::Matrix3d m = firstPlace(part).linear();
  const double size = m.cwiseAbs().maxCoeff();
  return part.finer.empty() && part.instances.size() <= 1 && !part.mesh.indices.empty() &&
         size > 0 && std::isfinite(size) && std::abs((m / size).determinant()) > kSingular;
}

double areaOf(const io::Part& part) {
  double sum = 0;
  const Transform place = firstPlace(part);
  for (std::size_t t = 0; t < part.mesh.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(part.mesh, t);
    sum += area(place * a, place * b, place * c);
  }
  return sum;
}

struct ComplexSize {
  double area, whole, own;  // the area of the complex and of all parts; places of all parts
};

// The length of edges where faces meet: as long as others will be on average.
double junctionLength(const PartOptions& options, const ComplexSize& size) {
  const double longest = options.maxEdge.value_or(kInfinity) / kLongestOfSize;
  const double shortest = options.minEdge.value_or(0) / kShortestOfSize;
  if (options.maxEdge && leadsByEdges(options)) return longest;
  double number = size.own * options.ratio.value_or(1);
  if (options.vertices) number = double(*options.vertices);
  if (options.faces) number = double(*options.faces) / 2;
  if (leadsByAngle(options)) number = std::max(number, kFewestOfAngle);
  number = std::max(number * size.area / size.whole, 4.0);
  const double length = options.edgeLength.value_or(evenEdgeLength(size.area, number));
  return std::min(std::max(length, shortest), longest);
}

TriangleMesh meshOf(const BodyComplex& complex, const std::vector<BodySides>& sides) {
  TriangleMesh mesh;
  mesh.positions = complex.points;
  for (const ComplexTriangle& t : complex.triangles) {
    mesh.indices.insert(mesh.indices.end(), t.corners.begin(), t.corners.end());
    const auto side = std::lower_bound(sides.begin(), sides.end(), std::pair(t.own, t.other));
    mesh.groups.push_back(Index(side - sides.begin()));
  }
  return mesh;
}

// Warnings that compare the complex, which is no manifold, with what is made of it.
bool isOfComplex(const Warning& warning) {
  constexpr std::array kCodes = {"ANGLES_WORSE",
                                 "DEGENERATE_TRIANGLES_MADE",
                                 "NON_MANIFOLD_EDGES_MADE",
                                 "NON_MANIFOLD_EDGES_SPLIT",
                                 "NON_MANIFOLD_VERTICES_SPLIT",
                                 "SURFACE_OPENED"};
  return std::find(kCodes.begin(), kCodes.end(), warning.code) != kCodes.end();
}

std::string lengthInWords(double length) {
  constexpr int kShownDigits = 3;
  return inDigits(length, kShownDigits);
}

}  // namespace

TouchingParts::TouchingParts(const std::vector<io::Part>& given, const PartOptions& options)
    : given_(given) {
  if (!options.conform) return;
  withinMemory([&] { find(options); });
}

void TouchingParts::find(const PartOptions& options) {
  gather();
  if (!all_.indices.empty()) build(options);
  const std::vector<char> isMember = partsThatTouch();
  if (std::find(isMember.begin(), isMember.end(), 1) == isMember.end()) {
    warnings_.push_back(
        {"NO_BODIES_TOUCH", "No closed bodies touch face to face: there is nothing to conform."});
    return;
  }
  setParts(isMember, options);
}

void TouchingParts::build(const PartOptions& options) {
  std::vector<Index> pieces;
  for (const Index group : all_.groups) pieces.push_back(Index(partOf(group)));
  const double diagonal = diagonalOf(all_);
  const double touching = std::max(kStepsOff * coordinateStep(all_.positions),
                                   options.weld.value_or(0) / 100 * diagonal);
  complex_ = complexOf(all_, pieces, {touching, std::max(touching, kNearlyTouching * diagonal)});
  warnOfTouching();
}

void TouchingParts::gather() {
  all_.isSingle = true;
  std::size_t repeated = 0;
  for (const io::Part& part : given_) {
    requireValid(part.mesh);
    repeated += part.instances.size() > 1 ? 1 : 0;
    firstGroups_.push_back(all_.groups.empty() ? 0 : Index(groupCount(all_)));
    if (!mayTouch(part)) continue;
    TriangleMesh placed = part.mesh;
    placed.attributes.clear();
    io::transformMesh(placed, firstPlace(part));
    appendGroups(all_.groups, placed, firstGroups_.back());
    appendMesh(all_, placed);
    all_.isSingle = all_.isSingle && part.mesh.isSingle;
  }
  if (repeated > 0)
    warnings_.push_back({"INSTANCES_NOT_CONFORMED",
                         "Meshes that are shown at several places share no faces with others: give "
                         "each place a mesh of its own.",
                         repeated});
}

std::size_t TouchingParts::partOf(Index group) const {
  const auto after = std::upper_bound(firstGroups_.begin(), firstGroups_.end(), group);
  return std::size_t(after - firstGroups_.begin()) - 1;
}

void TouchingParts::warnOfTouching() {
  const Touching& touching = complex_.touching;
  if (touching.apart > 0) {
    warnings_.push_back({"BODIES_ALMOST_TOUCH",
                         "Bodies almost touch: their faces are up to " +
                             lengthInWords(touching.gap) + " apart, and stay apart.",
                         touching.apart});
    warnings_.back().at = touching.gapAt;
  }
  if (complex_.left > 0) {
    warnings_.push_back(
        {"COMMON_FACES_LEFT",
         "Faces that touch were remeshed separately: within the precision of the file "
         "they do not lie in one plane, or their borders cross.",
         complex_.left});
    warnings_.back().at = complex_.leftAt;
  }
  warnOfCrossings();
}

// Of triangles of other bodies; touching counts, too.
void TouchingParts::warnOfCrossings() {
  TriangleMesh mesh;
  mesh.positions = complex_.points;
  const auto bodies = Index(complex_.isClosed.size());
  for (const ComplexTriangle& t : complex_.triangles) {
    mesh.indices.insert(mesh.indices.end(), t.corners.begin(), t.corners.end());
    mesh.groups.push_back(t.own.body + (t.other.body == kNone ? 0 : bodies));
  }
  const std::vector<Index> crossing = intersectionsOfGroups(mesh);
  if (crossing.empty()) return;
  warnings_.push_back({"BODIES_OVERLAP",
                       "Triangles of bodies meet those of others beyond common faces: the bodies "
                       "overlap, or touch in edges or points.",
                       crossing.size()});
  // The middle of the smallest triangle is the surest place.
  double least = kInfinity;
  for (const Index t : crossing) {
    const auto [a, b, c] = cornersOf(mesh, t);
    const double own = area(a, b, c);
    if (own >= least) continue;
    least = own;
    warnings_.back().at = (a + b + c) / 3;
  }
}

std::vector<char> TouchingParts::partsThatTouch() const {
  std::vector<char> isMember(given_.size(), 0);
  for (const ComplexTriangle& t : complex_.triangles)
    if (t.other.body != kNone) isMember[partOf(t.own.group)] = isMember[partOf(t.other.group)] = 1;
  return isMember;
}

void TouchingParts::setParts(const std::vector<char>& isMember, const PartOptions& options) {
  std::erase_if(complex_.triangles,
                [&](const ComplexTriangle& t) { return !isMember[partOf(t.own.group)]; });
  ComplexSize size{0, 0, double(inspectScaled(given_).vertices)};
  for (std::size_t p = 0; p < given_.size(); ++p) size.whole += areaOf(given_[p]);
  for (const ComplexTriangle& t : complex_.triangles) {
    const auto at = [&](std::size_t k) { return complex_.points[t.corners[k]]; };
    size.area += area(at(0), at(1), at(2));
    sides_.emplace_back(t.own, t.other);
  }
  std::sort(sides_.begin(), sides_.end());
  sides_.erase(std::unique(sides_.begin(), sides_.end()), sides_.end());
  isLedByAngle_ = leadsByAngle(options);
  const double length = junctionLength(options, size);
  divideJunctions(complex_, {length, options.maxEdge.value_or(kInfinity)});
  divideWithin(complex_, kWithin * length);
  io::Part part;
  part.mesh = meshOf(complex_, sides_);
  keepUsedVertices(part.mesh);
  part.mesh.isSingle = all_.isSingle;
  part.instances = {Transform::Identity()};
  bool isThere = false;
  for (std::size_t p = 0; p < given_.size(); ++p) {
    if (isMember[p] && !isThere) {
      part.name = given_[p].name;
      complexAt_ = parts_.size();
    }
    numbers_.push_back(isMember[p] && isThere ? complexAt_ : parts_.size());
    if (!isMember[p])
      parts_.push_back(given_[p]);
    else if (!std::exchange(isThere, true))
      parts_.push_back(part);
    if (isMember[p] && losesAttributes(given_[p].mesh))
      warnings_ =
          mergedByCode(std::move(warnings_),
                       {{"TEXCOORDS_LEFT_OUT",
                         "Bodies that share faces are remeshed without texture coordinates.", 1}});
  }
  for (io::Part& one : parts_)
    for (std::size_t& finer : one.finer) finer = numbers_[finer];
}

PartOptions TouchingParts::applied(PartOptions options) const {
  options.conform = false;
  if (!isActive()) return options;
  options.keepsJoints = true;
  if (options.ratio)
    options.vertices =
        Index(std::max(1LL, std::llround(*options.ratio * double(inspectScaled(given_).vertices))));
  options.ratio.reset();
  // The border of a common face may need more vertices than edges of this length.
  if (options.edgeLength) options.tooFew = TooFew::Raise;
  return options;
}

// Per body its triangles, by welded vertices of what was made of the complex.
std::vector<std::vector<OwnTriangle>> TouchingParts::toldApart(const TriangleMesh& made) const {
  std::vector<std::vector<OwnTriangle>> bodies(complex_.isClosed.size());
  for (std::size_t t = 0; t < made.triangleCount(); ++t) {
    const Index* const v = &made.indices[3 * t];
    const auto& [own, other] = sides_[made.groups[t]];
    bodies[own.body].push_back({{v[0], v[1], v[2]}, own.group});
    if (other.body != kNone) bodies[other.body].push_back({{v[0], v[2], v[1]}, other.group});
  }
  return bodies;
}

void TouchingParts::finish(std::vector<SceneRun>& runs) const {
  SceneRun& run = runs.front();
  std::vector<Warning>& warnings = run.report.warnings;
  warnings = mergedByCode(warnings_, warnings);
  if (!isActive()) return;
  std::erase_if(warnings, isOfComplex);
  TriangleMesh made = std::move(run.parts[complexAt_].mesh);
  const std::vector<Index> first = weld(made.positions);
  for (Index& v : made.indices) v = first[v];
  std::vector<std::vector<TriangleMesh>> ofPart(given_.size());
  for (std::vector<OwnTriangle>& body : toldApart(made)) {
    if (body.empty()) continue;
    const std::size_t part = partOf(body.front().group);
    for (OwnTriangle& t : body) t.group -= firstGroups_[part];
    ofPart[part].push_back(bodyIn(given_[part], body, made.positions));
  }
  run.report.conform = commonFacesIn(made, sides_);
  std::vector<Vec3> places;
  for (const Index v : made.indices) places.push_back(made.positions[v]);
  replaceParts(run, ofPart);
  describe(run, ofPart, countPlaces(places));
  const std::size_t before = run.report.input.vertices, after = run.report.output->vertices;
  const bool isSaid = std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.code == "MORE_VERTICES_TAKEN";
  });
  if (isLedByAngle_ && !isSaid && after > before) warnings.push_back(moreForAngle(after, before));
}

void TouchingParts::replaceParts(SceneRun& run,
                                 const std::vector<std::vector<TriangleMesh>>& ofPart) const {
  SceneRun whole;
  std::swap(whole.parts, run.parts), std::swap(whole.places, run.places);
  const std::vector<Prefer> prefer = std::exchange(run.report.prefer, {});
  const std::vector<Chosen> chosen = std::exchange(run.report.chosen, {});
  run.crossings.assign(given_.size(), {});
  for (std::size_t p = 0; p < given_.size(); ++p) {
    const std::size_t number = numbers_[p];
    run.report.prefer.push_back(prefer[number]);
    run.report.chosen.push_back(chosen[number]);
    const bool isOwn = number != complexAt_;
    run.places.push_back(isOwn ? whole.places[number] : std::vector<InputPlace>{});
    run.parts.push_back(isOwn ? whole.parts[number] : withBodies(given_[p], ofPart[p]));
  }
}

// Each body counts by itself, and each place of the complex once.
void TouchingParts::describe(SceneRun& run, const std::vector<std::vector<TriangleMesh>>& ofPart,
                             std::size_t places) const {
  std::vector<io::Part> bodies;
  for (std::size_t p = 0; p < given_.size(); ++p) {
    for (const TriangleMesh& body : ofPart[p]) bodies.push_back(withBodies(given_[p], {body}));
    if (!ofPart[p].empty()) continue;
    bodies.push_back(run.parts[p]);
    places += countPlaces(run.parts[p].mesh.positions);
  }
  Report& report = run.report;
  std::optional<WantedReport> wanted = std::move(report.output->wanted);
  report.input = inspectScaled(given_);
  report.output = inspectScaled(bodies);
  report.output->vertices = places;
  report.output->wanted = std::move(wanted);
  report.warnings = mergedByCode(std::move(report.warnings),
                                 worseThanGiven({report.input, *report.output}, bodies));
  report.fidelity = fidelityOf({given_, run.parts, placesOf(given_)}, Maximum::Sampled, {});
}

}  // namespace remesher
