// SPDX-License-Identifier: MIT
#include "io/ply/corner_texcoords.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "io/model/wedges.h"

namespace remesher::io {
namespace {

using Texcoord = std::array<float, 2>;

Texcoord texcoordAt(const std::vector<float>& values, std::size_t i) {
  return {values[2 * i], values[2 * i + 1]};
}

// The vertices `chosen` of the mesh, in this order, with all attributes but without triangles.
TriangleMesh gathered(const TriangleMesh& mesh, const std::vector<Index>& chosen) {
  TriangleMesh result;
  result.groups = mesh.groups;
  result.isQuads = mesh.isQuads;
  result.positions.reserve(chosen.size());
  for (const Index vertex : chosen) result.positions.push_back(mesh.positions[vertex]);
  for (const Attribute& attribute : mesh.attributes) {
    Attribute taken{attribute.semantic, attribute.itemSize, {}};
    taken.values.reserve(chosen.size() * attribute.itemSize);
    for (const Index vertex : chosen) {
      const auto first = attribute.values.begin() + std::ptrdiff_t{attribute.itemSize} * vertex;
      taken.values.insert(taken.values.end(), first, first + attribute.itemSize);
    }
    result.attributes.push_back(std::move(taken));
  }
  return result;
}

// Compares all values of two vertices: -1, 0 or 1.
int order(const TriangleMesh& mesh, Index a, Index b) {
  const auto byNumbers = [](auto x, auto y, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
    return 0;
  };
  if (const int by = byNumbers(mesh.positions[a].data(), mesh.positions[b].data(), 3)) return by;
  for (const Attribute& attribute : mesh.attributes) {
    const std::size_t width = attribute.itemSize;
    const float* const values = attribute.values.data();
    if (const int by = byNumbers(values + a * width, values + b * width, width)) return by;
  }
  return 0;
}

// Per vertex the first vertex that is equal to it.
std::vector<Index> leaders(const TriangleMesh& mesh) {
  std::vector<Index> sorted(mesh.positions.size());
  std::iota(sorted.begin(), sorted.end(), Index{0});
  std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) {
    const int by = order(mesh, a, b);
    return by != 0 ? by < 0 : a < b;
  });
  std::vector<Index> leader(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool isEqual = i > 0 && order(mesh, sorted[i - 1], sorted[i]) == 0;
    leader[sorted[i]] = isEqual ? leader[sorted[i - 1]] : sorted[i];
  }
  return leader;
}

}  // namespace

TriangleMesh splitByTexcoord(const TriangleMesh& mesh, const std::vector<float>& perCorner) {
  WedgeChains<Texcoord> chains(mesh.positions.size());
  std::vector<Index> ofCorner;
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
    ofCorner.push_back(chains.wedgeAt(mesh.indices[corner], texcoordAt(perCorner, corner)));
  std::vector<Index> chosen, renumbered(chains.count());
  Attribute texcoords{"TEXCOORD_0", 2, {}};
  for (Index vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    for (Index wedge = chains.first(vertex); wedge != kNone; wedge = chains.next(wedge)) {
      const Texcoord& texcoord = chains.value(wedge);
      renumbered[wedge] = static_cast<Index>(chosen.size());
      chosen.push_back(vertex);
      texcoords.values.insert(texcoords.values.end(), texcoord.begin(), texcoord.end());
    }
    if (chains.first(vertex) != kNone) continue;
    chosen.push_back(vertex);
    texcoords.values.insert(texcoords.values.end(), {0.0F, 0.0F});
  }
  TriangleMesh result = gathered(mesh, chosen);
  result.attributes.push_back(std::move(texcoords));
  for (const Index wedge : ofCorner) result.indices.push_back(renumbered[wedge]);
  return result;
}

WeldedMesh weldedAcrossTexcoords(const TriangleMesh& mesh) {
  WeldedMesh welded;
  const std::vector<float>& texcoords = findAttribute(mesh, "TEXCOORD_0")->values;
  for (const Index vertex : mesh.indices) {
    const Texcoord texcoord = texcoordAt(texcoords, vertex);
    welded.perCorner.insert(welded.perCorner.end(), texcoord.begin(), texcoord.end());
  }
  TriangleMesh rest = mesh;
  std::erase_if(rest.attributes,
                [](const Attribute& attribute) { return attribute.semantic == "TEXCOORD_0"; });
  const std::vector<Index> leader = leaders(rest);
  std::vector<Index> chosen, renumbered(leader.size());
  for (Index vertex = 0; vertex < leader.size(); ++vertex) {
    if (leader[vertex] == vertex) {
      renumbered[vertex] = static_cast<Index>(chosen.size());
      chosen.push_back(vertex);
    } else {
      renumbered[vertex] = renumbered[leader[vertex]];
    }
  }
  welded.mesh = gathered(rest, chosen);
  for (const Index vertex : mesh.indices) welded.mesh.indices.push_back(renumbered[vertex]);
  return welded;
}

}  // namespace remesher::io
