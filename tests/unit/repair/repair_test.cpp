// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "mesh/canonical_order.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

RepairedMesh mended(const TriangleMesh& mesh) {
  PartOptions options;
  options.repair = Repair::Auto;
  options.edgeLength = 1;  // so that the lattice is the coarsest that there is
  return repairSurface(mesh, options);
}

}  // namespace

TEST_CASE("repair: auto does no harm to what is whole") {
  for (const TriangleMesh& mesh : {shapes::icosphere(3), shapes::torus(10, 5), shapes::cube(2)}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "holes");
    CHECK(result.mesh.positions == mesh.positions);
    CHECK(result.mesh.indices == mesh.indices);
    CHECK(result.warnings.empty());
  }
}

TEST_CASE("repair: auto closes holes where that is enough") {
  TriangleMesh open = shapes::icosphere(4);
  open.indices.resize(open.indices.size() - 9);
  const RepairedMesh result = mended(open);
  CHECK(result.report.mode == "holes");
  CHECK(result.report.holes >= 1);
}

TEST_CASE("repair: auto unites bodies, and turns those that are inside out") {
  const TriangleMesh ball = shapes::icosphere(3), other = soups::moved(ball, {0.7, 0.1, 0.2});
  for (const TriangleMesh& mesh :
       {soups::joined({ball, other}), soups::joined({ball, shapes::turnedOver(other)})}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "solid");
    CHECK(result.report.selfIntersections[1] == 0);
    CHECK(inspectMesh(result.mesh).eulerCharacteristic == 2);
  }
}

TEST_CASE(
    "repair: an open body that is inside out counts what was given, not its lids, as turned") {
  TriangleMesh open = shapes::turnedOver(shapes::icosphere(4));
  open.indices.resize(open.indices.size() - 12);
  const RepairedMesh result = mended(open);
  CHECK(result.mesh.triangleCount() > open.triangleCount());
  CHECK(result.report.turned == open.triangleCount());
}

TEST_CASE("repair: what is only inside out is turned over, and nothing else") {
  const TriangleMesh ball = shapes::icosphere(4);
  const TriangleMesh wrong = shapes::turnedOver(soups::moved(ball, {3, 0, 0}));
  TriangleMesh wall = shapes::turnedOver(ball);  // of a cavity
  for (Vec3& p : wall.positions) p *= 0.5;
  TriangleMesh mesh = soups::joined({wall, ball, wrong});
  mesh.attributes = {{"NORMAL", 3, {}}};
  for (const Vec3& p : mesh.positions) {
    const Vec3 outward = p.x() > 1.5 ? Vec3(p - Vec3(3, 0, 0)) : p;
    for (int k = 0; k < 3; ++k)  // as the triangles face
      mesh.attributes[0].values.push_back(float(p.x() > 1.5 ? -outward[k] : outward[k]));
  }
  const RepairedMesh result = mended(mesh);
  CHECK(result.report.mode == "holes");
  CHECK(result.report.turned == ball.triangleCount());
  CHECK(result.mesh.positions == mesh.positions);
  CHECK(faultsOf(result.mesh).insideOut == 0);
  CHECK(std::equal(mesh.indices.begin(), mesh.indices.end() - long(ball.indices.size()),
                   result.mesh.indices.begin()));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float* normal = &result.mesh.attributes[0].values[3 * v];
    const Vec3 is(normal[0], normal[1], normal[2]), p = mesh.positions[v];
    CHECK(is.dot(p.x() > 1.5 ? Vec3(p - Vec3(3, 0, 0)) : p) > 0);
  }
}

TEST_CASE("repair: common walls of bodies that touch are no bodies") {
  TriangleMesh mesh;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 2; ++z)
        mesh = soups::joined({mesh, soups::moved(soups::cube(0, 1), {x + 0.0, y + 0.0, z + 0.0})});
  const RepairedMesh result = mended(mesh);
  CHECK(inspectMesh(result.mesh).components == 1);
  CHECK(result.report.shells == 0);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].warning.code == "BACK_TO_BACK_TRIANGLES_REMOVED");
  CHECK(result.warnings[0].warning.count == 132);  // of 33 common walls
}

TEST_CASE("repair: auto wraps loose triangles") {
  for (const TriangleMesh& mesh : {soups::randomSoup(40, 0.3, 3)}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "wrap");
    CHECK(result.report.selfIntersections[1] == 0);
    CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  }
}

TEST_CASE("repair: a cavity that was given stays, one that uniting makes is filled") {
  // A room of six slabs, which intersect each other.
  TriangleMesh room;
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {-1.0, 1.0}) {
      TriangleMesh slab = shapes::cube(1);
      for (Vec3& p : slab.positions) {
        p = 2.6 * (p - Vec3::Constant(0.5)) + Vec3(0.01, 0.02, 0.03) * (axis + at);
        p[axis] = at + 0.1 * p[axis];
      }
      room = soups::joined({room, slab});
    }
  const RepairedMesh filled = mended(room);
  CHECK(filled.report.reason == "united");
  CHECK(inspectMesh(filled.mesh).components == 1);
  const auto isSaid = [](const RepairedMesh& result, const char* code) {
    return std::any_of(
        result.warnings.begin(), result.warnings.end(),
        [&](const PlacedWarning& one) { return one.warning.code == code && one.at; });
  };
  CHECK(isSaid(filled, "CAVITIES_FILLED"));
  CHECK_FALSE(isSaid(filled, "HIDDEN_BODIES_REMOVED"));
  TriangleMesh loose = shapes::icosphere(2);
  for (Vec3& p : loose.positions) p *= 0.3;
  const RepairedMesh around = mended(soups::joined({room, loose}));
  CHECK(around.mesh.indices == filled.mesh.indices);
  CHECK(isSaid(around, "HIDDEN_BODIES_REMOVED"));
  TriangleMesh wall = shapes::turnedOver(shapes::icosphere(3));
  for (Vec3& p : wall.positions) p *= 0.5;
  const TriangleMesh hollow = soups::joined(
      {shapes::icosphere(4), wall, soups::moved(shapes::icosphere(3), {1.6, 0.1, 0.2})});
  const RepairedMesh kept = mended(hollow);
  CHECK(kept.report.reason == "united");
  CHECK(inspectMesh(kept.mesh).components == 2);
}

TEST_CASE("repair: an open double shell loses its inner wall, whichever way that faces") {
  const auto ballBelow = [](double height, double size) {
    TriangleMesh ball = shapes::icosphere(4), open = ball;
    open.indices.clear();
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
      const Index* v = &ball.indices[i];
      const auto isBelow = [&](Index k) { return ball.positions[v[k]].z() < height; };
      if (isBelow(0) || isBelow(1) || isBelow(2)) open.indices.insert(open.indices.end(), v, v + 3);
    }
    for (Vec3& p : open.positions) p *= size;
    return open;
  };
  const auto piecesLeft = [](const TriangleMesh& outer, const TriangleMesh& inner) {
    const MeshReport report = inspectMesh(mended(soups::joined({outer, inner})).mesh);
    CHECK(report.boundaryEdges == 0);
    return report.components;
  };
  const TriangleMesh bowl = ballBelow(0.5, 1), inner = ballBelow(0.5, 0.9);
  CHECK(piecesLeft(bowl, inner) == 1);
  CHECK(piecesLeft(bowl, shapes::turnedOver(inner)) == 1);
  // A cavity whose wall has a little hole stays one.
  CHECK(piecesLeft(ballBelow(0.93, 1), shapes::turnedOver(ballBelow(0.93, 0.9))) == 2);
}

TEST_CASE("repair: how many vertices follow does not decide what is a sheet") {
  for (const TriangleMesh& mesh : {shapes::sliverFan(16), shapes::grid(9, 7)}) {
    PartOptions options;
    options.repair = Repair::Auto;
    const std::string reason = repairSurface(mesh, options).report.reason;
    for (const Index vertices : {100U, 1500U, 6000U}) {
      options.vertices = vertices;
      CHECK(repairSurface(mesh, options).report.reason == reason);
    }
  }
}

TEST_CASE("repair: how many triangles a sheet has does not decide that it is one") {
  for (const int cells : {8, 40, 120}) {
    TriangleMesh sheet = shapes::grid(cells, cells);
    for (Vec3& p : sheet.positions) p = Vec3(p.x() / cells, p.y() / cells, 0);
    for (Vec3& p : sheet.positions) p.z() = 0.1 * std::sin(7 * p.x()) * std::cos(5 * p.y());
    CHECK(mended(sheet).report.reason == "sheets");
  }
}

TEST_CASE("repair: a ball that lacks a fifth of its triangles, here and there, is closed") {
  TriangleMesh ball = shapes::icosphere(12);
  const TriangleMesh whole = ball;
  ball.indices.clear();
  std::uint32_t state = 5;
  for (std::size_t i = 0; i < whole.indices.size(); i += 3) {
    state = state * 1664525 + 1013904223;
    if (state >> 16 < 0x10000 / 5) continue;
    for (std::size_t k = 0; k < 3; ++k) ball.indices.push_back(whole.indices[i + k]);
  }
  const RepairedMesh result = mended(ball);
  CHECK(result.report.reason == "closed");
  CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  CHECK(selfIntersections(result.mesh).empty());
}

TEST_CASE("repair: auto leaves sheets alone, with a warning that has a place") {
  const TriangleMesh sheet = shapes::grid(9, 7);
  const RepairedMesh result = mended(sheet);
  CHECK(result.report.reason == "sheets");
  CHECK(result.mesh.indices == sheet.indices);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings.front().warning.code == "SHEETS_LEFT");
  CHECK(result.warnings.front().at);
}

TEST_CASE("repair: the reason is sheets only where every triangle stays") {
  TriangleMesh fin;  // on an edge of the box, as its third triangle
  fin.positions = {{1, 1, 0}, {1, 1, 1}, {3, 3, 0}};
  fin.indices = {0, 1, 2};
  const TriangleMesh whole =
      soups::joined({soups::cube(0, 1), soups::moved(shapes::grid(20, 20), {30, 0, 0})});
  const TriangleMesh given = soups::joined({whole, fin});
  for (const TriangleMesh& mesh : {whole, given}) {
    const RepairedMesh result = mended(mesh);
    CHECK((result.report.reason == "sheets") ==
          (result.mesh.triangleCount() == mesh.triangleCount()));
  }
}

TEST_CASE("repair: faults are none where nothing is broken") {
  for (const TriangleMesh& mesh : {shapes::icosphere(6), shapes::torus(20, 10)}) {
    const FaultReport faults = faultsOf(mesh);
    CHECK(faults.openLoops.empty());
    CHECK(faults.selfIntersections == 0);
    CHECK(faults.repair == Repair::Off);
  }
}

TEST_CASE("repair: faults tell how long open loops are") {
  const FaultReport faults = faultsOf(shapes::grid(8, 6));
  REQUIRE(faults.openLoops.size() == 1);
  // Around a rectangle, in percent of its diagonal.
  const TriangleMesh sheet = shapes::grid(8, 6);
  const Vec3 size = sheet.positions.back() - sheet.positions.front();
  const double around = 2 * (std::abs(size.x()) + std::abs(size.y()) + std::abs(size.z()));
  CHECK(faults.openLoops.front() == doctest::Approx(100 * around / size.norm()));
  TriangleMesh open = shapes::icosphere(6);
  open.indices.resize(open.indices.size() - 9);
  CHECK(faultsOf(open).repair == Repair::Holes);
}

TEST_CASE("repair: faults tell inner shells from cavities, and bodies that are inside out") {
  const TriangleMesh ball = shapes::icosphere(5);
  TriangleMesh shell = ball;
  for (Vec3& p : shell.positions) p *= 0.5;
  CHECK(faultsOf(soups::joined({ball, shell})).innerShells == 1);
  CHECK(faultsOf(soups::joined({ball, shell})).repair == Repair::Solid);
  CHECK(faultsOf(soups::joined({ball, shapes::turnedOver(shell)})).innerShells == 0);
  CHECK(faultsOf(shapes::turnedOver(ball)).insideOut == 1);
  TriangleMesh open = ball;  // repair closes it, and then it has an outside
  open.indices.resize(open.indices.size() - 9);
  CHECK(faultsOf(open).insideOut == 0);
  CHECK(faultsOf(shapes::turnedOver(open)).insideOut == 1);
  CHECK(mended(shapes::turnedOver(open)).report.turned >= open.triangleCount());
  const FaultReport both = faultsOf(soups::joined({ball, soups::moved(ball, {0.7, 0.1, 0.2})}));
  CHECK(both.selfIntersections > 0);
  CHECK(both.repair == Repair::Solid);
}

TEST_CASE("repair: faults name no repair for sheets, which auto leaves as they are") {
  CHECK(faultsOf(shapes::grid(8, 6)).repair == Repair::Off);
  // Nor for a sheet beside a sound body.
  const TriangleMesh beside = soups::moved(shapes::grid(8, 6), {20, 0, 0});
  CHECK(faultsOf(soups::joined({shapes::icosphere(5), beside})).repair == Repair::Off);
}

TEST_CASE("repair: triangles without an area are left out of a sound surface") {
  TriangleMesh ball = shapes::icosphere(3);
  // At one corner a line: its neighbours run along both of its sides.
  const Index at = ball.indices[0], twin = Index(ball.positions.size());
  ball.positions.push_back(ball.positions[at]);
  const std::size_t triangles = ball.triangleCount();
  ball.indices.insert(ball.indices.end(), {at, twin, ball.indices[1]});
  const RepairedMesh result = mended(ball);
  CHECK(result.mesh.triangleCount() == triangles);
  CHECK(result.report.reason == "closed");
}

TEST_CASE("repair: faults have places") {
  const TriangleMesh ball = shapes::icosphere(5);
  TriangleMesh shell = ball;
  for (Vec3& p : shell.positions) p = 0.5 * p;
  const FaultPlaces within = faultsOf(soups::joined({ball, shell})).places;
  REQUIRE(within.innerShells.size() == 1);
  CHECK(within.innerShells.front().norm() == doctest::Approx(0.5));
  const FaultPlaces loops = faultsOf(shapes::grid(8, 6)).places;
  CHECK(loops.openLoops.size() == 1);
  const TriangleMesh moved = soups::moved(ball, {0.7, 0.1, 0.2});
  REQUIRE(faultsOf(soups::joined({ball, moved})).places.selfIntersections.size() == 1);
}

TEST_CASE("repair: auto says why it does what it does") {
  const TriangleMesh ball = shapes::icosphere(4);
  CHECK(mended(ball).report.reason == "sound");
  const TriangleMesh two = soups::joined({ball, soups::moved(ball, {0.7, 0.1, 0.2})});
  CHECK(mended(two).report.reason == "united");
  CHECK(mended(soups::randomSoup(40, 0.3, 3)).report.reason == "open");
  TriangleMesh open = ball;
  open.indices.resize(open.indices.size() - 9);
  CHECK(mended(open).report.reason == "closed");
}

TEST_CASE("repair: bodies thinner than coordinates tell do not come out inside out") {
  TriangleMesh front = shapes::grid(3, 3);
  for (Vec3& p : front.positions) {
    p /= 3;
    const Vec3 wave(p.x(), p.y(), 0.1 * std::sin(4 * p.x()) * std::cos(3 * p.y()));
    p = inSingle(wave + Vec3(10.5415, 0, 0), {});
  }
  TriangleMesh twice = soups::joined({front, shapes::turnedOver(front)});
  twice.isSingle = true;
  PartOptions options;
  options.repair = Repair::Solid;
  const RepairedMesh result = repairSurface(twice, options);
  CHECK(result.isRemade);
  CHECK(faultsOf(result.mesh).insideOut == 0);
}

TEST_CASE("repair: only sheets, all to be dropped, are nothing") {
  PartOptions options;
  options.repair = Repair::Wrap;
  options.sheets = Sheets::Drop;
  options.edgeLength = 1;
  CHECK_THROWS_AS(repairSurface(shapes::grid(3, 2), options), Error);
}

TEST_CASE("repair: auto does what faults say would mend") {
  const TriangleMesh ball = shapes::icosphere(4);
  TriangleMesh open = ball;
  open.indices.resize(open.indices.size() - 9);
  for (const TriangleMesh& mesh : {open, shapes::turnedOver(ball), soups::randomSoup(40, 0.3, 3)}) {
    const Repair repair = faultsOf(mesh).repair;
    const std::string mode = mended(mesh).report.mode;
    CHECK(mode == (repair == Repair::Holes ? "holes" : repair == Repair::Solid ? "solid" : "wrap"));
  }
}

TEST_CASE("repair: with rims kept small open pieces stay as they are beside a hole that closes") {
  TriangleMesh torn = shapes::icosphere(12);
  torn.indices.resize(torn.indices.size() - 9);
  soups::addTriangle(torn, {0, 0, 1.1}, {0.05, 0, 1.1}, {0, 0.05, 1.1});
  PartOptions options;
  options.repair = Repair::Holes;
  const RepairedMesh closed = repairSurface(torn, options);
  CHECK(inspectMesh(closed.mesh).components == 1);
  options.keepRims = true;
  const RepairedMesh kept = repairSurface(torn, options);
  CHECK(inspectMesh(kept.mesh).components == 2);
  CHECK(inspectMesh(kept.mesh).boundaryEdges == 3);
  CHECK(kept.report.holes == 1);
  CHECK(kept.report.islands == 0);
}

TEST_CASE("repair: a triangle without area that closes a T-junction keeps no bodies apart") {
  TriangleMesh box = shapes::cube(1);  // with a vertex in the middle of an edge, on one side only
  const Index middle = shapes::addVertex(box, {0.5, 0, 0});
  const std::size_t sides = box.indices.size();
  const auto isAt = [&](Index v, double x) { return box.positions[v] == Vec3(x, 0, 0); };
  for (std::size_t i = 0; i < sides; i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = box.indices[i + k], b = box.indices[i + (k + 1) % 3],
                  c = box.indices[i + (k + 2) % 3];
      if (!isAt(a, 0) || !isAt(b, 1)) continue;
      box.indices[i] = a, box.indices[i + 1] = middle, box.indices[i + 2] = c;
      shapes::addTriangle(box, middle, b, c);
      shapes::addTriangle(box, a, b, middle);
      i = sides;
      break;
    }
  const TriangleMesh both = soups::joined({box, soups::moved(shapes::cube(1), {0.3, 0.4, 0.5})});
  const RepairedMesh result = mended(both);
  CHECK(result.report.reason == "united");
  CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  CHECK(result.mesh.triangleCount() < 80);
}

TEST_CASE("repair: rims stay open where that is asked for; closed they are named with their size") {
  TriangleMesh vase;
  shapes::addSheet(vase, 24, 6, [](int k, int row) {
    return Vec3((2 + std::sin(row)) * shapes::onCircle(k, 24) + Vec3(0, 0, 2 * row));
  });
  for (int k = 0; k < 24; ++k)
    shapes::addTriangle(vase, shapes::addVertex(vase, {0, 0, 0}), Index(k + 1), Index(k));
  PartOptions options;
  options.repair = Repair::Auto;
  const RepairedMesh closed = repairSurface(vase, options);
  CHECK(inspectMesh(closed.mesh).boundaryEdges == 0);
  REQUIRE(closed.report.closedAt.size() == 1);
  CHECK(closed.report.closedAt[0].across == doctest::Approx(2 * (2 + std::sin(6))));
  CHECK(closed.warnings.front().warning.code == "RIMS_CLOSED");
  for (const Repair repair : {Repair::Auto, Repair::Holes}) {
    options.repair = repair;
    options.keepRims = true;
    TriangleMesh torn = vase;  // a missing triangle is closed all the same
    torn.indices.erase(torn.indices.begin() + 300, torn.indices.begin() + 303);
    const RepairedMesh open = repairSurface(torn, options);
    CHECK(inspectMesh(open.mesh).boundaryEdges == 24);
    CHECK(open.report.holes == 1);
    REQUIRE(open.report.rimsAt.size() == 1);
    CHECK(open.report.rimsAt[0].at.z() == doctest::Approx(12));
  }
}

namespace {

std::vector<Index> stepsOf(std::size_t count, std::size_t step) {
  std::vector<Index> order;
  for (std::size_t i = 0; i < count; ++i) order.push_back(Index(i * step % count));
  return order;
}

// The same surface with its lists in another order. `step` shares no factor with their lengths.
TriangleMesh shuffled(const TriangleMesh& mesh, std::size_t step) {
  CanonicalOrder order;
  order.vertices = stepsOf(mesh.positions.size(), step);
  order.numbers.resize(order.vertices.size());
  for (Index v = 0; v < order.vertices.size(); ++v) order.numbers[order.vertices[v]] = v;
  order.triangles = stepsOf(mesh.triangleCount(), step);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) order.turns.push_back(std::uint8_t(t % 3));
  return inOrder(mesh, order);
}

std::vector<std::array<double, 9>> sortedCorners(const TriangleMesh& mesh) {
  const TriangleMesh own = inOrder(mesh, canonicalOrder(mesh));
  std::vector<std::array<double, 9>> all;
  for (std::size_t i = 0; i < own.indices.size(); i += 3) {
    all.emplace_back();
    for (std::size_t k = 0; k < 9; ++k)
      all.back()[k] = own.positions[own.indices[i + k / 3]][Eigen::Index(k % 3)];
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("repair: the order of a file's lists changes no triangle, and those kept stay in it") {
  TriangleMesh noisy;  // triangles whose corners are not quite at one place
  const TriangleMesh ball = shapes::icosphere(3);
  for (std::size_t i = 0; i < ball.indices.size(); ++i) {
    noisy.indices.push_back(Index(i));
    noisy.positions.emplace_back(ball.positions[ball.indices[i]] +
                                 1e-6 * Vec3::Constant(double(i % 5)));
  }
  TriangleMesh open = shapes::icosphere(4);
  open.indices.resize(open.indices.size() - 9);
  const TriangleMesh box = shapes::cube(2);
  for (const TriangleMesh& mesh :
       {noisy, open, soups::joined({box, soups::moved(box, {0.5, 0.5, 0.5})})}) {
    const TriangleMesh one = mended(mesh).mesh;
    for (const std::size_t step : {7, 11, 1009})
      CHECK(sortedCorners(mended(shuffled(mesh, step)).mesh) == sortedCorners(one));
  }
  const TriangleMesh closed = mended(open).mesh;
  for (std::size_t i = 0; i < open.indices.size(); ++i)
    CHECK(closed.positions[closed.indices[i]] == open.positions[open.indices[i]]);
}
