// SPDX-License-Identifier: MIT
// The outside of the volume that a surface encloses, as one clean closed surface.
#pragma once

#include <memory>
#include <vector>

#include "base/options.h"
#include "base/triangle_mesh.h"
#include "repair/solid/seen_loss.h"

namespace remesher {

// The findings on the enclosed volume and on the pieces of the surface.
struct Enclosure {
  std::size_t turned = 0;  // triangles that faced the other way
  std::size_t shells = 0;  // closed pieces that nobody sees, removed
  double lost = 0;         // percent of the lines that do not find what they see on the border
  std::size_t sheets = 0;  // open pieces with nothing behind them, in part or as a whole
  double unsure = 0;       // share of the points beside the surface whose side is in dispute
  double sheetShare = 0;   // of the area that lines of the lattice cross: outside on both sides
  bool isAny = false;      // whether anything is enclosed
};

struct Solid {
  TriangleMesh mesh;  // without triangles if nothing is enclosed
  Enclosure enclosure;
  SeenLoss loss;
};

// Which points are inside: those enclosed by triangles that face outwards, or those not reached
// from outside through openings wider than a gap.
enum class InsideBy { Enclosure, Reach };

// Whether triangles that show no more than their neighbours are removed. This takes several times
// as long as all else, and pays if the mesh is not remeshed afterwards.
enum class Cleaning { None, Thorough };

struct SolidRule {
  double spacing;  // between lattice points; thinner walls become as thick
  InsideBy by = InsideBy::Enclosure;
  double gap = 0;  // a length, for Reach
  Cleaning cleaning = Cleaning::None;
  Sheets sheets = Sheets::Thicken;  // for Reach
  bool keepsCavities = false;       // for Enclosure
  std::size_t mostPoints = 0;       // of the lattice, with planes added in thin walls
};

// A surface with its inside found. The input has to outlive it.
class SolidGround {
 public:
  // Throws Error as buildMesh does.
  SolidGround(const TriangleMesh& input, const SolidRule& rule);
  ~SolidGround();

  Enclosure enclosure() const;

  // To be called once.
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
