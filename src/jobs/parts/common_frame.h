// SPDX-License-Identifier: MIT
// The frame that parts of one space are worked on in: about the middle of their box, its longest
// side between 1 and 2, along the axes of the file or of the surface's own: the widest spread of
// corners first, away from their longer tail, as far as the surface tells that clearly. Coordinates
// in decimals, and those of few binary digits, become whole numbers of the largest step that all
// share, times a power of two: the same numbers wherever the model lies, and in whatever unit of
// length its steps are whole.
#pragma once

#include <optional>
#include <vector>

#include "base/frame.h"
#include "io/model/model.h"

namespace remesher {

enum class FrameAxes : char { Given, Own };

struct CommonFrame {
  Frame frame;
  bool isInSteps = false;  // all coordinates are whole steps; else going there may round them

  Vec3 here(const Vec3& p) const { return isInSteps ? frame.hereInSteps(p) : frame.here(p); }
};

// None for parts without an extent, of extreme coordinates, of single precision numbers far from
// the origin, which are rounded where they are, and where rounding would change edges.
std::optional<CommonFrame> commonFrame(const std::vector<io::Part>& parts,
                                       FrameAxes axes = FrameAxes::Given);

}  // namespace remesher
