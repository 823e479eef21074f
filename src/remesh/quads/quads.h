// SPDX-License-Identifier: MIT
// From isotropic triangles to quads alone, in two ways. A seamless map takes the triangles to the
// plane; its unit squares are the quads. Where the map does not give a connected part a surface of
// the same kind, divided pairs of triangles do, which always works.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/part_options.h"
#include "base/patience.h"
#include "base/report.h"
#include "remesh/quads/field/cross_field.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

struct MadeQuads {
  QuadMesh mesh;
  std::size_t parts = 0;  // connected parts
  std::vector<PairedPart> paired = {};
  std::size_t collapsed = 0;  // quads taken out to reach the number
  double away = 0;            // in sides, of a few vertices only; 0 if they are near
};

// Makes even, compact triangle meshes of about so many vertices, all on the same surface.
using TriangleMaker = std::function<WorkingMesh(std::size_t vertices)>;

// A number that is not to be exact is met within this share.
constexpr double kCountTolerance = 0.01;
// By up to this share it is missed rather than met with more irregular vertices: whole rows of
// quads make none, but only some numbers.
constexpr double kFreeTolerance = 0.04;

// So few vertices are compared by their distance with others of about the same number: maps of
// neighbouring numbers may be quite different.
constexpr std::size_t kFewToFinish = 512;

struct QuadGoal {
  std::size_t vertices = 0;        // of the whole
  bool isExact = false;            // else within kCountTolerance, or kFreeTolerance
  Mirrors mirrors = {};            // the mesh is a half of the whole, cut off along these planes
  bool isGraded = false;           // sizes of quads vary as those of the triangles
  bool isDraft = false;            // on fewer triangles, and lost tips stay lost
  bool isPart = false;             // one of several connected parts: on fewer triangles
  double share = 1;                // of a part: of the vertices, and of the work, of all parts
  bool isForced = false;           // the half is to be mirrored, whatever that costs
  std::vector<Guide> guides = {};  // lines on the surface that lead the cross field
};

// The number of vertices of the whole: those on a plane are their own image.
std::size_t wholeCount(const QuadMesh& mesh, const Mirrors& mirrors);

// Makes quads from the meshes that `triangles` makes.
MadeQuads makeQuads(const QuadGoal& goal, const TriangleMaker& triangles);

// Per face of a mesh the side length of quads wanted there beside the others.
using SizeMaker = FaceData<double>(const WorkingMesh& mesh);

// Where quads are missing along the border, a map fails, or the quads beside are drawn to the
// border.
enum class Tears { Refused, Closed };

// Quads by the map, for one connected part; no quads if the map fails.
QuadMesh mapToQuads(const WorkingMesh& part, double vertices, SizeMaker& sizesOn, WorkBudget& work,
                    Tears tears = Tears::Refused, const FieldWishes& wishes = {});

}  // namespace remesher
