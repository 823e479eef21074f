// SPDX-License-Identifier: MIT
// What whole runs promise about edges: features survive, boundaries stay or are followed.
#include "remesh/schemes/remesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/quad.h"
#include "geometry/triangle.h"
#include "measure/mesh_report.h"
#include "mesh/welding.h"
#include "remesh/schemes/targets.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

using Segment = std::array<Vec3, 2>;

// The edges that are open, or bent by more than 40°.
enum class Which { Open, Sharp };

std::vector<Segment> edgesOf(const TriangleMesh& input, Which which) {
  const Welding welding(input);
  const auto at = [&](Index h) { return input.positions[welding.corners[h]]; };
  const auto normal = [&](Index h) {
    const Index next = nextCorner(h);
    return unitNormal(at(h), at(next), at(nextCorner(next)));
  };
  std::vector<Segment> result;
  welding.forEachEdge([&](std::span<const Index> edge) {
    const bool isOpen = edge.size() == 1;
    const bool isSharp = !isOpen && normal(edge[0]).dot(normal(edge[1])) < std::cos(radians(40));
    if (which == Which::Open ? isOpen : isSharp)
      result.push_back({at(edge[0]), at(nextCorner(edge[0]))});
  });
  return result;
}

double distance(const Vec3& p, const std::vector<Segment>& segments) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : segments)
    nearest = std::min(nearest, (closestPoint(p, a, b, b) - p).norm());
  return nearest;
}

// Of the points of one curve from the other.
double farthest(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  double most = 0;
  for (const auto& [a, b] : from)
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      most = std::max(most, distance((1 - t) * a + t * b, to));
  return most;
}

// Where other than two curve edges meet, or two at a bend of more than 50°.
std::vector<Vec3> cornersOf(const std::vector<Segment>& curve) {
  std::vector<Vec3> corners;
  for (const Segment& segment : curve)
    for (const Vec3& p : segment) {
      std::vector<Vec3> ways;
      for (const auto& [a, b] : curve)
        if (a == p || b == p) ways.push_back(((a == p ? b : a) - p).normalized());
      if (ways.size() != 2 || -ways[0].dot(ways[1]) < std::cos(radians(50))) corners.push_back(p);
    }
  return corners;
}

// A cone of half-angle α bends by √3 e / (2 s tan α) across an edge of length e that leads away
// from the apex at a distance of s: at a slope of 2 to 1 by more than 40° up to s = 2.5 e, the
// middle of an edge that begins at 2 e. A half more is for edges that are longer than others.
std::vector<Segment> withoutThoseAround(const Vec3& apex, double edge, std::vector<Segment> edges) {
  std::erase_if(edges, [&](const Segment& s) {
    return std::min((s[0] - apex).norm(), (s[1] - apex).norm()) < 3 * edge;
  });
  return edges;
}

bool contains(const TriangleMesh& mesh, const Vec3& p) {
  return std::find(mesh.positions.begin(), mesh.positions.end(), p) != mesh.positions.end();
}

std::set<std::array<double, 6>> asSet(const std::vector<Segment>& segments) {
  std::set<std::array<double, 6>> result;
  for (const auto& [a, b] : segments) {
    std::array<double, 6> there = {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    std::array<double, 6> back = {b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
    result.insert(std::min(there, back));
  }
  return result;
}

// A hilly sheet with an outline of uneven steps.
TriangleMesh hills() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 24, 24, [](int i, int k) {
    const double x = i + 0.3 * std::sin(3.0 * i), y = k + 0.3 * std::cos(2.0 * k);
    return Vec3(x, y, 2 * std::sin(0.4 * x) * std::cos(0.3 * y));
  });
  return mesh;
}

// The triangle that a blade is across: 1.2 long, 0.4 thick at its back.
const std::array<Vec3, 3> kAcross = {Vec3(0, -0.2, 0), Vec3(1.2, 0, 0), Vec3(0, 0.2, 0)};

// Of height 1.
TriangleMesh blade() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const Vec3& p : kAcross) shapes::addVertex(mesh, p + Vec3(0, 0, z));
  mesh.indices = {0, 2, 1, 3, 4, 5};
  for (Index i = 0; i < 3; ++i) {
    const Index k = (i + 1) % 3;
    shapes::addTriangle(mesh, i, k, 3 + k);
    shapes::addTriangle(mesh, i, 3 + k, 3 + i);
  }
  return mesh;
}

// How far a point is from the nearest of the blade's five planes.
double fromSides(const Vec3& p) {
  double nearest = std::min(std::abs(p.z()), std::abs(1 - p.z()));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 along = (kAcross[(i + 1) % 3] - kAcross[i]).normalized();
    nearest = std::min(nearest, std::abs((p - kAcross[i]).cross(along).z()));
  }
  return nearest;
}

RemeshOutcome run(const TriangleMesh& mesh, Index vertices, PartOptions options = {}) {
  options.vertices = vertices;
  return remeshSurface(mesh, options, {});
}

}  // namespace

TEST_CASE("quality: a draft has the number, the topology and the curves of the best") {
  PartOptions options;
  options.quality = Quality::Draft;
  for (const TriangleMesh& body : {shapes::torus(48, 24), shapes::cylinder(96, 24)}) {
    const RemeshOutcome outcome = run(body, 2000, options);
    const MeshReport before = inspectMesh(body), after = inspectMesh(outcome.mesh);
    CHECK(outcome.stopped == Stopped::Target);
    CHECK(after.vertices == 2000);
    CHECK(after.eulerCharacteristic == before.eulerCharacteristic);
    CHECK(after.components == before.components);
    CHECK(after.nonManifoldEdges == 0);
    CHECK(after.minAngle.worst > 25);
    CHECK(after.minAngle.mean > 53);
    const std::vector<Segment> sharp = edgesOf(outcome.mesh, Which::Sharp);
    CHECK(farthest(edgesOf(body, Which::Sharp), sharp) < 0.01);
  }
}

TEST_CASE("curves: features of bodies survive, none is lost, none is invented") {
  struct Case {
    TriangleMesh body;
    double diagonal;
    std::vector<Vec3> tips;
  };
  for (const auto& [body, diagonal, tips] :
       {Case{shapes::cube(8), 8 * std::sqrt(3.0), {}},
        Case{shapes::boxWithHole(), 3 * std::sqrt(3.0), {}},
        Case{shapes::cylinder(96, 24), std::sqrt(12.0), {}},
        Case{shapes::cone(96), std::sqrt(8.0), {Vec3(0, 0, 2)}}})
    for (const Index vertices : {600, 1600}) {
      CAPTURE(vertices);
      const RemeshOutcome outcome = run(body, vertices);
      const std::vector<Segment> before = edgesOf(body, Which::Sharp);
      std::vector<Segment> after = edgesOf(outcome.mesh, Which::Sharp);
      for (const Vec3& tip : tips) {
        CHECK(contains(outcome.mesh, tip));
        after = withoutThoseAround(tip, shapes::meanEdge(outcome.mesh), after);
      }
      CHECK(outcome.mesh.positions.size() == vertices);
      for (const Vec3& corner : cornersOf(before)) CHECK(contains(outcome.mesh, corner));
      for (const auto& [a, b] : after) {
        CHECK(distance(a, before) < 1e-6 * diagonal);
        CHECK(distance(b, before) < 1e-6 * diagonal);
      }
      // An arc between two vertices of a round rim bulges out by its length² / 8 radii: 600
      // vertices are as far apart as 0.15 of the radius.
      const double bulge = vertices < 1000 ? 3e-3 : 1e-3;
      CHECK(farthest(before, after) < bulge * diagonal);
      CHECK(farthest(after, before) < bulge * diagonal);
    }
}

TEST_CASE("curves: the straight edges and planes of a cube stay exactly straight and plane") {
  const TriangleMesh body = shapes::cube(6);
  const RemeshOutcome outcome = run(body, 1500);
  const std::vector<Segment> before = edgesOf(body, Which::Sharp),
                             after = edgesOf(outcome.mesh, Which::Sharp);
  CHECK(farthest(before, after) < 1e-12);
  CHECK(farthest(after, before) < 1e-12);
  for (const Vec3& p : outcome.mesh.positions) {
    double off = 6;
    for (int axis = 0; axis < 3; ++axis)
      off = std::min({off, std::abs(p[axis]), std::abs(6 - p[axis])});
    CHECK(off < 1e-12);
  }
}

TEST_CASE("curves: the planes of a blade stay plane, however often it is remeshed") {
  // A walk over an edge of 22° may end at the foot of a perpendicular, inside the other side.
  const TriangleMesh body = blade();
  for (const Index vertices : {80, 110, 200}) {
    const TriangleMesh once = run(body, vertices).mesh;
    for (const Index again : {vertices, 2 * vertices}) {
      CAPTURE(vertices);
      CAPTURE(again);
      for (const Vec3& p : run(once, again).mesh.positions) CHECK(fromSides(p) < 1e-12);
    }
  }
}

TEST_CASE("curves: a kept boundary comes out bit for bit, however many vertices are asked for") {
  const TriangleMesh mesh = hills();
  const auto before = asSet(edgesOf(mesh, Which::Open));
  PartOptions options;
  options.boundary = Boundary::Keep;
  for (const Scheme scheme : {Scheme::Best, Scheme::Rounds})
    for (const Index vertices : {300, 900}) {
      CAPTURE(vertices);
      options.scheme = scheme;
      const RemeshOutcome outcome = run(mesh, vertices, options);
      CHECK(outcome.stopped == Stopped::Target);
      CHECK(outcome.mesh.positions.size() == vertices);
      CHECK(asSet(edgesOf(outcome.mesh, Which::Open)) == before);
    }
}

TEST_CASE("curves: beside a kept boundary of long edges triangles grow to match") {
  PartOptions options;
  options.boundary = Boundary::Keep;
  const TriangleMesh mesh = run(hills(), 4000, options).mesh;
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const Index v : mesh.indices) ++faces[v];
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto corner = [&](std::size_t k) { return mesh.indices[3 * t + k]; };
    // The outline alone decides the shape of a triangle that has a corner of it to itself.
    if (faces[corner(0)] == 1 || faces[corner(1)] == 1 || faces[corner(2)] == 1) continue;
    const auto at = [&](std::size_t k) { return mesh.positions[corner(k)]; };
    CHECK(minAngle(at(0), at(1), at(2)) > radians(25));
  }
}

TEST_CASE("curves: a resampled boundary follows the one it had, corners included") {
  const TriangleMesh mesh = hills();
  const double diagonal = 24 * std::sqrt(2.0);
  const std::vector<Segment> before = edgesOf(mesh, Which::Open);
  for (const Index vertices : {700, 1800}) {
    const RemeshOutcome outcome = run(mesh, vertices);
    const std::vector<Segment> after = edgesOf(outcome.mesh, Which::Open);
    CHECK(farthest(before, after) < 0.01 * diagonal);
    for (const auto& [a, b] : after) CHECK(distance(a, before) < 1e-6 * diagonal);
    for (const Vec3& corner : cornersOf(before)) CHECK(contains(outcome.mesh, corner));
  }
}

TEST_CASE("curves: between two side by side vertices lie in gaps") {
  // A band as wide as equilateral triangles with edges 1.15 are high: two rows of vertices.
  TriangleMesh band = shapes::grid(60, 1);
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : band.positions) {
    uv.values.push_back(float(p.x()) / 60);
    uv.values.push_back(float(p.y()));
  }
  band.attributes.push_back(std::move(uv));
  PartOptions options;
  options.vertices = 2 * 53;
  const TriangleMesh mesh = remeshSurface(band, options, {}).mesh;
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[3 * t + k]]; };
    sum += minAngle(at(0), at(1), at(2));
  }
  // 60° but at the two ends; one row straight above the other would give 41°.
  CHECK(sum / double(mesh.triangleCount()) > radians(54));
}

TEST_CASE("curves: the number that is named where vertices are too few is enough") {
  // Columns of several heights: the more vertices, the more of their edges are kept.
  const TriangleMesh columns =
      shapes::cells(8, [](int x, int y, int z) { return z < 1 + (x * 5 + y * 3) % 7; });
  PartOptions options;
  options.vertices = 60;
  std::size_t needed = 0;
  try {
    remeshSurface(columns, options, {});
  } catch (const TooFewVertices& error) {
    CHECK(error.code == ErrorCode::TargetBelowCurves);
    CHECK(error.hint.find(std::to_string(error.needed)) != std::string::npos);
    needed = error.needed;
  }
  REQUIRE(needed > 60);
  options.vertices = Index(needed);
  CHECK_NOTHROW(remeshSurface(columns, options, {}));
}

TEST_CASE("curves: where three sheets meet in short edges quads are square, and their sides long") {
  TriangleMesh sheets;
  for (int sheet = 0; sheet < 3; ++sheet) {
    const TriangleMesh flat = shapes::grid(20, 20);
    const double angle = radians(120) * sheet;
    for (const Index v : flat.indices) {
      const Vec3& p = flat.positions[v];
      sheets.indices.push_back(Index(sheets.positions.size()));
      sheets.positions.emplace_back(p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
    }
  }
  PartOptions options;
  options.quads = true;
  options.vertices = 200;
  const TriangleMesh mesh = remeshSurface(sheets, options, {}).mesh;
  const double side = std::sqrt(3 * 20.0 * 20.0 / 200);
  const std::vector<Index> quads = quadsOf(mesh);
  for (std::size_t q = 0; q < quads.size(); q += 4) {
    Quad corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.positions[quads[q + i]];
    CHECK(leastSine(corners) > 0.99);
    for (std::size_t i = 0; i < 4; ++i)
      CHECK((corners[(i + 1) % 4] - corners[i]).norm() > side / 2);
  }
}

TEST_CASE("curves: quads of thin boxes that touch along an edge stay within them") {
  constexpr double kThin = 0.1481337323319621;
  TriangleMesh boxes;
  boxes.positions = {{0, 1, 0}, {0, 1, kThin}, {0, 0, 0},     {0, 0, kThin}, {1, 0, 0},
                     {2, 2, 0}, {1, 1, 0},     {1, 1, kThin}, {1, 2, 0},     {1, 2, kThin},
                     {2, 1, 0}, {2, 1, kThin}, {2, 2, 0},     {2, 2, kThin}};
  boxes.indices = {0, 2, 3,  0, 3,  1,  4,  6,  7,  4,  7,  5,  3, 2,  4,  3, 4,  5,
                   0, 1, 7,  0, 7,  6,  4,  2,  0,  4,  0,  6,  3, 5,  7,  3, 7,  1,
                   8, 6, 7,  8, 7,  9,  10, 12, 13, 10, 13, 11, 7, 6,  10, 7, 10, 11,
                   8, 9, 13, 8, 13, 12, 10, 6,  8,  10, 8,  12, 7, 11, 13, 7, 13, 9};
  PartOptions options;
  options.quads = true;
  options.vertices = 14;
  const TriangleMesh mesh = remeshSurface(boxes, options, {}).mesh;
  CHECK(mesh.isQuads);
  for (const Vec3& p : mesh.positions) {
    CHECK(p.minCoeff() > -0.2);
    CHECK(p.maxCoeff() < 2.2);
    CHECK(p.z() < 2 * kThin);
  }
}
