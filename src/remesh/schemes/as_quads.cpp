// SPDX-License-Identifier: MIT
#include "remesh/schemes/as_quads.h"

#include <optional>
#include <string>
#include <utility>

#include "remesh/schemes/guided.h"
#include "remesh/schemes/part_by_part.h"
#include "remesh/symmetry/own_mirrors.h"

namespace remesher {

namespace {

// Of a part with fewer vertices hardly any quad is far from a plane.
constexpr Index kWorthMirroring = 32;

// A part may be mirrored even if the whole is not.
RemeshOutcome remeshAlone(const SurfacePart& part, const PartOptions& options,
                          const PlainRemesher& plain, Scope scope, const Progress& progress) {
  const bool isTiny = part.planes.empty() && options.vertices.value_or(kNone) < kWorthMirroring;
  if (scope.isPart && isTiny) return plain(part.mesh, options, scope, progress);
  MirroredOutcome mirrored = remeshMirrored(
      part.mesh, part.planes, options,
      [&](const auto& half, auto& own) { return plain(half, own, scope, progress); });
  std::optional<RemeshOutcome>& made = mirrored.made;
  if (!made || made->mirrors.size() < mirrored.free.size() || mirrored.flaws.areSeen()) {
    RemeshOutcome whole = plain(part.mesh, options, scope, progress);
    whole.mirrors = mirrorOwn(whole.mesh, mirrored.free);
    const bool isReached = whole.stopped == Stopped::Target;
    if (!made || (isReached && (whole.mirrors.size() > made->mirrors.size() ||
                                mirrored.flaws.areMendedBy(whole, part.mesh))))
      made = std::move(whole);
  }
  const std::size_t used = made->mirrors.size(), all = mirrored.planes;
  if (used < all)
    made->warnings.push_back({"QUADS_SYMMETRY_LOST",
                              "Not all planes that mirror the surface, or a connected part of it, "
                              "mirror its quads: " +
                                  mirrored.lost + ".",
                              all - used});
  return std::move(*mirrored.made);
}

RemeshOutcome remeshUnguided(const TriangleMesh& input, const Welding& welding,
                             const PartOptions& options, const PlainRemesher& plain,
                             const Progress& progress) {
  if (isForced(options.symmetry))
    return remeshForced(input, options, [&](const TriangleMesh& half, const PartOptions& own) {
      const auto remeshed = [&](const SurfacePart& part, const PartOptions& its,
                                const Progress& stretch) {
        return plain(part.mesh, its, {true, part.share}, stretch);
      };
      std::optional<RemeshOutcome> parts =
          remeshPartByPart(half, Welding(half), own, remeshed, progress);
      return parts ? std::move(*parts) : plain(half, own, {}, progress);
    });
  const auto remeshed = [&](const SurfacePart& part, const PartOptions& its,
                            const Progress& stretch) {
    return remeshAlone(part, its, plain, {true, part.share}, stretch);
  };
  std::optional<RemeshOutcome> parts =
      remeshPartByPart(input, welding, options, remeshed, progress);
  if (parts) return std::move(*parts);
  SurfacePart all;
  all.mesh = input;
  return remeshAlone(all, options, plain, {}, progress);
}

}  // namespace

RemeshOutcome remeshAsQuads(const TriangleMesh& input, const Welding& welding,
                            const PartOptions& options, const PlainRemesher& plain,
                            const Progress& progress) {
  if (options.guides.empty()) return remeshUnguided(input, welding, options, plain, progress);
  PartOptions own = options;
  own.guides = guidesOn(input, options);
  const auto guided = [&](const TriangleMesh& part, const PartOptions& its, Scope scope,
                          const Progress& stretch) {
    return remeshGuided(part, its, [&](const TriangleMesh& divided, const PartOptions& last) {
      return plain(divided, last, scope, stretch);
    });
  };
  return remeshUnguided(input, welding, own, guided, progress);
}

}  // namespace remesher
