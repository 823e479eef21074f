// SPDX-License-Identifier: MIT
// Strategy: isotropic triangles on an original surface.
#pragma once

#include <cstddef>
#include <optional>

#include "original/surface/original_tree.h"
#include "remesh/gate/quantum.h"
#include "remesh/operators/projection.h"
#include "remesh/operators/working_mesh.h"
#include "remesh/schemes/bodies.h"
#include "remesh/schemes/plan.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/shape_comparison.h"

namespace remesher {

// The result of a run on the original.
struct Remeshed {
  WorkingMesh mesh;
  Stopped stopped;
  std::size_t coincident;  // see moveApart
  Unmet unmet = {};
};

// Whether a result may intersect itself. MendInPlace: as few triangles as can be mended where they
// are, for meshes that others are made from.
enum class CrossingRule { Leave, MendInPlace, Mend };

inline CrossingRule crossingsAfter(const PartOptions& options) {
  return options.repair == Repair::Off ? CrossingRule::Leave : CrossingRule::Mend;
}

// The settings of a run besides its original.
struct RunSettings {
  const PartOptions& options;
  double stagger;  // see Run
  Quantum quantum;
  ShapeComparison* comparison;  // with the mesh that may be taken instead, or null
  OriginalTree& tree;
  const Bodies& bodies;
  CrossingRule crossings = CrossingRule::Leave;
};

Quantum quantumOf(const TriangleMesh& input);

// Projects onto the surface that remeshing begins with.
Projector projectorFor(const Prepared& original, const PartOptions& options);

// The vertices that repaired surfaces of many pieces or handles are made of, where those asked for
// do not suffice; otherwise 0. Any smaller number makes the same mesh.
std::size_t enoughInstead(const Prepared& original, const PartOptions& options);

// Throws CANCELLED.
Remeshed remeshOriginal(const Prepared& original, const RunSettings& settings,
                        const Progress& progress);

// Isotropic triangles of a plan, and the original that they are made on.
class Isotropic {
 public:
  Isotropic(Plan plan, const TriangleMesh& input, const PartOptions& options,
            const Progress& progress)
      : input_(input),
        options_(options),
        original_(std::move(plan), options_, progress),
        comparison_(original_, input, options_),
        tree_(original_.surface(), &input),
        bodies_(input, options_.bodies) {}

  const Prepared& original() const { return original_; }
  ShapeComparison& comparison() { return comparison_; }
  const WorkingMesh& mesh() const { return made_->mesh; }
  bool isMade() const { return made_.has_value(); }
  bool isReached() const { return made_->stopped == Stopped::Target; }

  // comparison: may end the run early; or null.
  void make(CrossingRule crossings, ShapeComparison* comparison, const Progress& progress);
  // prefer: what the report calls it.
  RemeshOutcome outcome(Prefer prefer, const Progress& progress);

 private:
  const TriangleMesh& input_;
  const PartOptions options_;
  const Prepared original_;
  ShapeComparison comparison_;
  OriginalTree tree_;
  const Bodies bodies_;
  std::optional<Remeshed> made_;
};

}  // namespace remesher
