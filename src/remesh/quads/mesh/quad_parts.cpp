// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_parts.h"

#include "mesh/components.h"
#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// The triangles of one part, with their vertices numbered anew.
class PartCopy {
 public:
  explicit PartCopy(const WorkingMesh& mesh)
      : mesh_(mesh), vertex_(mesh.mesh().vertexCapacity(), kNone) {}

  WorkingMesh of(const std::vector<Face>& faces, const FaceData<Index>& number) {
    const HalfedgeMesh& m = mesh_.mesh();
    WorkingMesh::Parts parts;
    for (const Face f : faces)
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge h = HalfedgeMesh::halfedge(f, corner), twin = m.twin(h);
        parts.triangles.push_back(numberOf(m.origin(h), parts.places));
        parts.twins.push_back(twin ? 3 * number[HalfedgeMesh::face(twin)] + twin.index % 3 : kNone);
        parts.curves.push_back(mesh_.curve(h));
      }
    return WorkingMesh(mesh_.surface(), parts);
  }

 private:
  Index numberOf(Vertex v, std::vector<Placement>& places) {
    if (vertex_[v] == kNone) {
      vertex_[v] = Index(places.size());
      places.push_back(mesh_.placement(v));
    }
    return vertex_[v];
  }

  const WorkingMesh& mesh_;
  VertexData<Index> vertex_;
};

}  // namespace

FaceData<Index> partNumbers(const HalfedgeMesh& mesh) { return componentsOfFaces(mesh).of; }

std::vector<WorkingMesh> connectedParts(const WorkingMesh& mesh) {
  const FaceData<Index> part = partNumbers(mesh.mesh());
  std::vector<std::vector<Face>> faces;
  FaceData<Index> number(part.size());
  for (Index i = 0; i < part.size(); ++i) {
    const Index own = part[Face(i)];
    if (own >= faces.size()) faces.resize(own + 1);
    number[Face(i)] = Index(faces[own].size());
    faces[own].push_back(Face(i));
  }
  std::vector<WorkingMesh> parts;
  PartCopy copy(mesh);
  for (const std::vector<Face>& own : faces) parts.push_back(copy.of(own, number));
  return parts;
}

void append(QuadMesh& mesh, const QuadMesh& other) {
  const Index first = Index(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c, d] : other.quads)
    mesh.quads.push_back({first + a, first + b, first + c, first + d});
  mesh.curves.insert(mesh.curves.end(), other.curves.begin(), other.curves.end());
}

void dropQuads(QuadMesh& mesh, const std::vector<char>& isGone) {
  std::size_t kept = 0;
  for (std::size_t q = 0; q < isGone.size(); ++q) {
    if (isGone[q]) continue;
    mesh.quads[kept] = mesh.quads[q];
    mesh.curves[kept++] = mesh.curves[q];
  }
  mesh.quads.resize(kept);
  mesh.curves.resize(kept);
}

void dropUnusedVertices(QuadMesh& mesh) {
  std::vector<Index> number(mesh.vertices.size(), kNone);
  for (const Four<Index>& quad : mesh.quads)
    for (const Index v : quad) number[v] = 0;
  Index count = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    mesh.vertices[count] = mesh.vertices[v];
    number[v] = count++;
  }
  mesh.vertices.resize(count);
  for (Four<Index>& quad : mesh.quads)
    for (Index& v : quad) v = number[v];
}

void surround(QuadMesh& mesh, Index quad, const Four<Index>& within) {
  const Four<Index> corners = mesh.quads[quad], curves = mesh.curves[quad];
  mesh.quads[quad] = within;
  mesh.curves[quad] = {kNone, kNone, kNone, kNone};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    mesh.quads.push_back({corners[i], corners[k], within[k], within[i]});
    mesh.curves.push_back({curves[i], kNone, kNone, kNone});
  }
}

void shrink(QuadMesh& mesh, Index quad, const SurfacePoint& from, const WorkingMesh& ground) {
  const Four<Index> corners = mesh.quads[quad];
  Vec3 middle = Vec3::Zero();
  for (const Index v : corners) middle += mesh.position(v) / 4;
  Four<Placement> places;  // `from` may be of a vertex, which would move as vertices are added
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 p = (middle + mesh.position(corners[i])) / 2;
    places[i] = ground.onSurface(closestPointFrom(ground.surface(), from, p));
  }
  Four<Index> inner{};
  for (std::size_t i = 0; i < 4; ++i) {
    inner[i] = Index(mesh.vertices.size());
    mesh.vertices.push_back(places[i]);
  }
  surround(mesh, quad, inner);
}

}  // namespace remesher
