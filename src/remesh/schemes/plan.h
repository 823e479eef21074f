// SPDX-License-Identifier: MIT
// The plan of a run, settled before any vertex moves: the input as a manifold with its curves and
// the target number of vertices; then the original surface with its sizes and error bound.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/part_options.h"
#include "base/progress.h"
#include "original/surface/size_field.h"
#include "remesh/gate/error_bound.h"
#include "remesh/ground/proxy.h"
#include "remesh/schemes/curve_choice.h"

namespace remesher {

struct Plan {
  BuiltMesh built;
  FeatureCurves curves;
  TransferRules transfer;      // of the attributes to the result
  std::vector<float> density;  // the caller's, per vertex of the original, or empty
  FlatRegions flats;
  Spikes spikes;
  std::size_t vertices;
  std::vector<Warning> warnings;
  std::size_t copies = 0;  // of these vertices, where joints are kept: so many places less
};

// Throws Error as buildMesh does, and NO_TRIANGLES, INVALID_OPTION, TARGET_TOO_SMALL,
// OUT_OF_MEMORY, CANCELLED.
Plan planRun(const TriangleMesh& input, Welding welding, const PartOptions& options,
             const Progress& progress);

// The warning that so many edges at which the surface was cut apart may no longer meet.
Warning jointsReleased(const TriangleMesh& input, const PartOptions& options, std::size_t count);

// The original surface and its belongings, made from the plan; const afterwards.
class Prepared {
 public:
  // Throws Error: TARGET_BELOW_CURVES, CANCELLED.
  Prepared(Plan plan, const PartOptions& options, const Progress& progress);
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  const OriginalSurface& surface() const { return surface_; }
  // A thinned copy of the surface if that has far more vertices than the target, else null.
  const Proxy* proxy() const { return proxy_ ? &*proxy_ : nullptr; }
  // The surface that remeshing begins with: the proxy if there is one.
  const OriginalSurface& ground() const { return proxy_ ? proxy_->surface() : surface_; }
  const SizeField& sizes() const;  // on the ground; computed when first asked for
  const std::optional<ErrorBound>& bound() const { return bound_; }
  const TransferRules& transfer() const { return transfer_; }
  const std::vector<Warning>& warnings() const { return warnings_; }
  std::size_t vertices() const { return vertices_; }  // the target
  std::size_t places() const { return vertices_ - copies_; }
  // The largest mean edge length during a run: that of the ground, or of the result's coarse level.
  double longestEdges() const;

 private:
  std::span<const float> densityOnGround();

  TransferRules transfer_;
  std::vector<Warning> warnings_;
  std::size_t copies_;
  std::vector<float> density_;
  Spikes spikes_;
  OriginalSurface surface_;
  std::optional<Proxy> proxy_;
  std::size_t vertices_;
  SizeRules rules_;
  mutable std::optional<SizeField> sizes_;
  std::optional<ErrorBound> bound_;
};

}  // namespace remesher
