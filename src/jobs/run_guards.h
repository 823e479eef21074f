// SPDX-License-Identifier: MIT
// What every public function does around its work: errors that say where, and times.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "base/phase_clock.h"
#include "base/report.h"

namespace remesher {

// Of a run's time, about.
inline constexpr double kReadShare = 0.05;

// What the machine cannot hold is said like everything else; all that was held is free again.
template <class Body>
auto withinMemory(Body body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  throw Error(ErrorCode::OutOfMemory, "The run needs more memory than there is.",
              "Ask for fewer vertices, or give the model in parts.");
}

// Errors that speak of a vertex or a triangle alone do not say of which file.
template <class Body>
auto inFile(const std::string& name, Body body) {
  try {
    return body();
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool saysWhere = name.empty() || message.find(legible(name)) != std::string::npos;
    if (error.code == ErrorCode::Cancelled || saysWhere) throw;
    throw Error(error.code, legible(name) + ": " + message, error.hint);
  }
}

inline Report timed(Report report, PhaseClock& clock) {
  report.phases = clock.finish();
  report.timings = timingsOf(report.phases);
  return report;
}

}  // namespace remesher
