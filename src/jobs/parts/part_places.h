// SPDX-License-Identifier: MIT
// Where parts are looked at: each at the place where the file shows it largest. A part that the
// file does not show (its node has no size or is in no scene) is scaled like the others on average.
#pragma once

#include <optional>
#include <vector>

#include "io/model/model.h"

namespace remesher {

struct PartPlace {
  Transform toWorld = Transform::Identity();
  double area = 0;  // the mean over the places where the part is shown
  // How many times as long as there any place may show a length of the part: above 1 only where
  // another place stretches it in other directions.
  double elsewhere = 1;
};

// From the part's space to the world, at the first place where the file shows it; a part without a
// place is where it is.
Transform firstPlace(const io::Part& part);

// A place of the part, there.
Vec3 inWorldOf(const io::Part& part, const Vec3& p);

// The place where the file shows the part largest; the first if it shows it nowhere.
Transform largestPlace(const io::Part& part);

// How many times as long as in the part's own space any place may show a length of it.
double longestOf(const io::Part& part);

// The parts must be valid.
std::vector<PartPlace> placesOf(const std::vector<io::Part>& parts);

// The stretch of the part at that place without size and rotation, of determinant 1; none if the
// part is not stretched there, or has no shape there.
std::optional<Eigen::Matrix3d> stretchAt(const Transform& toWorld);

// The part's mesh stretched by such a matrix, with its normals and tangents.
TriangleMesh stretched(TriangleMesh mesh, const Eigen::Matrix3d& stretch);

// Undoes the stretch in a result of remeshing stretched(original, stretch). A vertex at an original
// vertex gets exactly its coordinates.
TriangleMesh relaxed(TriangleMesh result, const Eigen::Matrix3d& stretch,
                     const TriangleMesh& original);

}  // namespace remesher
