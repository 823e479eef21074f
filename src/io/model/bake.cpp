// SPDX-License-Identifier: MIT
#include "io/model/bake.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "io/model/appending.h"
#include "mesh/joining.h"

namespace remesher::io {
namespace {

void transformDirections(Attribute& attribute, const Eigen::Matrix3d& matrix) {
  const std::size_t stride = attribute.itemSize;
  if (stride < 3) return;
  for (std::size_t at = 0; at + stride <= attribute.values.size(); at += stride) {
    Eigen::Map<Eigen::Vector3f> direction(&attribute.values[at]);
    const Vec3 turned = (matrix * direction.cast<double>()).stableNormalized();
    if (turned.allFinite() && !turned.isZero(0)) direction = turned.cast<float>();
  }
}

// A vertex without a normal gets the mean of those of its triangles, by area.
void fillNormals(TriangleMesh& mesh) {
  const auto normals =
      std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                   [](const Attribute& a) { return a.semantic == "NORMAL" && a.itemSize == 3; });
  if (normals == mesh.attributes.end()) return;
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3& a = mesh.positions[mesh.indices[i]];
    const Vec3 area =
        (mesh.positions[mesh.indices[i + 1]] - a).cross(mesh.positions[mesh.indices[i + 2]] - a);
    for (std::size_t k = 0; k < 3; ++k) sums[mesh.indices[i + k]] += area;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    Eigen::Map<Eigen::Vector3f> normal(&normals->values[3 * v]);
    const Vec3 mean = sums[v].stableNormalized();
    if (normal.isZero(0) && mean.allFinite()) normal = mean.cast<float>();
  }
}

// Whether the instance shows areas, not just lines or points.
bool showsAreas(const Transform& instance) {
  const Eigen::Matrix3d m = instance.linear();
  return !m.col(0).cross(m.col(1)).isZero(0) || !m.col(1).cross(m.col(2)).isZero(0) ||
         !m.col(2).cross(m.col(0)).isZero(0);
}

bool isWhereItIs(const Transform& instance) {
  return instance.isApprox(Transform::Identity(), 0.0);
}

}  // namespace

void transformMesh(TriangleMesh& mesh, const Transform& transform) {
  unifyPlaces(mesh.positions);  // what is rounding around zero is none elsewhere
  for (Vec3& position : mesh.positions) position = transform * position;
  // Directions do not depend on the matrix's size, so it is scaled first: otherwise its determinant
  // could overflow or vanish.
  const double size = transform.linear().cwiseAbs().maxCoeff();
  const Eigen::Matrix3d linear = transform.linear() / (size > 0 ? size : 1.0);
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.semantic == "NORMAL")
      transformDirections(attribute, linear.inverse().transpose());
    if (attribute.semantic == "TANGENT") transformDirections(attribute, linear);
  }
  if (linear.determinant() >= 0) return;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  // In a quad turned over the second triangle comes first.
  for (std::size_t i = 0; mesh.isQuads && i + 5 < mesh.indices.size(); i += 6)
    std::swap_ranges(&mesh.indices[i], &mesh.indices[i] + 3, &mesh.indices[i] + 3);
}

void makeBodies(Model& model) {
  std::vector<Part> bodies;
  std::size_t unseen = 0;
  for (Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    const std::size_t before = bodies.size(), shown = part.instances.size() - part.hidden;
    for (std::size_t i = 0; i < shown; ++i) {
      const Transform& instance = part.instances[i];
      if (!showsAreas(instance)) continue;
      bodies.push_back({part.name, part.mesh, {Transform::Identity()}, part.groups});
      bodies.back().mesh.steps.reset();
      if (isWhereItIs(instance)) continue;
      joinNoise(bodies.back().mesh);
      transformMesh(bodies.back().mesh, instance);
      bodies.back().mesh.isSingle = false;
    }
    unseen += std::max<std::size_t>(part.instances.size(), 1) - (bodies.size() - before);
    part = {};
  }
  model.parts = std::move(bodies);
  if (unseen > 0)
    model.warnings.push_back(
        {"HIDDEN_LEFT_OUT",
         "What the scene does not show is left out: write a .glb or .gltf to keep it.", unseen});
}

std::vector<Part> bakeInstances(const Model& model) {
  std::vector<Part> baked;
  for (const Part& part : model.parts) {
    if (!part.finer.empty()) continue;
    for (const Transform& instance : part.instances) {
      baked.push_back({part.name,
                       converted(part.mesh, model.conventions, Conventions::Classic),
                       {Transform::Identity()},
                       part.groups});
      if (!isWhereItIs(instance)) transformMesh(baked.back().mesh, instance);
    }
  }
  if (baked.empty())
    throw Error(ErrorCode::NoTriangles, "The file shows no triangles to write.",
                "Write a .glb or .gltf, which keep what is not shown.");
  return baked;
}

TriangleMesh mergeParts(const std::vector<Part>& parts) {
  TriangleMesh merged;
  for (Index number = 0; number < parts.size(); ++number) {
    appendMesh(merged, parts[number].mesh);
    merged.groups.resize(merged.indices.size() / 3, number);
  }
  if (parts.empty()) return merged;
  merged.isQuads =
      std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.mesh.isQuads; });
  merged.isSingle =
      std::all_of(parts.begin(), parts.end(), [](const Part& part) { return part.mesh.isSingle; });
  fillNormals(merged);
  return merged;
}

}  // namespace remesher::io
