// SPDX-License-Identifier: MIT
// Where parts are looked at: each where the file shows most of it. What the file does not show, for
// its node has no size, or no scene has one, is looked at in the size that the others are shown at.
#pragma once

#include <optional>
#include <vector>

#include "io/model/model.h"

namespace remesher {

struct PartPlace {
  Transform toWorld = Transform::Identity();
  double area = 0;  // the mean over the places where the part is shown
};

// Of valid parts.
std::vector<PartPlace> placesOf(const std::vector<io::Part>& parts);

// What makes a part look as it does there but for its size and how it is turned, of determinant 1;
// none if the part looks so itself, or has no shape there.
std::optional<Eigen::Matrix3d> stretchAt(const Transform& toWorld);

// The part's mesh, its normals and tangents with it, stretched by such a matrix.
TriangleMesh stretched(TriangleMesh mesh, const Eigen::Matrix3d& stretch);

// A result of remeshing stretched(original, stretch), as it is without. What lies where the
// original has a vertex has the original's coordinates.
TriangleMesh relaxed(TriangleMesh result, const Eigen::Matrix3d& stretch,
                     const TriangleMesh& original);

// The parts that are looked at stretched so; the others as they are.
std::vector<io::Part> asShown(std::vector<io::Part> parts);

}  // namespace remesher
