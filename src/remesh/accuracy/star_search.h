// SPDX-License-Identifier: MIT
// Where a vertex makes the largest of the distances around it smallest: a pattern search over
// places on and off the surface, or along its curve.
#pragma once

#include <span>

#include "remesh/accuracy/two_sided_distance.h"
#include "remesh/gate/crossings.h"

namespace remesher {

// A vertex to move. Of the angles around it, what is below `keepAngle` may not shrink; what is
// above may not fall below it.
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

  // Until the distance is no more than `enough`, or nothing helps.
  void descend(double enough);

 private:
  bool keepsAngles(const Vec3& position) const;
  bool offer(const Placement& place);  // one that keeps them
  bool isAllowed(const Placement& place);
  bool crosses();  // whether the best place makes triangles pass through each other
  Placement at(const Vec3& position) const;
  template <typename Look>
  void search(double enough, const Look& look);
  void move(double enough, std::span<const Vec3> steps);
  void slide(double enough);
  void lookAround(double enough);

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
