// SPDX-License-Identifier: MIT
// The local operators on connectivity. Ask first whether one is legal (canFlip, canCollapse): each
// operator then always succeeds, keeps every invariant of HalfedgeMesh, and returns what it made.
#pragma once

#include "mesh/halfedge_mesh.h"

namespace remesher {

class EulerOperators {
 public:
  explicit EulerOperators(HalfedgeMesh& mesh) : mesh_(mesh) {}

  //        c                c
  //      /   \            / | \         The edge a-b of the two triangles becomes c-d. h keeps the
  //     /  h  \          /  |  \        face on b's side, t = twin(h) the one on a's; the outer
  //    a ----- b   -->  a   |   b       halfedges b→c and a→d keep their places.
  //     \  t  /          \  |  /
  //      \   /            \ | /
  //        d                d
  // Legal if h is an interior edge and c-d is not an edge yet. This excludes ends of valence 3,
  // where c and d are neighbours.
  static bool canFlip(const HalfedgeMesh& mesh, Halfedge h);
  Halfedge flip(Halfedge h);  // returns c→d, which is prev(h); h itself is then d→b

  //        c                c
  //      /   \            / | \         A new vertex m on a-b. Afterwards h runs from a to m and
  //     /  h  \          /  |  \        the new halfedge `beyond` from m to b. On a boundary the
  //    a ----- b   -->  a - m - b       lower half is not there.
  //     \  t  /          \  |  /
  //      \   /            \ | /
  //        d                d
  struct Split {
    Vertex vertex;
    Halfedge beyond;
  };
  Split split(Halfedge h);  // always legal

  //        c                c
  //      /   \              |           a goes, b takes over its star; the two triangles at the
  //     /  h  \             |           edge (one on a boundary) vanish.
  //    a ----- b   -->      b
  //     \  t  /             |
  //      \   /              |
  //        d                d
  // Legal by the link condition: the common neighbours of a and b are exactly the vertices opposite
  // the edge; an inner edge does not join two boundary vertices; and no third vertex loses its last
  // faces (valence above 3, on a boundary above 2). A tetrahedron stays a tetrahedron.
  static bool canCollapse(const HalfedgeMesh& mesh, Halfedge h);
  Vertex collapse(Halfedge h);  // returns tip(h)

 private:
  Vertex newVertex();
  Face newFace();
  void deleteFace(Face f);
  void deleteVertex(Vertex v);
  Halfedge splitUpper(Halfedge h, Vertex m);
  Halfedge splitLower(Halfedge t, Vertex m);
  void closeGap(Halfedge h);

  HalfedgeMesh& mesh_;
};

}  // namespace remesher
