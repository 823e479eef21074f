// SPDX-License-Identifier: MIT
// The warning that quads miss the requested number of vertices.
#pragma once

#include <cmath>
#include <string>

#include "remesh/quads/quads.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

struct AskedNumber {
  std::size_t vertices = 0;
  bool isExact = false;
};

inline bool isMet(std::size_t vertices, const AskedNumber& asked) {
  const double off = std::abs(double(vertices) - double(asked.vertices));
  return off <= (asked.isExact ? 0 : kCountTolerance * double(asked.vertices));
}

inline bool isNumberNote(const Warning& warning) { return warning.code == "QUADS_NUMBER_MISSED"; }

// Adds QUADS_NUMBER_MISSED if the number is not met; too many vertices of a run that stopped before
// have a warning of their own, TOO_FEW_VERTICES.
inline void noteNumber(RemeshOutcome& made, const AskedNumber& asked) {
  if (isMet(made.vertices, asked)) return;
  if (made.stopped != Stopped::Target && made.vertices > asked.vertices) return;
  const char* why = ": no row of quads fits in, and none can be divided.";
  if (made.stopped == Stopped::Target)
    why = made.mirrors.empty()
              ? ": nearer numbers cost more irregular vertices."
              : ": nearer numbers cost more irregular vertices or planes that mirror the quads.";
  made.warnings.push_back(
      {"QUADS_NUMBER_MISSED", "The quads have " + std::to_string(made.vertices) +
                                  " vertices, not " + (asked.isExact ? "exactly " : "") +
                                  std::to_string(asked.vertices) + why});
}

}  // namespace remesher
