// SPDX-License-Identifier: MIT
#include "remesh/quads/map/seamless_system.h"

#include <doctest/doctest.h>

#include <cmath>

#include "remesh/quads/field/singularities.h"
#include "support/soups.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct Equations {
  explicit Equations(const TriangleMesh& input)
      : surface(shapes::surfaceOf(input)),
        mesh(surface),
        frames(mesh),
        field(makeCrossField(mesh, frames, 0.3)),
        singular(quarterIndices(field, mesh, frames)),
        cut(cutOpen(mesh, field, singular)),
        system({mesh, frames, cut, singular}) {
    REQUIRE(system.isSolvable());
  }

  // u or v at a corner.
  double valueOf(Halfedge h, std::size_t axis, const Eigen::VectorXd& values) const {
    double sum = 0;
    for (const auto& [variable, coefficient] : system.corner(h)[axis])
      sum += coefficient * values[variable];
    return sum;
  }

  // How much the gradients of u and v differ from the crosses, as half the square over the area.
  double misfit(const Eigen::VectorXd& values) const {
    double sum = 0;
    for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
      const Halfedge h = HalfedgeMesh::halfedge(Face(f)), next = HalfedgeMesh::next(h);
      const Vec2 first = frames.edge(h), second = frames.edge(next);
      const double angle = cut.angle[Face(f)], area = cross(first, second) / 2;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double a = valueOf(next, axis, values) - valueOf(h, axis, values);
        const double b = valueOf(HalfedgeMesh::prev(h), axis, values) - valueOf(next, axis, values);
        const Vec2 across = second * a - first * b;
        const Vec2 gradient = Vec2(across.y(), -across.x()) / (2 * area);
        const Vec2 wanted = axis == 0 ? Vec2(std::cos(angle), std::sin(angle))
                                      : Vec2(-std::sin(angle), std::cos(angle));
        sum += area / 2 * (gradient - wanted).squaredNorm();
      }
    }
    return sum;
  }

  OriginalSurface surface;
  WorkingMesh mesh;
  FaceFrames frames;
  CrossField field;
  VertexData<int> singular;
  CutField cut;
  SeamlessSystem system;
};

std::vector<TriangleMesh> someShapes() {
  return {shapes::icosphere(5), shapes::torus(24, 12), shapes::cube(4), shapes::boxWithHole()};
}

}  // namespace

TEST_CASE("seamless_system: a coordinate has at most one real variable, so that entries are few") {
  for (const TriangleMesh& shape : someShapes()) {
    const Equations equations(shape);
    const SeamlessSystem& system = equations.system;
    for (Index h = 0; h < equations.mesh.mesh().halfedgeCapacity(); ++h)
      for (const IntegerSum& sum : system.corner(Halfedge(h)))
        CHECK((sum.size() < 2 || sum[1].first >= system.realCount()));
  }
}

TEST_CASE("seamless_system: the quadratic measures how far the map's gradients are from crosses") {
  soups::Random random(5);
  for (const TriangleMesh& shape : someShapes()) {
    const Equations equations(shape);
    const FaceData<double> even(equations.mesh.mesh().faceCapacity(), 1.0);
    const auto [matrix, right] = equations.system.quadratic(even);
    Eigen::VectorXd values(right.size());
    const double none = equations.misfit(Eigen::VectorXd::Zero(right.size()));
    for (double& value : values) value = 4 * (random.number() - 0.5);
    const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Lower>() * values;
    const double measured = values.dot(product) / 2 - right.dot(values);
    CHECK(measured == doctest::Approx(equations.misfit(values) - none));
  }
}
