// SPDX-License-Identifier: MIT
// A set of faces that stays a topological disk while it grows [DGP 2016, "Projection on the Initial
// Surface", Figure 2], and the finished disk with local numbers. A patch ends at mesh boundaries
// and at barriers; its rim is one loop that meets no vertex twice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

// Numbers within one patch: half the memory of mesh indices. kNoLocal: none.
using LocalIndex = std::uint16_t;
inline constexpr LocalIndex kNoLocal = 0xFFFF;

// A face of a patch. Corners are in the order of the mesh's face; across[i] is the face of the
// patch beyond the side from corner i to corner i + 1, kNoLocal at the rim.
struct LocalFace {
  Index face = kNone;
  std::array<LocalIndex, 3> corners = {};
  std::array<LocalIndex, 3> across = {};
};

struct DiskPatch {
  std::vector<LocalFace> faces;
  std::vector<Vertex> vertices;  // of the mesh, by local number
  std::vector<LocalIndex> rim;   // counterclockwise
};

// Grows patches one after another; keeps its memory from patch to patch.
class DiskGrower {
 public:
  // A patch does not grow beyond this number of faces, so that local numbers suffice.
  static constexpr std::size_t kMaxFaces = kNoLocal / 2;

  // mesh and barriers must outlive the grower. barriers: by halfedge, both of each barrier edge
  // marked, or empty.
  DiskGrower(const HalfedgeMesh& mesh, std::span<const char> barriers);

  void clear();

  // Adds a face if the set stays a disk; always adds the first face. Returns whether it was added.
  bool add(Face f);
  bool holds(Face f) const { return faceStamp_[f.index] == stamp_; }

  // The face beyond a side that a patch may grow to; none at a boundary or a barrier.
  Face neighbor(Halfedge side) const;

  // In the order they were added.
  std::span<const Face> faces() const { return faces_; }

  // Removes ears, faces that hang on the patch by one side only, until none is left. Keeps the
  // faces in `kept`, and ears whose two free sides both lie on boundaries or barriers: in
  // every patch such faces are ears.
  void trimEars(std::span<const Face> kept);

  // The held faces as a patch, valid until the next call; null if they are not a disk.
  const DiskPatch* cut();

 private:
  void renewStamp();
  bool staysDisk(Face f) const;
  bool isEar(Face f) const;
  void removeEar(Face f);
  void numberVertices();
  void linkFaces();
  bool traceRim();

  const HalfedgeMesh& mesh_;
  std::span<const char> barriers_;
  std::vector<Face> faces_;
  // A face or vertex is held if its stamp equals stamp_; its number is then valid.
  Index stamp_ = 1;
  std::vector<Index> faceStamp_, vertexStamp_;
  std::vector<Index> faceNumber_, vertexNumber_;
  std::vector<Face> earCandidates_;
  std::vector<LocalIndex> nextOnRim_;
  DiskPatch patch_;
};

}  // namespace remesher
