// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirroring.h"

#include <cmath>
#include <map>
#include <tuple>

namespace remesher {

namespace {

MirroredQuads quadsOfHalf(const TriangleMesh& half) {
  MirroredQuads made;
  for (Index v = 0; v < half.positions.size(); ++v)
    made.vertices.push_back({half.positions[v], v, 0});
  for (Index first = 0; first + 5 < half.indices.size(); first += 6) {
    const std::array<Index, 4> corners = {first, first + 1, first + 2, first + 5};
    MirroredQuad quad{{}, corners, 0};
    for (std::size_t k = 0; k < 4; ++k) quad.vertices[k] = half.indices[corners[k]];
    made.quads.push_back(quad);
  }
  return made;
}

// An image has the other orientation. Where the diagonal lies in the plane, the quad before the
// plane has the same one: its image takes the other.
MirroredQuad imageOf(const MirroredQuad& quad, Image bit, Index shift,
                     const std::vector<char>& isOn) {
  const bool isTurned = isOn[quad.vertices[0]] && isOn[quad.vertices[2]];
  const std::array<std::size_t, 4> order =
      isTurned ? std::array<std::size_t, 4>{1, 0, 3, 2} : std::array<std::size_t, 4>{0, 3, 2, 1};
  MirroredQuad image{{}, {}, quad.image | bit};
  for (std::size_t k = 0; k < 4; ++k) {
    image.vertices[k] = shift + quad.vertices[order[k]];
    image.corners[k] = quad.corners[order[k]];
  }
  return image;
}

void addImage(MirroredQuads& quads, const MirrorPlane& plane, Image bit, double slack) {
  const auto vertices = Index(quads.vertices.size());
  const std::size_t count = quads.quads.size();
  std::vector<char> isOn(vertices, 0);
  for (Index v = 0; v < vertices; ++v) {
    MirroredVertex& vertex = quads.vertices[v];
    isOn[v] = std::abs(plane.distance(vertex.position)) <= slack;
    if (isOn[v]) vertex.position = plane.onto(vertex.position);
  }
  for (Index v = 0; v < vertices; ++v) {
    MirroredVertex image = quads.vertices[v];
    if (!isOn[v]) image.position = plane.mirrored(image.position);
    image.image |= bit;
    quads.vertices.push_back(image);
  }
  for (std::size_t q = 0; q < count; ++q)
    quads.quads.push_back(imageOf(quads.quads[q], bit, vertices, isOn));
}

}  // namespace

MirroredQuads mirroredQuads(const TriangleMesh& half, const Mirrors& mirrors) {
  MirroredQuads quads = quadsOfHalf(half);
  for (std::size_t i = 0; i < mirrors.planes.size(); ++i)
    addImage(quads, mirrors.planes[i], 1U << i, mirrors.slack);
  return quads;
}

std::vector<Index> placeNumbers(const MirroredQuads& quads) {
  std::map<std::tuple<double, double, double>, Index> known;
  std::vector<Index> numbers;
  for (const MirroredVertex& vertex : quads.vertices) {
    const Vec3& p = vertex.position;
    numbers.push_back(known.try_emplace({p.x(), p.y(), p.z()}, Index(known.size())).first->second);
  }
  return numbers;
}

}  // namespace remesher
