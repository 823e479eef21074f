// SPDX-License-Identifier: MIT
#include "repair/holes/close_holes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "measure/self_intersections.h"
#include "mesh/components.h"
#include "repair/holes/fairing.h"
#include "repair/holes/kept_surface.h"
#include "repair/holes/loop_triangulation.h"
#include "repair/holes/nested_loops.h"
#include "repair/holes/plug_attributes.h"
#include "repair/holes/refinement.h"
#include "repair/holes/rims.h"

namespace remesher {

namespace {

enum class Shape { Planar, Smooth, Flat, Bare };
using Shapes = std::array<Shape, 3>;

// A disk's shapes, the best first.
Shapes shapesOf(const BuiltMesh& built, const Loop& loop) {
  if (!loop.inner.empty()) return {Shape::Planar, Shape::Planar, Shape::Planar};
  if (looksCutOff(built, loop)) return {Shape::Planar, Shape::Smooth, Shape::Bare};
  return {Shape::Smooth, Shape::Flat, Shape::Bare};
}

Plug plugOf(const BuiltMesh& built, const Loop& loop, Shape shape) {
  Plug plug = shape == Shape::Planar ? triangulatedInPlane(built, loop) : triangulated(built, loop);
  if (shape != Shape::Bare) refine(plug, built, loop);
  if (shape == Shape::Smooth) fair(plug, built, loop);
  return plug;
}

// The faces of the manifold, in the order of their triangles.
std::vector<Face> facesInOrder(const BuiltMesh& built) {
  std::vector<Face> faces;
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) faces.emplace_back(f);
  std::sort(faces.begin(), faces.end(),
            [&](Face f, Face g) { return built.triangles[f] < built.triangles[g]; });
  return faces;
}

// The triangles of these faces, each starting at its first corner, as far as it has not been
// turned.
TriangleMesh meshOf(const KeptSurface& kept, const std::vector<Face>& faces) {
  TriangleMesh mesh = kept.mesh;
  mesh.indices.clear(), mesh.groups.clear();
  for (const Face f : faces) {
    for (int k = 0; k < 3; ++k)
      mesh.indices.push_back(kept.built.wedges[HalfedgeMesh::halfedge(f, k)]);
    if (!kept.mesh.groups.empty()) mesh.groups.push_back(kept.mesh.groups[kept.built.triangles[f]]);
  }
  return mesh;
}

// A loop being closed. meetings: per shape tried, how many of its triangles intersect others.
struct Closing {
  Loop loop;
  Shapes shapes;
  std::vector<Loop> apart = {};  // of a lid with holes: its loops
  std::size_t shape = 0;
  Plug plug = {};
  std::array<std::size_t, std::tuple_size_v<Shapes>> meetings = {};
};

class Closer {
 public:
  // without: the surface without disks.
  Closer(const KeptSurface& kept, TriangleMesh without, std::vector<Loop> loops)
      : kept_(kept), without_(std::move(without)) {
    for (const std::vector<std::size_t>& lid : lidsOf(kept.built, loops)) {
      std::vector<Loop> apart;
      if (lid.size() > 1)
        for (const std::size_t l : lid) apart.push_back(loops[l]);
      begin(joined(loops, lid), std::move(apart));
    }
    for (std::size_t c = closings_.size(); c-- > 0;)
      if (!closings_[c].apart.empty() && closings_[c].plug.triangles.empty()) takeApart(c);
  }

  TriangleMesh run() {
    // Lids with holes that intersect others give way to disks first.
    for (std::size_t round = 0; round <= std::tuple_size_v<Shapes> && retry(); ++round) continue;
    return assembled();
  }

 private:
  void begin(Loop loop, std::vector<Loop> apart = {}) {
    const Shapes shapes = shapesOf(kept_.built, loop);
    closings_.push_back({std::move(loop), shapes, std::move(apart)});
    choose(closings_.back(), 0);
  }

  // Each loop of a lid with holes gets a disk.
  void takeApart(std::size_t closing) {
    const std::vector<Loop> apart = std::move(closings_[closing].apart);
    closings_.erase(closings_.begin() + std::ptrdiff_t(closing));
    for (const Loop& loop : apart) begin(loop);
  }

  void choose(Closing& closing, std::size_t shape) {
    closing.shape = shape;
    closing.plug = plugOf(kept_.built, closing.loop, closing.shapes[shape]);
    if (!without_.isSingle) return;
    for (std::size_t v = closing.loop.vertices.size(); v < closing.plug.points.size(); ++v)
      closing.plug.points[v] = inSingle(closing.plug.points[v], without_.frame);
  }

  TriangleMesh assembled() const {
    TriangleMesh mesh = without_;
    for (const Closing& closing : closings_) appendPlug(mesh, kept_, closing.loop, closing.plug);
    return mesh;
  }

  // Gives each intersecting plug its next shape; after the last, the shape with the fewest
  // intersecting triangles. Returns whether any plug took a next shape.
  bool retry() {
    if (closings_.empty()) return false;
    const std::vector<Index> hits =
        selfIntersectionsFrom(assembled(), Index(without_.triangleCount()));
    std::size_t end = without_.triangleCount(), hit = 0;
    bool isAny = false;
    std::vector<std::size_t> meeting;  // lids with holes
    for (std::size_t c = 0; c < closings_.size(); ++c) {
      Closing& closing = closings_[c];
      end += closing.plug.triangles.size();
      std::size_t count = 0;
      for (; hit < hits.size() && hits[hit] < end; ++hit) ++count;
      closing.meetings[closing.shape] = count;
      if (count == 0) continue;
      if (!closing.apart.empty()) {
        meeting.push_back(c), isAny = true;
        continue;
      }
      if (closing.shape + 1 < closing.shapes.size()) {
        choose(closing, closing.shape + 1), isAny = true;
        continue;
      }
      const auto least = std::min_element(closing.meetings.begin(), closing.meetings.end());
      choose(closing, std::size_t(least - closing.meetings.begin()));
    }
    for (; !meeting.empty(); meeting.pop_back()) takeApart(meeting.back());
    return isAny;
  }

  const KeptSurface& kept_;
  const TriangleMesh without_;
  std::vector<Closing> closings_;
};

double areaOfDisk(const Plug& disk) {
  double sum = 0;
  for (const Corners3& t : disk.triangles)
    sum += area(disk.points[t[0]], disk.points[t[1]], disk.points[t[2]]);
  return sum;
}

// Takes out the loops of sheets.
void leaveSheets(const BuiltMesh& built, const LoopRule& rule, std::vector<Loop>& loops,
                 ClosedHoles& result) {
  const double mostDisk = rule.mostDisk;
  if (mostDisk == kInfinity || loops.empty()) return;
  DisjointSets components = componentsOfVertices(built.mesh);
  const std::vector<std::vector<std::size_t>> lids = lidsOf(built, loops);
  for (const std::vector<std::size_t>& lid : lids)
    for (const std::size_t l : lid)
      components.unite(loops[lid.front()].vertices.front().index, loops[l].vertices.front().index);
  const auto componentOf = [&](const Loop& loop) {
    return components.find(loop.vertices.front().index);
  };
  std::vector<double> own(built.mesh.vertexCapacity(), 0), disks(own.size(), 0);
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = built.mesh.vertices(Face(f));
    own[components.find(a.index)] +=
        area(built.positions[a], built.positions[b], built.positions[c]);
  }
  std::vector<double> areas(loops.size());  // of each loop's lid
  for (const std::vector<std::size_t>& lid : lids) {
    double sum = areaOfDisk(plugOf(built, loops[lid.front()], Shape::Bare));
    for (std::size_t i = 1; i < lid.size(); ++i)
      sum -= areaOfDisk(plugOf(built, loops[lid[i]], Shape::Bare));
    for (const std::size_t l : lid) areas[l] = sum;
    disks[componentOf(loops[lid.front()])] += sum;
  }
  const auto isSheet = [&](Index component) {
    return disks[component] > mostDisk * own[component];
  };
  const auto staysOpen = [&](std::size_t l) {
    const Index component = componentOf(loops[l]);
    if (!isSheet(component) || !rule.keepsSheets) return isSheet(component);
    return areas[l] > mostDisk * own[component] || looksMeant(built, loops[l]);
  };
  std::vector<Loop> closing;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (!staysOpen(l)) closing.push_back(loops[l]);
  loops = std::move(closing);
  for (Index v = 0; v < own.size(); ++v) {
    if (!built.mesh.isAlive(Vertex(v)) || components.find(v) != v || !isSheet(v)) continue;
    result.sheetsAt.push_back(built.positions[Vertex(v)]);
    result.sheetArea += own[v];
  }
}

// Takes out the loops that are too long, and with the rule those that look intended.
void leaveOpen(const BuiltMesh& built, const LoopRule& rule, std::vector<Loop>& loops,
               ClosedHoles& result) {
  std::vector<Loop> closing;
  for (Loop& loop : loops) {
    if (loop.length > rule.longest) {
      result.openAt.push_back(built.positions[loop.vertices.front()]);
      continue;
    }
    const SizedPlace place = placeOf(built, loop);
    const bool isMeant = looksMeant(built, loop);
    if (isMeant && rule.keepsRims) {
      result.rimsAt.push_back(place);
      continue;
    }
    result.closedAt.push_back(place);
    if (isMeant) result.meantAt.push_back(place);
    closing.push_back(std::move(loop));
  }
  loops = std::move(closing);
}

}  // namespace

ClosedHoles closeHoles(const TriangleMesh& input, const LoopRule& rule) {
  const KeptSurface kept = keptSurface(input, rule.keepsSheets ? Debris::Kept : Debris::Removed);
  std::vector<Loop> loops = boundaryLoops(kept.built);
  ClosedHoles result;
  leaveSheets(kept.built, rule, loops, result);
  leaveOpen(kept.built, rule, loops, result);
  result.holes = loops.size();
  result.islands = kept.islands;
  result.removedAt = kept.removedAt;
  result.trianglesRemoved = kept.trianglesRemoved;
  result.lines = kept.built.lines;
  const std::vector<Face> faces = facesInOrder(kept.built);
  for (const Face f : faces) result.kept.push_back(kept.inputs[kept.built.triangles[f]]);
  result.mesh = Closer(kept, meshOf(kept, faces), std::move(loops)).run();
  // Disks are no quads, and a triangle that was turned pairs with its neighbour the other way.
  result.mesh.isQuads = input.isQuads && result.mesh.indices == input.indices;
  return result;
}

}  // namespace remesher
