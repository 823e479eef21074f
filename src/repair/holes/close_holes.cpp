// SPDX-License-Identifier: MIT
#include "repair/holes/close_holes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "measure/self_intersections.h"
#include "repair/holes/fairing.h"
#include "repair/holes/kept_surface.h"
#include "repair/holes/loop_triangulation.h"
#include "repair/holes/plug_attributes.h"
#include "repair/holes/refinement.h"

namespace remesher {

namespace {

// A plug's shapes, the best first.
enum class Shape { Smooth, Flat, Bare };
constexpr std::array kShapes = {Shape::Smooth, Shape::Flat, Shape::Bare};

Plug plugOf(const BuiltMesh& built, const Loop& loop, Shape shape) {
  Plug plug = triangulated(built, loop);
  if (shape != Shape::Bare) refine(plug, built, loop);
  if (shape == Shape::Smooth) fair(plug, built, loop);
  return plug;
}

// The kept triangles in input order, each starting at its original first corner.
TriangleMesh meshOf(const TriangleMesh& input, const BuiltMesh& built) {
  std::vector<Index> faces(built.mesh.faceCapacity());
  std::iota(faces.begin(), faces.end(), Index{0});
  std::sort(faces.begin(), faces.end(),
            [&](Index f, Index g) { return built.triangles[Face(f)] < built.triangles[Face(g)]; });
  TriangleMesh mesh = input;
  mesh.indices.clear(), mesh.groups.clear();
  for (const Index f : faces) {
    for (int k = 0; k < 3; ++k)
      mesh.indices.push_back(built.wedges[HalfedgeMesh::halfedge(Face(f), k)]);
    if (!input.groups.empty()) mesh.groups.push_back(input.groups[built.triangles[Face(f)]]);
  }
  return mesh;
}

// A loop being closed. meetings: per shape tried, how many of its triangles intersect others.
struct Closing {
  Loop loop;
  std::size_t shape = 0;
  Plug plug = {};
  std::array<std::size_t, kShapes.size()> meetings = {};
};

class Closer {
 public:
  Closer(const TriangleMesh& input, const BuiltMesh& built, std::vector<Loop> loops)
      : input_(input), built_(built), kept_(meshOf(input, built)) {
    for (Loop& loop : loops) closings_.push_back({std::move(loop)});
    for (Closing& closing : closings_) choose(closing, 0);
  }

  TriangleMesh run() {
    for (std::size_t round = 0; round < kShapes.size() && retry(); ++round) continue;
    return assembled();
  }

 private:
  void choose(Closing& closing, std::size_t shape) {
    closing.shape = shape;
    closing.plug = plugOf(built_, closing.loop, kShapes[shape]);
    for (std::size_t v = closing.loop.vertices.size(); v < closing.plug.points.size(); ++v)
      if (input_.isSingle) closing.plug.points[v] = inSingle(closing.plug.points[v], input_.scale);
  }

  TriangleMesh assembled() const {
    TriangleMesh mesh = kept_;
    for (const Closing& closing : closings_) appendPlug(mesh, built_, closing.loop, closing.plug);
    return mesh;
  }

  // Gives each intersecting plug its next shape; after the last, the shape with the fewest
  // intersecting triangles. Returns whether any plug took a next shape.
  bool retry() {
    if (closings_.empty()) return false;
    const std::vector<Index> hits =
        selfIntersectionsFrom(assembled(), Index(kept_.triangleCount()));
    std::size_t end = kept_.triangleCount(), hit = 0;
    bool isAny = false;
    for (Closing& closing : closings_) {
      end += closing.plug.triangles.size();
      std::size_t count = 0;
      for (; hit < hits.size() && hits[hit] < end; ++hit) ++count;
      closing.meetings[closing.shape] = count;
      if (count == 0) continue;
      if (closing.shape + 1 < kShapes.size()) {
        choose(closing, closing.shape + 1), isAny = true;
        continue;
      }
      const auto least = std::min_element(closing.meetings.begin(), closing.meetings.end());
      choose(closing, std::size_t(least - closing.meetings.begin()));
    }
    return isAny;
  }

  const TriangleMesh& input_;
  const BuiltMesh& built_;
  const TriangleMesh kept_;
  std::vector<Closing> closings_;
};

}  // namespace

ClosedHoles closeHoles(const TriangleMesh& input, double longest) {
  const KeptSurface kept = keptSurface(input);
  std::vector<Loop> loops = boundaryLoops(kept.built);
  ClosedHoles result;
  for (const Loop& loop : loops)
    if (loop.length > longest) result.openAt.push_back(kept.built.positions[loop.vertices.front()]);
  std::erase_if(loops, [&](const Loop& loop) { return loop.length > longest; });
  result.holes = loops.size();
  result.islands = kept.islands;
  result.trianglesRemoved = kept.trianglesRemoved;
  result.kept = kept.built.triangles.values();
  std::sort(result.kept.begin(), result.kept.end());
  result.mesh = Closer(input, kept.built, std::move(loops)).run();
  return result;
}

}  // namespace remesher
