// SPDX-License-Identifier: MIT
#include "base/triangle_mesh.h"

#include <algorithm>
#include <cstddef>

#include "base/error.h"

namespace remesher {

namespace {

// x - x is 0 for a finite x only: for NaN and infinity it is NaN.
bool isFinite(const Vec3& p) {
  const double* const x = p.data();
  return x[0] - x[0] == 0 && x[1] - x[1] == 0 && x[2] - x[2] == 0;
}

auto valueAt(const Attribute& attribute, Index vertex) {
  return attribute.values.begin() + std::ptrdiff_t(vertex) * attribute.itemSize;
}

}  // namespace

const Attribute* findAttribute(const TriangleMesh& mesh, std::string_view semantic) {
  for (const Attribute& attribute : mesh.attributes)
    if (attribute.semantic == semantic) return &attribute;
  return nullptr;
}

std::vector<Index> quadsOf(const TriangleMesh& mesh) {
  std::vector<Index> quads;
  if (!mesh.isQuads) return quads;
  quads.reserve(mesh.indices.size() / 6 * 4);
  for (std::size_t i = 0; i + 5 < mesh.indices.size(); i += 6) {
    quads.insert(quads.end(), &mesh.indices[i], &mesh.indices[i] + 3);
    quads.push_back(mesh.indices[i + 5]);
  }
  return quads;
}

bool arePairs(const TriangleMesh& mesh) {
  const std::vector<Index>& corners = mesh.indices;
  if (corners.empty() || corners.size() % 6 != 0) return false;
  for (std::size_t i = 0; i < corners.size(); i += 6)
    if (corners[i] != corners[i + 3] || corners[i + 2] != corners[i + 4]) return false;
  return true;
}

bool haveSameAttributes(const TriangleMesh& mesh, Index v, Index w) {
  return haveSameAttributes(mesh, v, w, [](std::string_view) { return true; });
}

bool haveSameAttributes(const TriangleMesh& mesh, Index v, Index w,
                        bool (*isCompared)(std::string_view semantic)) {
  const auto isSame = [&](const Attribute& attribute) {
    return !isCompared(attribute.semantic) ||
           std::equal(valueAt(attribute, v), valueAt(attribute, v) + attribute.itemSize,
                      valueAt(attribute, w));
  };
  return v == w || std::all_of(mesh.attributes.begin(), mesh.attributes.end(), isSame);
}

bool haveSameContent(const TriangleMesh& a, const TriangleMesh& b) {
  const auto isSame = [](const Attribute& x, const Attribute& y) {
    return x.semantic == y.semantic && x.itemSize == y.itemSize && x.values == y.values;
  };
  return a.indices == b.indices && a.groups == b.groups && a.positions == b.positions &&
         std::equal(a.attributes.begin(), a.attributes.end(), b.attributes.begin(),
                    b.attributes.end(), isSame);
}

void appendValue(Attribute& to, const Attribute& from, Index vertex) {
  to.values.insert(to.values.end(), valueAt(from, vertex), valueAt(from, vertex) + from.itemSize);
}

Attribute valuesOf(const Attribute& from, std::span<const Index> vertices) {
  Attribute some{from.semantic, from.itemSize, {}};
  some.values.reserve(vertices.size() * std::size_t(from.itemSize));
  for (const Index v : vertices) appendValue(some, from, v);
  return some;
}

void dropLastVertex(TriangleMesh& mesh) {
  mesh.positions.pop_back();
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(attribute.values.size() - std::size_t(attribute.itemSize));
}

std::size_t groupCount(const TriangleMesh& mesh) {
  if (mesh.groups.empty()) return 1;
  return std::size_t{*std::max_element(mesh.groups.begin(), mesh.groups.end())} + 1;
}

void requireValid(const TriangleMesh& mesh) {
  if (mesh.indices.empty())
    throw Error(ErrorCode::NoTriangles, "The mesh has no triangles.",
                "Points and lines alone cannot be remeshed.");
  if (mesh.indices.size() % 3 != 0)
    throw Error(ErrorCode::IndexOutOfRange,
                "Triangle " + std::to_string(mesh.triangleCount()) + " has fewer than 3 corners.",
                "Give three indices per triangle.");
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    if (mesh.indices[i] >= mesh.positions.size())
      throw Error(ErrorCode::IndexOutOfRange,
                  "Triangle " + std::to_string(i / 3) + " names vertex " +
                      std::to_string(mesh.indices[i]) + ", but there are only " +
                      std::to_string(mesh.positions.size()) + " vertices.",
                  "Indices count from 0.");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!isFinite(mesh.positions[v]))
      throw Error(ErrorCode::NonFinite,
                  "Vertex " + std::to_string(v) + " has a coordinate that is NaN or infinite.",
                  "Repair or remove the vertex.");
}

}  // namespace remesher
