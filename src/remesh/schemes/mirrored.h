// SPDX-License-Identifier: MIT
// Quads of a model that planes mirror: made on one side, mirrored to the others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "remesh/schemes/number_note.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether a surface is all of a mesh, or one of several connected parts: work on all of these
// together stays in proportion.
struct Scope {
  bool isPart = false;  // one of several connected parts
  double share = 1;     // of the vertices of all of them
};
// Makes quads of a surface as it is.
using PlainRemesher = std::function<RemeshOutcome(
    const TriangleMesh& input, const PartOptions& options, Scope scope, const Progress& progress)>;
// Makes quads of a half, with its boundary along the planes: see PartOptions::mirrors.
using HalfRemesher =
    std::function<RemeshOutcome(const TriangleMesh& half, const PartOptions& options)>;

// What speaks against mirrored quads: few of them dent the shape where others are much nearer, an
// exact number makes many more vertices irregular, or few of them miss a number that others meet.
// Few quads are looked at only on parts with sharp corners: of round ones all are off by their
// chords.
class Flaws {
 public:
  struct Wish {
    AskedNumber number = {};
    bool hasCorners = false;  // whether the part has sharp ones
  };

  Flaws() = default;
  Flaws(const RemeshOutcome& quads, const TriangleMesh& input, const Wish& wish);

  bool areFewerByPlanes() const;  // whether quads mirrored by fewer planes may have fewer
  bool areSeen() const;           // whether quads that are not made mirrored may have fewer
  bool areMendedBy(const RemeshOutcome& others, const TriangleMesh& input) const;
  bool areMendedBy(const Flaws& others) const;

 private:
  Wish wish_;
  double sides_ = 0;  // that the farthest corner of the input is away
  std::size_t irregular_ = 0, off_ = 0, planes_ = 0;
  bool areCostly_ = false;  // single quads are missing in all images
};

struct MirroredOutcome {
  std::optional<RemeshOutcome> made;
  Flaws flaws;
  std::size_t planes = 0;         // that mirror the input
  std::vector<MirrorPlane> free;  // those by which quads may be mirrored
  std::string lost;               // why the quads are mirrored by fewer
};

// Mirrored by as many planes as possible without a flaw that fewer mend. None if no plane mirrors
// the input, if borders of materials, seams or the caller's own wishes for places are not mirrored,
// if the exact number or the surface's kind cannot be had so, or if another number takes single
// quads out. first: planes that are tried before those through the input's own middle.
MirroredOutcome remeshMirrored(const TriangleMesh& input, const std::vector<MirrorPlane>& first,
                               const PartOptions& options, const HalfRemesher& remeshHalf);

// Mirrored by the planes that the caller names, whatever the input is: the side with more surface
// is taken. Throws INVALID_OPTION if the wishes for places exclude that, or where nothing can be
// cut off so.
RemeshOutcome remeshForced(const TriangleMesh& input, const PartOptions& options,
                           const HalfRemesher& remeshHalf);

}  // namespace remesher
