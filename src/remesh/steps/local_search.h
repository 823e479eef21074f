// SPDX-License-Identifier: MIT
// Local search around bad triangles: changes of a triangle's edges and corners are proposed one by
// one, an objective says what each gains, and the best one is carried out.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "mesh/hubs.h"
#include "remesh/steps/run.h"

namespace remesher {

// The gain of the proposal at hand; if that is no more than `least`, or the proposal must not be
// carried out, anything up to `least`.
using Objective = std::function<double(double least)>;

// The best of the proposals so far.
struct BestChange {
  double gain = 0;
  LocalChange change = {};
};

// The proposals at an edge. Collapse: to where its ends meet best, either way; CollapseInto:
// into an end that stays as it is; Unite: the same, whatever curves lie there.
enum class EdgeMove { Flip, Split, Collapse, CollapseInto, Unite };

class LocalSearch {
 public:
  // hubs: collapses at them are not tried; may be null. begin: what is to be exceeded.
  LocalSearch(Run& run, Objective objective, const Hubs* hubs = nullptr, BestChange begin = {})
      : run_(run), objective_(std::move(objective)), hubs_(hubs), best_(std::move(begin)) {}

  const BestChange& best() const { return best_; }

  // Offers the proposal at hand: it becomes the best one if it gains more.
  void offer();

  // Offers all moves at each edge of a triangle, in this order.
  void offerAtEdges(Face f, std::initializer_list<EdgeMove> moves);

  // Offers to move v over the surface a step between each two neighbours that follow each other.
  // step: a share of the way.
  void offerStepsBetween(Vertex v, double step);

  // The same, and a step towards each neighbour.
  void offerSteps(Vertex v, double step);

  // Carries out the best change, if any gains something; it then is the proposal at hand.
  bool carryOut();

 private:
  bool isAtHub(Halfedge h) const;
  bool propose(Halfedge h, EdgeMove move);
  void offerWithin(Vertex v, std::span<const Vec3> weights);

  Run& run_;
  const Objective objective_;
  const Hubs* hubs_;
  BestChange best_;
};

// The triangles that have a cost, those with the highest first. cost: of a face, optional.
template <class Cost>
std::vector<Face> worstFirst(const HalfedgeMesh& mesh, const Cost& cost) {
  std::vector<std::pair<double, Face>> found;
  for (Face f(0); f.index < mesh.faceCapacity(); ++f.index)
    if (const auto own = mesh.isAlive(f) ? cost(f) : decltype(cost(f))())
      found.emplace_back(-*own, f);
  std::sort(found.begin(), found.end());
  std::vector<Face> faces;
  faces.reserve(found.size());
  for (const auto& [key, f] : found) faces.push_back(f);
  return faces;
}

// Mends each of the triangles as long as it is bad and mend(f) changes something, at most so many
// times in a row. Returns whether anything has changed.
template <class IsBad, class Mend>
bool mendEach(const std::vector<Face>& faces, int inARow, const IsBad& isBad, const Mend& mend) {
  bool isAny = false;
  for (const Face f : faces)
    for (int i = 0; i < inARow && isBad(f) && mend(f); ++i) isAny = true;
  return isAny;
}

}  // namespace remesher
