// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/opening.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "mesh/topology.h"
#include "remesh/quads/extract/short_cycles.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

using Loop = std::vector<Halfedge>;

// The places along a boundary loop of a mesh, by arc length from its first vertex on.
class LoopPlaces {
 public:
  LoopPlaces(const WorkingMesh& mesh, const Loop& loop) : mesh_(mesh), loop_(loop), arcs_{0} {
    for (const Halfedge h : loop)
      arcs_.push_back(arcs_.back() +
                      (mesh.position(mesh.mesh().tip(h)) - mesh.position(origin(h))).norm());
  }

  double length() const { return arcs_.back(); }

  std::vector<double> corners() const {
    std::vector<double> found;
    for (std::size_t i = 0; i < loop_.size(); ++i)
      if (mesh_.kind(origin(loop_[i])) == VertexKind::Corner) found.push_back(arcs_[i]);
    return found;
  }

  // arc: from 0 to the length, or once around more.
  Placement at(double arc) const {
    if (arc >= length()) arc -= length();
    const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
    const Halfedge h = loop_[std::size_t(after - arcs_.begin()) - 1];
    const Vertex a = origin(h), b = mesh_.mesh().tip(h);
    const double from = *(after - 1), share = (arc - from) / (*after - from);
    if (share == 0) return mesh_.placement(a);
    const Index chain = mesh_.curve(h);
    const double first = mesh_.onChain(a, chain).arc, last = mesh_.onChain(b, chain).arc;
    return mesh_.onCurve({chain, first + share * (last - first)});
  }

  // None if the place is not on the loop.
  std::optional<double> arcOf(const Placement& place) const {
    if (place.kind == VertexKind::Interior) return {};
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const Vertex a = origin(loop_[i]);
      if (place.kind == VertexKind::Corner) {
        if (mesh_.kind(a) == VertexKind::Corner &&
            mesh_.originalCorner(mesh_.at(a)) == mesh_.originalCorner(place.at))
          return arcs_[i];
        continue;
      }
      const Index chain = mesh_.curve(loop_[i]);
      if (chain != place.on.chain) continue;
      const double from = mesh_.onChain(a, chain).arc,
                   to = mesh_.onChain(mesh_.mesh().tip(loop_[i]), chain).arc;
      const double share = (place.on.arc - from) / (to - from);
      if (share >= 0 && share <= 1) return arcs_[i] + share * (arcs_[i + 1] - arcs_[i]);
    }
    return {};
  }

 private:
  Vertex origin(Halfedge h) const { return mesh_.mesh().origin(h); }

  const WorkingMesh& mesh_;
  const Loop& loop_;
  std::vector<double> arcs_;  // from the loop's start to each of its vertices, and all around
};

// Four places on a loop for the corners of its quad: the loop's own corners, at most four, then the
// middles of the widest gaps.
class FourOnLoop {
 public:
  FourOnLoop(const WorkingMesh& mesh, const Loop& loop)
      : places_(mesh, loop), at_(places_.corners()) {
    if (at_.empty()) at_.push_back(0);
    while (at_.size() > 4) dropNearest();
    while (at_.size() < 4) divideWidest();
  }

  // In the order of the loop.
  Four<Placement> places() const {
    return {places_.at(at_[0]), places_.at(at_[1]), places_.at(at_[2]), places_.at(at_[3])};
  }

 private:
  double gapAfter(std::size_t i) const {
    return i + 1 < at_.size() ? at_[i + 1] - at_[i] : at_[0] + places_.length() - at_[i];
  }

  void divideWidest() {
    std::size_t widest = 0;
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (gapAfter(i) > gapAfter(widest)) widest = i;
    const double middle = at_[widest] + gapAfter(widest) / 2;
    at_.push_back(middle < places_.length() ? middle : middle - places_.length());
    std::sort(at_.begin(), at_.end());
  }

  void dropNearest() {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (gapAfter(i) < gapAfter(nearest)) nearest = i;
    at_.erase(at_.begin() + std::ptrdiff_t(nearest));
  }

  const LoopPlaces places_;
  std::vector<double> at_;
};

// Where quads at the border are missing, others end off the border: their vertices move onto it, in
// their order between the nearest ones that are on it.
class BorderClosing {
 public:
  BorderClosing(QuadMesh& quads, const WorkingMesh& mesh)
      : quads_(quads), sides_(quads.vertices.size(), quads.quads) {
    for (const Loop& loop : loops_ = boundaryLoops(mesh.mesh()))
      if (std::all_of(loop.begin(), loop.end(), [&](Halfedge h) { return mesh.isCurve(h); }))
        places_.emplace_back(mesh, loop);
  }

  void run() {
    std::vector<char> seen(sides_.size(), 0);
    for (Index i = 0; i < sides_.size(); ++i) {
      if (sides_.across(i) != kNone || seen[i]) continue;
      std::vector<Index> loop;
      for (Index side = i; !seen[side]; side = sides_.outgoing(sides_.tip(side))) {
        seen[side] = 1;
        loop.push_back(sides_.origin(side));
      }
      for (const LoopPlaces& places : places_)
        if (close(loop, places)) break;
    }
  }

 private:
  // False if the quads' loop is not beside the loop of these places.
  bool close(const std::vector<Index>& loop, const LoopPlaces& places) {
    std::vector<std::optional<double>> arcs;
    for (const Index v : loop) arcs.push_back(places.arcOf(quads_.vertices[v]));
    const auto first = std::find_if(arcs.begin(), arcs.end(), [](auto& arc) { return bool(arc); });
    if (first == arcs.end()) return false;
    const auto begin = std::size_t(first - arcs.begin()), count = loop.size();
    for (std::size_t i = begin; i < begin + count;) {
      std::size_t next = i + 1;
      while (!arcs[next % count]) ++next;
      double span = *arcs[next % count] - *arcs[i % count];
      if (span <= 0) span += places.length();
      // Ends in the wrong order would be joined the long way round.
      if (next > i + 1 && 2 * span < places.length())
        for (std::size_t k = i + 1; k < next; ++k) {
          const double share = double(k - i) / double(next - i);
          quads_.vertices[loop[k % count]] = places.at(*arcs[i % count] + share * span);
        }
      i = next;
    }
    return true;
  }

  QuadMesh& quads_;
  const QuadSides sides_;
  std::vector<Loop> loops_;
  std::vector<LoopPlaces> places_;
};

class Opening {
 public:
  Opening(QuadMesh& quads, const WorkingMesh& mesh)
      : quads_(quads), mesh_(mesh), isGone_(quads.quads.size(), 0) {
    const QuadSides sides(quads.vertices.size(), quads.quads);
    for (Index v = 0; v < quads.vertices.size(); ++v)
      isOpen_.push_back(sides.isBoundary(v) || sides.valence(v) < 3);
  }

  void run(const Simpler& simpler) {
    for (const CutHandle& handle : simpler.handles) join(handle);
    for (const Loop& loop : boundaryLoops(mesh_.mesh())) {
      if (hasVertexOn(loop)) continue;
      const Four<Placement> places = FourOnLoop(mesh_, loop).places();
      const bool isWithin = isWithinQuad(lengthOf(mesh_, loop), simpler.side);
      const auto [quad, first] = nearestTo(places, isWithin);
      if (quad == kNone) continue;
      isWithin ? takeWithin(quad) : take(quad);
      for (Index i = 0; i < 4; ++i)
        quads_.vertices[quads_.quads[quad][(first + 4 - i) % 4]] = places[i];
    }
    isGone_.resize(quads_.quads.size(), 0);
    dropQuads(quads_, isGone_);
  }

 private:
  // Whether the quads have a vertex on the loop.
  bool hasVertexOn(const Loop& loop) const {
    std::set<Index> chains;
    std::set<Vertex> corners;
    for (const Halfedge h : loop) {
      chains.insert(mesh_.curve(h));
      const Vertex v = mesh_.mesh().origin(h);
      if (mesh_.kind(v) == VertexKind::Corner) corners.insert(mesh_.originalCorner(mesh_.at(v)));
    }
    return std::any_of(quads_.vertices.begin(), quads_.vertices.end(), [&](const Placement& place) {
      return place.kind == VertexKind::Corner
                 ? corners.contains(mesh_.originalCorner(place.at))
                 : place.kind == VertexKind::Curve && chains.contains(place.on.chain);
    });
  }

  bool isFree(Index q) const {
    const Four<Index>& quad = quads_.quads[q];
    return !isGone_[q] && std::all_of(quad.begin(), quad.end(), [&](Index v) {
      return !isOpen_[v] && quads_.vertices[v].kind == VertexKind::Interior;
    });
  }

  // The quad nearest to the places, its corners taken clockwise, and its corner at the first place;
  // kNone if there is none. isWithin: whether a smaller quad is taken out of the quad. Else the
  // quad must be free, because its corners move to the places.
  std::pair<Index, Index> nearestTo(const Four<Placement>& places, bool isWithin) const {
    double least = kInfinity;
    std::pair<Index, Index> nearest = {kNone, 0};
    for (Index q = 0; q < isGone_.size(); ++q) {
      if (isWithin ? isGone_[q] : !isFree(q)) continue;
      for (Index turn = 0; turn < 4; ++turn) {
        double sum = 0;
        for (Index i = 0; i < 4; ++i)
          sum += (quads_.position(quads_.quads[q][(turn + 4 - i) % 4]) - places[i].position)
                     .squaredNorm();
        if (sum >= least) continue;
        least = sum;
        nearest = {q, turn};
      }
    }
    return nearest;
  }

  void take(Index q) {
    isGone_[q] = 1;
    for (const Index v : quads_.quads[q]) isOpen_[v] = 1;
  }

  // Puts a smaller quad into a quad and removes the smaller one.
  void takeWithin(Index q) {
    shrink(quads_, q, quads_.vertices[quads_.quads[q].front()].at, mesh_);
    isOpen_.resize(quads_.vertices.size(), 0);
    take(q);
  }

  // The quad nearest to a point of those that face a direction; kNone if there is none.
  Index nearestFacing(const Vec3& p, const Vec3& facing) const {
    double least = kInfinity;
    Index nearest = kNone;
    for (Index q = 0; q < isGone_.size(); ++q) {
      if (isGone_[q]) continue;
      const auto& [a, b, c, d] = quads_.quads[q];
      const Vec3 across = quads_.position(c) - quads_.position(a);
      const Vec3 other = quads_.position(d) - quads_.position(b);
      if (across.cross(other).dot(facing) <= 0) continue;
      double sum = 0;
      for (const Index v : quads_.quads[q]) sum += (quads_.position(v) - p).squaredNorm();
      if (sum >= least) continue;
      least = sum;
      nearest = q;
    }
    return nearest;
  }

  // Removes a smaller quad at each end of a cut and joins the two rims by four quads. Corners pair
  // so that the squared distances sum to least.
  void join(const CutHandle& handle) {
    const Index one = nearestFacing(handle.middle, handle.facing);
    const Index other = nearestFacing(handle.middle, -handle.facing);
    if (one == kNone || other == kNone) return;
    takeWithin(one);
    takeWithin(other);
    const Four<Index> near = quads_.quads[one], far = quads_.quads[other];
    const auto apart = [&](std::size_t turn) {
      double sum = 0;
      for (std::size_t i = 0; i < 4; ++i)
        sum += (quads_.position(near[i]) - quads_.position(far[(turn + 4 - i) % 4])).squaredNorm();
      return sum;
    };
    std::size_t turn = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (apart(i) < apart(turn)) turn = i;
    for (std::size_t i = 0; i < 4; ++i) {
      quads_.quads.push_back(
          {near[i], near[(i + 1) % 4], far[(turn + 3 - i) % 4], far[(turn + 4 - i) % 4]});
      quads_.curves.push_back({kNone, kNone, kNone, kNone});
    }
  }

  QuadMesh& quads_;
  const WorkingMesh& mesh_;
  std::vector<char> isGone_;  // of the quads
  std::vector<char> isOpen_;  // of the vertices: on a boundary, in a doublet, or of a removed quad
};

}  // namespace

void openAgain(QuadMesh& quads, const WorkingMesh& mesh, const Simpler& simpler) {
  Opening(quads, mesh).run(simpler);
}

void closeToBorder(QuadMesh& quads, const WorkingMesh& mesh) { BorderClosing(quads, mesh).run(); }

}  // namespace remesher
