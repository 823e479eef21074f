// SPDX-License-Identifier: MIT
#include "repair/solid/cell_loops.h"

namespace remesher {

namespace {

std::array<CellEdge, 12> makeEdges() {
  std::array<CellEdge, 12> edges;
  std::array<std::size_t, 3> next{};
  for (int corner = 0; corner < 8; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(corner >> axis & 1))
        edges[4 * axis + next[axis]++] = {axis, {corner, corner | 1 << axis}};
  return edges;
}

// The corners of a face, counterclockwise from outside of the cell.
std::array<int, 4> faceCorners(std::size_t face) {
  const std::size_t axis = face / 2, side = face % 2;
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  const int base = side ? 1 << axis : 0;
  if (side) return {base, base + u, base + u + v, base + v};
  return {base, base + v, base + u + v, base + u};
}

std::size_t edgeBetween(int a, int b) {
  const std::array<CellEdge, 12>& edges = cellEdges();
  for (std::size_t e = 0; e < edges.size(); ++e)
    if ((edges[e].corners[0] == a && edges[e].corners[1] == b) ||
        (edges[e].corners[0] == b && edges[e].corners[1] == a))
      return e;
  return edges.size();
}

// Per face its four edges, in order.
std::array<std::array<std::size_t, 4>, 6> makeFaceEdges() {
  std::array<std::array<std::size_t, 4>, 6> result;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::array<int, 4> corners = faceCorners(face);
    for (std::size_t k = 0; k < 4; ++k)
      result[face][k] = edgeBetween(corners[k], corners[(k + 1) % 4]);
  }
  return result;
}

}  // namespace

const std::array<CellEdge, 12>& cellEdges() {
  static const std::array<CellEdge, 12> edges = makeEdges();
  return edges;
}

std::vector<CellLoop> cellLoops(unsigned isInside) {
  static const std::array<std::array<std::size_t, 4>, 6> faceEdges = makeFaceEdges();
  constexpr std::size_t kNo = 12;
  std::array<LoopStep, 12> next;  // per crossed edge: the next one, and the face between
  next.fill({kNo, 0});
  for (std::size_t face = 0; face < 6; ++face) {
    const std::array<int, 4> corners = faceCorners(face);
    const auto in = [&](std::size_t k) { return (isInside >> corners[k % 4] & 1) != 0; };
    for (std::size_t k = 0; k < 4; ++k) {
      if (!in(k) || in(k + 1)) continue;
      std::size_t m = k + 1;
      while (in(m) || !in(m + 1)) ++m;
      next[faceEdges[face][m % 4]] = {faceEdges[face][k], face};
    }
  }
  std::vector<CellLoop> loops;
  for (std::size_t first = 0; first < kNo; ++first) {
    if (next[first].edge == kNo) continue;
    CellLoop loop;
    for (std::size_t e = first; next[e].edge != kNo;) {
      const LoopStep step = next[e];
      loop.push_back({e, step.face});
      next[e].edge = kNo;
      e = step.edge;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace remesher
