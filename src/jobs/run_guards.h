// SPDX-License-Identifier: MIT
// Wraps the work of every public function: errors that say where, and times.
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

// The approximate shares of the time that reading takes, of a run and of an inspection.
// bindings/package/worker/engine.js has the same numbers.
inline constexpr double kReadShare = 0.05;
inline constexpr double kInspectedRead = 0.2;

// Turns failed allocations into an Error; by then all memory of the work is free again.
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

// Adds the file's name to errors that do not say it, such as those of a vertex or a triangle.
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
