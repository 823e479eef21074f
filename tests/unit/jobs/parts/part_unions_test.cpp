// SPDX-License-Identifier: MIT
#include "jobs/parts/part_unions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "measure/mesh_report.h"
#include "remesher.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A tile of the ground of so many cells, from x on; a strip has one row of them across its width.
TriangleMesh strip(double x, int cells, double width) {
  const int across = width < 1 ? 1 : cells;
  TriangleMesh mesh;
  shapes::addSheet(mesh, across, cells, [&](int column, int row) {
    const double u = x + width * column / across, v = double(row) / cells;
    return Vec3(u, v, 0.2 * std::sin(3 * u) * std::cos(5 * v));
  });
  return mesh;
}

TriangleMesh tile(double x, int cells) { return strip(x, cells, 1); }

Transform somewhere() {
  Transform place = Transform::Identity();
  place.translate(Vec3(3, -1, 0.1)).rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 2).normalized()));
  return place;
}

// A part that looks so at the place.
io::Part partAt(TriangleMesh mesh, const Transform& place) {
  for (Vec3& p : mesh.positions) p = place.inverse() * p;
  if (place.linear().determinant() < 0)
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return {"", std::move(mesh), {place}};
}

// Where a result crosses the plane in which two tiles meet, by y and z.
std::vector<Vec3> seamOf(const TriangleMesh& mesh, const Transform& place) {
  std::vector<Vec3> seam;
  for (const Vec3& p : mesh.positions)
    if (const Vec3 q = place * p; std::abs(q.x() - 1) < 1e-9) seam.push_back(q);
  std::sort(seam.begin(), seam.end(), [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  return seam;
}

std::size_t surfacesOf(const std::vector<io::Part>& parts) {
  return PartUnions(parts, Held::Apart, {}).surfaces().size();
}

}  // namespace

TEST_CASE("part_unions: tiles that meet still do, wherever each is kept") {
  Transform mirrored = Transform::Identity();
  mirrored.linear() = Vec3(-2, 1, 0.5).asDiagonal();
  for (const Transform& place : {Transform::Identity(), somewhere(), mirrored}) {
    const io::Part left = partAt(tile(0, 20), Transform::Identity());
    const io::Part right = partAt(tile(1, 20), place);
    for (const Index count : {80U, 300U, 1500U}) {
      PartOptions options;
      options.vertices = count;
      const RemeshSceneResult result =
          remeshScene({{left.mesh, left.instances}, {right.mesh, right.instances}}, options, {});
      CHECK(result.report.output->vertices == count);
      const std::vector<Vec3> a = seamOf(result.meshes[0], Transform::Identity());
      const std::vector<Vec3> b = seamOf(result.meshes[1], place);
      CHECK(a.size() > 2);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() < 1e-12);
    }
  }
}

TEST_CASE("part_unions: where the shape is preferred, tiles are simplified and still meet") {
  // A narrow tile, which most of a budget would leave without triangles, between two wide ones.
  io::Part left = partAt(tile(0, 20), Transform::Identity());
  const io::Part right = partAt(tile(1, 20), somewhere());
  const io::Part narrow = partAt(strip(2, 20, 0.01), Transform::Identity());
  Attribute texcoords{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : left.mesh.positions)
    texcoords.values.insert(texcoords.values.end(), {float(p.x()), float(p.y())});
  for (const bool isTextured : {false, true}) {
    if (isTextured) left.mesh.attributes.push_back(texcoords);
    for (const Index count : {13U, 40U, 81U, 701U}) {
      PartOptions options;
      options.vertices = count;
      options.prefer = Prefer::Shape;
      const RemeshSceneResult result = remeshScene({{left.mesh, left.instances},
                                                    {right.mesh, right.instances},
                                                    {narrow.mesh, narrow.instances}},
                                                   options, {});
      CAPTURE(count);
      CHECK(result.report.output->vertices == count);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(result.report.prefer[i] == Prefer::Shape);
        CHECK(result.meshes[i].triangleCount() > 0);
      }
      const std::vector<Vec3> a = seamOf(result.meshes[0], Transform::Identity());
      const std::vector<Vec3> b = seamOf(result.meshes[1], somewhere());
      CHECK(a.size() >= 2);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() < 1e-12);
    }
  }
}

TEST_CASE("part_unions: where vertices stay they have their own coordinates") {
  const io::Part left = partAt(tile(0, 4), Transform::Identity());
  const io::Part right = partAt(tile(1, 4), somewhere());
  const RemeshSceneResult result =
      remeshScene({{left.mesh, left.instances}, {right.mesh, right.instances}}, {}, {});
  CHECK(result.report.output->vertices == 50);
  for (const Vec3& corner : {right.mesh.positions.front(), right.mesh.positions.back()}) {
    const auto& positions = result.meshes[1].positions;
    CHECK(std::find(positions.begin(), positions.end(), corner) != positions.end());
  }
}

TEST_CASE("part_unions: attributes and groups of one stay its own") {
  io::Part left = partAt(tile(0, 10), Transform::Identity());
  io::Part right = partAt(tile(1, 10), Transform::Identity());
  Attribute colors{"COLOR_0", 3, {}};
  for (std::size_t i = 0; i < right.mesh.positions.size(); ++i)
    colors.values.insert(colors.values.end(), {0.25F, 0.5F, 0.75F});
  right.mesh.attributes.push_back(colors);
  for (Index t = 0; t < right.mesh.triangleCount(); ++t)
    right.mesh.groups.push_back(t < 100 ? 0 : 1);
  const RemeshSceneResult result =
      remeshScene({{left.mesh, left.instances}, {right.mesh, right.instances}}, {}, {});
  CHECK(result.meshes[0].attributes.empty());
  CHECK(result.meshes[0].groups.empty());
  CHECK(groupCount(result.meshes[1]) == 2);
  for (std::size_t i = 0; i < result.meshes[1].positions.size(); ++i)
    CHECK(std::abs(result.meshes[1].attributes[0].values[3 * i + 1] - 0.5F) < 1e-6F);
}

TEST_CASE("part_unions: only what is a surface together is one") {
  const io::Part left = partAt(tile(0, 6), Transform::Identity());
  const io::Part right = partAt(tile(1, 6), somewhere());
  CHECK(surfacesOf({left, right}) == 1);
  CHECK(surfacesOf({left, right, partAt(tile(2, 6), Transform::Identity())}) == 1);
  CHECK(surfacesOf({left, partAt(tile(2, 6), Transform::Identity())}) == 2);
  io::Part back = left;  // the other side of a leaf
  for (std::size_t i = 0; i < back.mesh.indices.size(); i += 3)
    std::swap(back.mesh.indices[i], back.mesh.indices[i + 1]);
  CHECK(surfacesOf({left, back}) == 2);
  CHECK(surfacesOf({left, left}) == 2);
  io::Part turned = right;  // beside it, facing away
  for (std::size_t i = 0; i < turned.mesh.indices.size(); i += 3)
    std::swap(turned.mesh.indices[i], turned.mesh.indices[i + 1]);
  CHECK(surfacesOf({left, turned}) == 2);
  io::Part wall = right;  // a third along the same edge
  for (Vec3& p : wall.mesh.positions) {
    const Vec3 q = wall.instances.front() * p;
    p = wall.instances.front().inverse() * Vec3(1, q.y(), q.z() + q.x() - 1);
  }
  CHECK(surfacesOf({left, right, wall}) == 3);
  io::Part twice = right;
  twice.instances.push_back(Transform::Identity());
  CHECK(surfacesOf({left, twice}) == 2);
}
