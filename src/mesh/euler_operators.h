// SPDX-License-Identifier: MIT
// The local operators on connectivity. Legality is asked first (canFlip, canCollapse); each
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
  // Legal where h is inside, both ends have valence above 3 (above 2 on a boundary) and c-d is no
  // edge yet.
  static bool canFlip(const HalfedgeMesh& mesh, Halfedge h);
  Halfedge flip(Halfedge h);  // returns c→d, which is prev(h); h itself is then d→b

  //        c                c
  //      /   \            / | \         A new vertex m on a-b. h runs from a to m afterwards and
  //      the
  //     /  h  \          /  |  \        new halfedge `beyond` from m to b; on a boundary the lower
  //    a ----- b   -->  a - m - b       half is not there.
  //     \  t  /          \  |  /
  //      \   /            \ | /
  //        d                d
  struct Split {
    Vertex vertex;
    Halfedge beyond;
  };
  Split split(Halfedge h);  // always legal

  //     a ------ b                      origin(h) = a goes, tip(h) = b takes over its star; the one
  //     or
  //                                     two triangles at the edge vanish.
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
