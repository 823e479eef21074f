// SPDX-License-Identifier: MIT
// Compares isotropic triangles with the simplified original: the facts by which the chooser takes
// one of them.
#pragma once

#include <optional>
#include <utility>

#include "remesh/operators/working_mesh.h"
#include "remesh/schemes/follow.h"
#include "remesh/schemes/plan.h"

namespace remesher {

// The largest distance that is not seen, as a share of the diagonal: half a pixel in a picture a
// thousand pixels wide.
constexpr double kSeen = 5e-4;

// Whether a surface is made of facets, flat or about something round, which may be meshed by
// themselves.
bool isFaceted(const BuiltMesh& built);

// The other candidates are made on first use.
class ShapeComparison {
 public:
  ShapeComparison(const Prepared& original, const TriangleMesh& input, const PartOptions& options);

  // Judges isotropic triangles before they are finished. Returns whether finishing them is in vain
  // because the simplified mesh is so much nearer.
  bool endsEarly(const WorkingMesh& unfinished);
  // The findings of endsEarly; false if it was not asked.
  bool isUnfinishedFar() const { return unfinished_ == Unfinished::Far; }
  bool isUnfinishedNear() const { return unfinished_ == Unfinished::Near; }

  // Whether finished isotropic triangles are seen to be away from the original.
  bool isSeen(const WorkingMesh& isotropic);
  bool hasSimplified();
  // Whether the simplified mesh exists and is so much nearer that it is worth its uneven triangles.
  bool isSimplifiedNearer(const WorkingMesh& isotropic);
  // Whether a mesh conforms to the facets of flat sides, and its triangles are so well shaped that
  // isotropic ones need not be made.
  bool areFacetsFine();
  // Whether a mesh conforms to the facets of flat sides and is better than finished isotropic
  // triangles, because these are seen to be away or hardly more even.
  bool isConformingBetter(const WorkingMesh& isotropic);
  bool hasConforming();
  // Whether it has facets that were unrolled.
  bool isUnrolled() const { return farthest_ > 0; }
  // Whether the triangles of the facets are poorly shaped, though there are vertices enough, and
  // finished isotropic triangles keep the part but for dents that are hardly seen.
  bool isIsotropicInstead(const WorkingMesh& isotropic);
  // Whether more vertices are wanted than the original has, and flat sides show each dent.
  bool refinesFlatSides();

  // Leaves none here.
  Followed takeSimplified() { return std::move(*simplified()); }
  Followed takeConforming() { return std::move(*conforming()); }

 private:
  enum class Unfinished { Unknown, Near, Far };

  bool isOwn();
  bool hasEnough();
  bool hasForShape();
  void unrollFacets();
  struct WantedAngles {
    double mean, least;  // degrees
  };
  bool takeUnrolled(double farthest, const WantedAngles& wanted);
  bool isPart();
  bool isAllFacets() const;  // but for small round places
  // Whether a mesh of facets is worth making.
  bool mayConform(const WorkingMesh& isotropic);
  bool isNearlySeen(const WorkingMesh& isotropic);
  bool keepsPart(const WorkingMesh& isotropic);
  bool isSeen(const Away& away);
  const Away& awayOf(const WorkingMesh& isotropic);
  Away measured(const WorkingMesh& isotropic);
  double muchNearer();     // how many times nearer the simplified mesh must be
  double seenOnAverage();  // the largest RMS distance that is not seen, model units
  std::optional<Followed>& simplified();
  std::optional<Followed>& conforming();

  const Prepared& original_;
  const TriangleMesh& input_;
  Textures textures_;
  double longest_;  // see PartOptions
  bool isPlain_;    // no textures, no colours, no second group
  double unseen_;   // the largest distance at any one point that is not seen, model units
  std::optional<bool> isOwn_, hasEnough_, isPart_, isIsotropicInstead_;
  Unfinished unfinished_ = Unfinished::Unknown;
  std::optional<Away> finished_;  // of the finished isotropic triangles
  bool isSimplified_ = false;     // whether simplification was tried
  std::optional<Followed> simplified_;
  bool isConforming_ = false;  // whether facets were tried
  std::optional<Followed> conforming_;
  double farthest_ = 0;  // of unrolled facets, in units of kSeen
};

}  // namespace remesher
