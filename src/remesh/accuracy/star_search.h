// SPDX-License-Identifier: MIT
// A pattern search for the place of a vertex that makes the largest distance around it smallest: on
// and off the surface, or along its curve.
#pragma once

#include <span>

#include "remesh/accuracy/two_sided_distance.h"
#include "remesh/gate/crossings.h"

namespace remesher {

// A vertex to move. No angle around it may fall below `keepAngle` or, if the smallest one is below
// already, below that one.
struct Movable {
  Vertex vertex;
  double keepAngle;
};

class StarSearch {
 public:
  StarSearch(const Run& run, const Crossings& crossings, TwoSidedDistance& distances,
             const Movable& movable);

  double distance() const { return distance_; }  // at the best place so far
  const Placement& best() const { return best_; }

  // Searches until no step helps.
  void descend();

 private:
  bool keepsAngles(const Vec3& position) const;
  bool offer(const Placement& place);  // the place must keep the angles
  bool isAllowed(const Placement& place);
  bool crosses();  // whether the best place makes triangles pass through each other
  Placement at(const Vec3& position) const;
  template <typename Look>
  void search(const Look& look);
  void move(std::span<const Vec3> steps);
  void slide();
  void lookAround();

  const Run& run_;
  const WorkingMesh& mesh_;
  const FidelityRule rule_;
  const Crossings& crossings_;
  TwoSidedDistance& distances_;
  const Vertex v_;
  const double spoke_;  // the mean length of its edges
  Placement best_;
  double distance_;
  double lowest_;
  bool looksForCrossings_ = false;
  LocalChange change_;
};

}  // namespace remesher
