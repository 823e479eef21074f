// SPDX-License-Identifier: MIT
// Dijkstra's search for shortest paths from some vertices of a mesh. The caller goes on from each
// vertex that the search leaves, along what it takes for edges, and keeps what else it needs to
// know of the path.
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "base/types.h"
#include "mesh/handles.h"

namespace remesher {

class ShortestPaths {
 public:
  explicit ShortestPaths(std::size_t vertices) : distance_(vertices, kInfinity) {}

  // Reaches a vertex by a path of this length. False, and nothing changes, if it is no shorter
  // than the shortest known.
  bool reach(Vertex v, double distance) {
    if (!(distance < distance_[v])) return false;
    if (distance_[v] == kInfinity) reached_.push_back(v);
    distance_[v] = distance;
    open_.emplace(distance, v);
    return true;
  }

  // Leaves the nearest vertex that was reached, of several the lowest; none if all were left.
  // No shorter path to it is found later if edges have lengths of 0 or more.
  Vertex leave() {
    while (!open_.empty()) {
      const auto [distance, v] = open_.top();
      open_.pop();
      if (distance <= distance_[v]) return v;
    }
    return {};
  }

  // The length of the shortest path known; kInfinity if there is none.
  double operator[](Vertex v) const { return distance_[v]; }

  // The vertices that were reached, as they were reached first.
  const std::vector<Vertex>& reached() const { return reached_; }

  // For another search.
  void clear() {
    for (const Vertex v : reached_) distance_[v] = kInfinity;
    reached_.clear();
    open_ = {};
  }

 private:
  using Entry = std::pair<double, Vertex>;
  VertexData<double> distance_;
  std::vector<Vertex> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace remesher
