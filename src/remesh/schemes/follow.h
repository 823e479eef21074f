// SPDX-License-Identifier: MIT
// The other way to few vertices: not even triangles, but those vertices of the original that its
// shape needs most. What was modelled by hand has bevels and tubes thinner than an even triangle of
// the result, and is lost in that.
#pragma once

#include <optional>
#include <vector>

#include "base/input_place.h"
#include "base/options.h"
#include "base/triangle_mesh.h"
#include "geometry/mesh_tree.h"
#include "mesh/mesh_builder.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

// How many different places the vertices have: fewer than there are vertices where the builder cut
// the input apart.
std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

struct Followed {
  TriangleMesh mesh;
  std::vector<InputPlace> places;  // per corner of its triangles
  double distance;                 // of the original from it, rms
};

// Whether the original's own triangles show at so few vertices, if not that many are wished for.
bool isWorthFollowing(const BuiltMesh& original, std::size_t positions);

// With exactly so many distinct positions; none where the original has fewer (of what is painted
// anew: no more), or where nothing else goes. textures: whether attributes are to be kept, for
// which vertices stay where they are, or painted anew.
std::optional<Followed> follow(const BuiltMesh& original, const TriangleMesh& input,
                               std::size_t positions, Textures textures);

// From where a surface is looked at: about so many of its triangles, at even steps, and so many
// points of each, at most 4.
struct Samples {
  std::size_t triangles, ofEach;
};
constexpr Samples kTelling = {20'000, 4};

// The root of the mean square, over the original's area, of its distance to a mesh.
double distanceTo(const MeshTree& mesh, const BuiltMesh& original,
                  const Samples& samples = kTelling);

}  // namespace remesher
