// SPDX-License-Identifier: MIT
// The outside of what a surface encloses, as one clean closed surface.
#pragma once

#include <memory>

#include "base/triangle_mesh.h"

namespace remesher {

// What is enclosed, and by what.
struct Enclosure {
  std::size_t turned = 0;     // triangles that faced the other way
  std::size_t shells = 0;     // closed pieces that nobody sees, gone
  std::size_t inner = 0;      // of these, those that face outwards: no walls of cavities
  std::size_t insideOut = 0;  // closed pieces that are seen and face inwards
  double lost = 0;            // percent of what is seen from along the axes and not on the result
  double unsure = 0;   // of the points beside the surface, the share whose side is in dispute
  bool isAny = false;  // whether anything is enclosed
};

struct Solid {
  TriangleMesh mesh;  // without triangles if nothing is enclosed
  Enclosure enclosure;
};

// How inside is told from outside: enclosed by triangles that face outwards; or not to be reached
// from outside through openings wider than a gap.
enum class InsideBy { Enclosure, Reach };

// Whether triangles that show no more than their neighbours do are taken out, which takes several
// times as long as all else: for whoever keeps the mesh as it is.
enum class Cleaning { None, Thorough };

struct SolidRule {
  double spacing;  // between the points at which it is told; what is thinner becomes as thick
  InsideBy by = InsideBy::Enclosure;
  double gap = 0;  // a length, for Reach
  Cleaning cleaning = Cleaning::None;
};

// A surface of which it is known what lies inside. The input has to outlive it.
class SolidGround {
 public:
  // Throws Error as buildMesh does.
  SolidGround(const TriangleMesh& input, const SolidRule& rule);
  ~SolidGround();

  Enclosure enclosure() const;

  // To be asked for once.
  Solid solid();

 private:
  struct Known;
  const std::unique_ptr<Known> known_;
};

inline Enclosure enclosureOf(const TriangleMesh& input, const SolidRule& rule) {
  return SolidGround(input, rule).enclosure();
}

inline Solid solidOf(const TriangleMesh& input, const SolidRule& rule) {
  return SolidGround(input, rule).solid();
}

}  // namespace remesher
