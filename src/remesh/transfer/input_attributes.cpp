// SPDX-License-Identifier: MIT
#include "remesh/transfer/input_attributes.h"

#include <utility>

#include "remesh/transfer/attribute_transfer.h"

namespace remesher {

namespace {

OriginalSurface withoutCurves(BuiltMesh built) {
  FeatureCurves curves(built.mesh, built.positions, {});
  return {std::move(built), std::move(curves)};
}

std::vector<Index> allCorners(const HalfedgeMesh& mesh) {
  std::vector<Index> corners;
  for (Index f = 0; f < mesh.faceCapacity(); ++f)
    for (const Vertex v : mesh.vertices(Face(f))) corners.push_back(v.index);
  return corners;
}

}  // namespace

InputAttributes::InputAttributes(const TriangleMesh& input, BuiltMesh built,
                                 std::vector<std::string> chartless)
    : input_(input),
      chartless_(std::move(chartless)),
      surface_(withoutCurves(std::move(built))),
      mix_(input, chartless_),
      tree_(surface_.positions().values(), allCorners(surface_.mesh()),
            TriangleTree::Listed::Anyhow),
      faces_(input.triangleCount()) {
  for (Index f = 0; f < surface_.mesh().faceCapacity(); ++f)
    faces_[InputTriangle(surface_.built().triangles[Face(f)])] = Face(f);
}

Vec3 InputAttributes::position(InputTriangle triangle, const Vec3& weights) const {
  const Index* const corners = &input_.indices[cornerOf(triangle, 0)];
  return weights[0] * input_.positions[corners[0]] + weights[1] * input_.positions[corners[1]] +
         weights[2] * input_.positions[corners[2]];
}

Face InputAttributes::faceNear(const Vec3& p) const { return Face(tree_.tree.nearest(p).triangle); }

InputPlace InputAttributes::placeIn(Face face, const Vec3& p) const {
  const auto [a, b, c] = surface_.mesh().vertices(face);
  const VertexData<Vec3>& at = surface_.positions();
  return inputPlace({face, closestBarycentric(p, at[a], at[b], at[c])}, surface_.built(), input_);
}

// The builder may have turned the triangle over.
SurfacePoint InputAttributes::pointOf(const InputPlace& place, Face face) const {
  SurfacePoint point{face, Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Index wedge = surface_.built().wedges[HalfedgeMesh::halfedge(face, i)];
    for (Index k = 0; k < 3; ++k)
      if (input_.indices[cornerOf(place.triangle, k)] == wedge)
        point.barycentric[i] = place.weights[k];
  }
  return point;
}

void InputAttributes::append(const InputPlace& place, std::vector<Attribute>& values) const {
  const Face face = faces_[place.triangle];
  Index nearest = 0;
  place.weights.maxCoeff(&nearest);
  if (face && place.weights[nearest] < 1)
    return mix_.append(mixPoint(surface_, pointOf(place, face), mix_), values);
  const std::size_t wedge = input_.indices[cornerOf(place.triangle, nearest)];
  for (std::size_t a = 0; a < values.size(); ++a) {
    const std::vector<float>& all = input_.attributes[a].values;
    const auto first = all.begin() + std::ptrdiff_t(wedge * values[a].itemSize);
    values[a].values.insert(values[a].values.end(), first, first + values[a].itemSize);
  }
}

}  // namespace remesher
