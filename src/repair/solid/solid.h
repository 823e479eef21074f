// SPDX-License-Identifier: MIT
// The outside of what a surface encloses, as one clean closed surface.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/options.h"
#include "base/triangle_mesh.h"

namespace remesher {

// What is enclosed, and by what.
struct Enclosure {
  std::size_t turned = 0;      // triangles that faced the other way
  std::size_t shells = 0;      // closed pieces that nobody sees, gone
  double lost = 0;             // percent of what is seen from along the axes and not on the result
  std::optional<Vec3> lostAt;  // where, of the first of it
  std::size_t sheets = 0;      // pieces that nothing lies behind, in part or as a whole
  // A corner of each closed piece that nobody sees and that is no cavity; of each that is seen and
  // faces inwards.
  std::vector<Vec3> innerAt, insideOutAt;
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
  Sheets sheets = Sheets::Thicken;  // for Reach
  bool keepsCavities = false;       // for Enclosure
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
