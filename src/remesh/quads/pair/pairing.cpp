// SPDX-License-Identifier: MIT
#include "remesh/quads/pair/pairing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/quad.h"
#include "original/surface/surface_walk.h"

namespace remesher {

namespace {

// An alternating path longer than this turns a whole region for two triangles.
constexpr std::size_t kLongestPath = 16;

// How well the triangles at an edge make a square along the field: the sine of its worst corner,
// and how near its diagonal is to 45° from the cross. None if they may not be joined.
std::optional<double> scoreOf(const WorkingMesh& mesh, const FaceFrames& frames,
                              const CrossField& field, Halfedge h) {
  const HalfedgeMesh& m = mesh.mesh();
  const Halfedge twin = m.twin(h);
  if (!twin || mesh.isCurve(h)) return {};
  const Quad corners = {mesh.position(m.origin(h)), mesh.position(m.opposite(twin)),
                        mesh.position(m.tip(h)), mesh.position(m.opposite(h))};
  const double worst = leastSine(corners);
  if (worst < kLeastSine || m.opposite(twin) == m.opposite(h)) return {};
  double along = 0;
  for (const Halfedge side : {h, twin})
    along -= std::cos(4 * (frames.angle(side) - field.angle[HalfedgeMesh::face(side)])) / 2;
  return worst + along;
}

class Pairing {
 public:
  Pairing(const WorkingMesh& mesh, const FaceFrames& frames, const CrossField& field)
      : mesh_(mesh.mesh()),
        mayJoin_(mesh_.halfedgeCapacity(), 0),
        mate_(mesh_.faceCapacity(), Face()) {
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh_.isEdge(h)) continue;
      const std::optional<double> score = scoreOf(mesh, frames, field, h);
      if (!score) continue;
      mayJoin_[h] = mayJoin_[mesh_.twin(h)] = 1;
      scores_.emplace_back(-*score, h);
    }
    std::sort(scores_.begin(), scores_.end());
  }

  FaceData<Face> run() {
    for (const auto& [score, h] : scores_) {
      const Face f = HalfedgeMesh::face(h), g = HalfedgeMesh::face(mesh_.twin(h));
      if (!mate_[f] && !mate_[g]) join(f, g);
    }
    for (Index i = 0; i < mate_.size(); ++i)
      if (!mate_[Face(i)]) augment(Face(i));
    for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
      if (mesh_.isAlive(Vertex(i)) && !mesh_.isBoundary(Vertex(i))) keepThreeEdges(Vertex(i));
    return std::move(mate_);
  }

 private:
  void join(Face f, Face g) {
    mate_[f] = g;
    mate_[g] = f;
  }

  template <class Visit>
  void forEachPartner(Face f, Visit visit) const {
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge h = HalfedgeMesh::halfedge(f, corner);
      if (mayJoin_[h]) visit(HalfedgeMesh::face(mesh_.twin(h)));
    }
  }

  // Searches breadth first from a single triangle to the nearest other one. The path parts pairs;
  // each of their triangles is joined with its neighbour on the path.
  void augment(Face start) {
    struct Step {
      Face face;
      std::size_t before, length;
    };
    std::vector<Step> steps = {{start, 0, 0}};
    std::vector<Face> seen = {start};
    const auto isSeen = [&](Face f) {
      return std::find(seen.begin(), seen.end(), f) != seen.end();
    };
    for (std::size_t i = 0; i < steps.size() && steps[i].length < kLongestPath; ++i) {
      Face found;
      forEachPartner(steps[i].face, [&](Face next) {
        if (found || isSeen(next)) return;
        if (!mate_[next]) {
          found = next;
          return;
        }
        seen.insert(seen.end(), {next, mate_[next]});
        steps.push_back({mate_[next], i, steps[i].length + 1});
      });
      if (!found) continue;
      for (std::size_t k = i;; k = steps[k].before) {
        const Face freed = mate_[steps[k].face];
        join(steps[k].face, found);
        if (k == 0) return;
        found = freed;
      }
    }
  }

  // An inner vertex left with only two edges would lie between two quads that share two sides.
  void keepThreeEdges(Vertex v) {
    int edges = mesh_.valence(v);
    std::vector<Face> joined;
    mesh_.forEachOutgoing(v, [&](Halfedge h) {
      const Face f = HalfedgeMesh::face(h);
      if (mate_[f] != HalfedgeMesh::face(mesh_.twin(h))) return;
      joined.push_back(f);
      --edges;
    });
    for (std::size_t i = 0; edges < 3 && i < joined.size(); ++i, ++edges)
      mate_[std::exchange(mate_[joined[i]], Face())] = Face();
  }

  const HalfedgeMesh& mesh_;
  HalfedgeData<char> mayJoin_;
  FaceData<Face> mate_;
  std::vector<std::pair<double, Halfedge>> scores_;
};

class Splitting {
 public:
  Splitting(const WorkingMesh& mesh, const FaceData<Face>& pairs)
      : mesh_(mesh), pairs_(pairs), middle_(mesh.mesh().halfedgeCapacity(), kNone) {}

  QuadMesh run() {
    const HalfedgeMesh& m = mesh_.mesh();
    for (Index v = 0; v < m.vertexCapacity(); ++v)
      result_.vertices.push_back(mesh_.placement(Vertex(v)));
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!m.isEdge(h) || isInside(h)) continue;
      middle_[h] = add(middleOf(h));
      if (m.twin(h)) middle_[m.twin(h)] = middle_[h];
    }
    for (Index f = 0; f < m.faceCapacity(); ++f)
      if (!pairs_[Face(f)] || Face(f) < pairs_[Face(f)]) divide(loopAround(Face(f)));
    return std::move(result_);
  }

 private:
  // Whether the edge is the diagonal of a pair.
  bool isInside(Halfedge h) const {
    const Halfedge twin = mesh_.mesh().twin(h);
    return twin && pairs_[HalfedgeMesh::face(h)] == HalfedgeMesh::face(twin);
  }

  // The edges around a pair, or a triangle, counterclockwise.
  std::vector<Halfedge> loopAround(Face f) const {
    std::vector<Halfedge> loop;
    for (int corner = 0; corner < 3; ++corner) {
      const Halfedge h = HalfedgeMesh::halfedge(f, corner);
      if (!isInside(h)) {
        loop.push_back(h);
        continue;
      }
      const Halfedge beyond = HalfedgeMesh::next(mesh_.mesh().twin(h));
      loop.insert(loop.end(), {beyond, HalfedgeMesh::next(beyond)});
    }
    return loop;
  }

  void divide(const std::vector<Halfedge>& loop) {
    const HalfedgeMesh& m = mesh_.mesh();
    Vec3 sum = Vec3::Zero();
    for (const Halfedge h : loop) sum += mesh_.position(m.origin(h));
    const Index centre = add(near(loop.front(), sum / double(loop.size())));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Halfedge out = loop[i], in = loop[(i + loop.size() - 1) % loop.size()];
      result_.quads.push_back({m.origin(out).index, middle_[out], centre, middle_[in]});
      result_.curves.push_back({mesh_.curve(out), kNone, kNone, mesh_.curve(in)});
    }
  }

  Index add(const Placement& place) {
    result_.vertices.push_back(place);
    return Index(result_.vertices.size() - 1);
  }

  Placement middleOf(Halfedge h) const {
    const Vertex a = mesh_.mesh().origin(h), b = mesh_.mesh().tip(h);
    if (!mesh_.isCurve(h)) return near(h, (mesh_.position(a) + mesh_.position(b)) / 2);
    const Index chain = mesh_.curve(h);
    const double arcs = mesh_.onChain(a, chain).arc + mesh_.onChain(b, chain).arc;
    return mesh_.onCurve({chain, arcs / 2});
  }

  // The point of the original nearest to p that is reached from the origin of h, on the side of
  // face(h).
  Placement near(Halfedge h, const Vec3& p) const {
    return mesh_.onSurface(closestPointFrom(mesh_.surface(), mesh_.cornerPoint(h), p));
  }

  const WorkingMesh& mesh_;
  const FaceData<Face>& pairs_;
  HalfedgeData<Index> middle_;
  QuadMesh result_;
};

}  // namespace

FaceData<Face> pairTriangles(const WorkingMesh& mesh, const FaceFrames& frames,
                             const CrossField& field) {
  return Pairing(mesh, frames, field).run();
}

QuadMesh splitPairs(const WorkingMesh& mesh, const FaceData<Face>& pairs) {
  return Splitting(mesh, pairs).run();
}

}  // namespace remesher
