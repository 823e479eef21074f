// SPDX-License-Identifier: MIT
#include "remesh/transfer/attribute_transfer.h"

#include <algorithm>
#include <array>
#include <span>

namespace remesher {

namespace {

// Where each corner of a triangle takes its attributes from. The halves of a quad agree about the
// ends of their diagonal: the first corner of both, and the last of the first.
HalfedgeData<SurfacePoint> cornerPoints(const WorkingMesh& mesh, const TransferRules& rules) {
  const HalfedgeMesh& m = mesh.mesh();
  HalfedgeData<SurfacePoint> points(m.halfedgeCapacity(), SurfacePoint{});
  ChartKeeper keeper(mesh, rules.charts);
  const Index halves = rules.areQuads ? 2 : 1;
  for (Index f = 0; f + halves <= m.faceCapacity(); f += halves) {
    if (!m.isAlive(Face(f))) continue;
    std::array<SurfacePoint, 6> corners;
    for (Index k = 0; k < 3 * halves; ++k) corners[k] = mesh.cornerPoint(Halfedge(3 * f + k));
    if (rules.areQuads) {
      corners[3] = corners[0];
      corners[4] = corners[2];
    }
    keeper.intoOneChart(std::span(corners).first(3 * halves));
    for (Index k = 0; k < 3 * halves; ++k) points[Halfedge(3 * f + k)] = corners[k];
  }
  return points;
}

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.barycentric == b.barycentric;
}

// Collects output vertices; one per working vertex and side of the curves through it.
class WedgeExtraction {
 public:
  WedgeExtraction(const WorkingMesh& mesh, const TriangleMesh& input, const TransferRules& rules)
      : mesh_(mesh), input_(input), mix_(input, rules.chartless) {
    if (!input.attributes.empty()) points_ = cornerPoints(mesh, rules);
    for (const Attribute& attribute : input.attributes)
      result_.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  }

  TriangleMesh run() {
    const HalfedgeMesh& m = mesh_.mesh();
    HalfedgeData<Index> outputOf(m.halfedgeCapacity(), kNone);
    result_.positions.reserve(m.vertexCount());
    result_.indices.reserve(3 * m.faceCount());
    for (Index i = 0; i < m.vertexCapacity(); ++i)
      if (m.isAlive(Vertex(i)))
        input_.attributes.empty() ? addBare(Vertex(i), outputOf) : addVertex(Vertex(i), outputOf);
    for (Index f = 0; f < m.faceCapacity(); ++f) {
      if (!m.isAlive(Face(f))) continue;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) result_.indices.push_back(outputOf[Halfedge(h)]);
      if (!input_.groups.empty()) result_.groups.push_back(groupOf(Face(f)));
    }
    return std::move(result_);
  }

 private:
  // Without attributes all sides are one output.
  void addBare(Vertex v, HalfedgeData<Index>& outputOf) {
    const Index made = Index(result_.positions.size());
    result_.positions.push_back(mesh_.position(v));
    mesh_.mesh().forEachOutgoing(v, [&](Halfedge h) { outputOf[h] = made; });
  }

  // Turns around v. A new side begins at every curve edge, and wherever a corner takes its
  // attributes from another place. Sides with equal attributes share one output.
  void addVertex(Vertex v, HalfedgeData<Index>& outputOf) {
    const HalfedgeMesh& m = mesh_.mesh();
    Halfedge first = m.outgoing(v);
    if (mesh_.kind(v) != VertexKind::Interior && !m.isBoundary(v)) {
      // A tip has no curve edge: there any first one will do.
      while (!mesh_.isCurve(first)) {
        first = m.next(m.twin(first));
        if (first == m.outgoing(v)) break;
      }
    }
    const Index begin = Index(result_.positions.size());
    Index current = kNone;
    Halfedge h = first, before;
    do {
      if (current == kNone || mesh_.isCurve(h) || !isSame(points_[h], points_[before]))
        current = addSide(v, h, begin);
      outputOf[h] = current;
      before = h;
      h = m.twin(m.prev(h));
    } while (h && h != first);
  }

  Index addSide(Vertex v, Halfedge h, Index begin) {
    const Index made = Index(result_.positions.size());
    result_.positions.push_back(mesh_.position(v));
    if (!result_.attributes.empty())
      mix_.append(mixPoint(mesh_.surface(), points_[h], mix_), result_.attributes);
    for (Index other = begin; other < made; ++other)
      if (haveSameAttributes(result_, other, made)) {
        dropLastVertex(result_);
        return other;
      }
    return made;
  }

  Index groupOf(Face f) const {
    const SurfacePoint point = mesh_.cornerPoint(HalfedgeMesh::halfedge(f));
    return input_.groups[mesh_.surface().built().triangles[point.face]];
  }

  const WorkingMesh& mesh_;
  const TriangleMesh& input_;
  AttributeMix mix_;
  HalfedgeData<SurfacePoint> points_;  // none where there are no attributes
  TriangleMesh result_;
};

}  // namespace

AttributeMix::Point mixPoint(const OriginalSurface& surface, const SurfacePoint& point,
                             const AttributeMix& mix) {
  const HalfedgeData<Index>& wedges = surface.built().wedges;
  const Halfedge h = HalfedgeMesh::halfedge(point.face);
  return {{wedges[h], wedges[HalfedgeMesh::next(h)], wedges[HalfedgeMesh::prev(h)]},
          point.barycentric,
          mix.needsNormals() ? surface.normal(point) : Vec3(Vec3::Zero())};
}

TriangleMesh extractMesh(const WorkingMesh& mesh, const TriangleMesh& input,
                         const TransferRules& rules) {
  return WedgeExtraction(mesh, input, rules).run();
}

// The builder may have turned a triangle over: weights go to the corners that they belong to.
InputPlace inputPlace(const SurfacePoint& point, const BuiltMesh& built,
                      const TriangleMesh& input) {
  InputPlace place{InputTriangle(built.triangles[point.face]), Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Index wedge = built.wedges[HalfedgeMesh::halfedge(point.face, i)];
    for (Index k = 0; k < 3; ++k)
      if (input.indices[cornerOf(place.triangle, k)] == wedge)
        place.weights[k] = point.barycentric[i];
  }
  return place;
}

std::vector<InputPlace> cornerPlaces(const WorkingMesh& mesh, const TriangleMesh& input) {
  const BuiltMesh& built = mesh.surface().built();
  std::vector<InputPlace> places;
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    if (!mesh.mesh().isAlive(Face(f))) continue;
    for (int k = 0; k < 3; ++k) {
      const SurfacePoint point = mesh.cornerPoint(HalfedgeMesh::halfedge(Face(f), k));
      places.push_back(inputPlace(point, built, input));
    }
  }
  return places;
}

}  // namespace remesher
