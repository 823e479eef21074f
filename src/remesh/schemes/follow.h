// SPDX-License-Identifier: MIT
// Another way to few vertices: instead of isotropic triangles, the vertices of the original that
// its shape needs most. Hand-made models have bevels and tubes thinner than an even triangle of the
// result; isotropic triangles lose them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/input_place.h"
#include "base/part_options.h"
#include "base/triangle_mesh.h"
#include "geometry/mesh_tree.h"
#include "mesh/mesh_builder.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

// The number of distinct vertex positions: below the number of vertices where the builder cut the
// input apart.
std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

// The same; a position counts once in every body that has it. bodies: per face.
std::size_t distinctPositions(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                              const FaceData<Index>& bodies);

// How far a surface is from another, over its samples.
struct Away {
  double rms;  // over its area
  double farthest;
};

struct Followed {
  TriangleMesh mesh;
  std::vector<InputPlace> places;  // per corner of its triangles
  std::size_t positions = 0;       // distinct ones, of those that simplification has left
  Away away;                       // the original from the mesh
};

// The edges across which an attribute jumps, or the group changes. Jumps of normals do not count
// unless textures are baked: a result that keeps attributes has normals of its own.
HalfedgeData<char> seamsOf(const BuiltMesh& built, const TriangleMesh& input, Textures textures);

// Whether a triangle has no area.
bool hasDegenerate(const TriangleMesh& mesh);

// Whether the original has so few vertices, at most 32 per position, that its own triangles show.
// If the caller prefers shape, `follow` is tried without this test.
bool isWorthFollowing(const BuiltMesh& original, std::size_t positions);

struct FollowRule {
  Textures textures;           // kept, so that vertices stay where they are, or baked anew
  bool mayBeOriginal = false;  // if nothing is to go and textures are baked: the original, or none
  TooFew tooFew = TooFew::Refuse;      // if no further vertex can go: none, or the mesh by then
  std::span<const Index> bodies = {};  // per input group its body; each counts its own positions
};

// A mesh with exactly so many distinct positions. None if the original has fewer.
std::optional<Followed> follow(const BuiltMesh& original, const TriangleMesh& input,
                               std::size_t positions, const FollowRule& rule);

// For each position that follow() can take from the original, in about its order: how much the
// shape has changed by then, as collapseCosts() says. Where vertices share a position, it takes
// both.
std::vector<double> followCosts(const BuiltMesh& original, const TriangleMesh& input,
                                Textures textures);

// The points at which a surface is sampled: about so many of its triangles, at even steps, and so
// many points of each, at most 4.
struct Samples {
  std::size_t triangles, ofEach;
};
constexpr Samples kTelling = {20'000, 4};

Away awayFrom(const MeshTree& other, const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
              const Samples& samples = kTelling);

}  // namespace remesher
