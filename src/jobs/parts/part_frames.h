// SPDX-License-Identifier: MIT
// Brings models of any size and at any place to about unit size near the origin, and back, so that
// place and size change no result; with axes of their own, nor do quarter turns. Areas, their
// squares and single precision numbers overflow or underflow long before lengths do; far from the
// origin the rounding of coordinates seems larger than it is. Parts that share the world's space
// share a frame (see CommonFrame). A part that is extreme beside it, or at another place, is moved
// and scaled by numbers of few digits.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/frame.h"
#include "base/part_options.h"
#include "io/model/model.h"
#include "jobs/parts/common_frame.h"

namespace remesher {

// Whether coordinates may be rounded on the way into the frame, and come back by a table, or
// frames are only those that hold each coordinate exactly.
enum class FrameRounding : char { Allowed, None };

class PartFrames {
 public:
  explicit PartFrames(const std::vector<io::Part>& parts,
                      FrameRounding rounding = FrameRounding::Allowed,
                      FrameAxes axes = FrameAxes::Given);

  // Whether applying changes anything.
  bool isNeeded() const;

  // The parts and the options at about unit size near the origin: each part in its own space, and
  // all in the world.
  std::vector<io::Part> applied(std::vector<io::Part> parts) const;
  PartOptions applied(PartOptions options) const;

  // Parts made from applied ones, back at the sizes and places of `originals`. A coordinate of an
  // original is exactly what it was.
  std::vector<io::Part> undone(std::vector<io::Part> parts,
                               const std::vector<io::Part>& originals) const;

  // A place on such a part.
  Vec3 undone(std::size_t part, const Vec3& p) const;

  // Where the part's first place shows a point in the world; the part is an applied one if that
  // is needed.
  Vec3 inWorld(const io::Part& part, const Vec3& p) const;

  // How many times as long a length in the part's own space is there.
  double growth(const io::Part& part) const;

  // A point of the applied world in the world as it was given.
  Vec3 unscaled(const Vec3& p) const { return world_.written(p); }

 private:
  void noteRounded(const std::vector<io::Part>& parts);
  Frame frameOf(std::size_t part) const;
  Transform placed(Transform place, std::size_t part) const;

  std::optional<CommonFrame> common_;  // of all parts' coordinates, before what follows
  std::vector<double> local_;          // per part
  std::vector<Vec3> origins_;          // per part, what moves to the origin before it is scaled
  bool isWorldCommon_ = false;
  Frame world_;
  // Per axis the coordinates that the common frame rounds: there, and as given; ascending.
  std::array<std::vector<std::pair<double, double>>, 3> rounded_;
};

}  // namespace remesher
