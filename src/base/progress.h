// SPDX-License-Identifier: MIT
// Progress of one run, passed down by value: each stage divides its own share among its steps, so
// that the fraction the caller sees only ever grows. The callback's `false` cancels the run: the
// stack unwinds through Error{Cancelled}. The run's clock, if any, learns where a phase begins.
#pragma once

#include <functional>
#include <string_view>

#include "base/error.h"
#include "base/phase_clock.h"

namespace remesher {

class Progress {
 public:
  // Called with the stage's name and the share of the whole run done, 0 to 1. May be empty.
  using Callback = std::function<bool(std::string_view phase, double fraction)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  // The same progress, with phases timed by this clock, which must outlive it.
  Progress timedBy(PhaseClock& clock) const {
    Progress result = *this;
    result.clock_ = &clock;
    return result;
  }

  // Begins a phase of this name, which takes the stretch from `from` to `to` (0 to 1) of this one.
  Progress phase(std::string_view name, double from, double to) const {
    Progress result = part(from, to);
    result.phase_ = name;
    if (clock_) clock_->enter(name);
    result.at(0);
    return result;
  }

  // The stretch from `from` to `to` (0 to 1) of this one.
  Progress part(double from, double to) const {
    Progress result = *this;
    result.begin_ = begin_ + from * length_;
    result.length_ = (to - from) * length_;
    return result;
  }

  // Throws Error{Cancelled} when the caller no longer wants the result.
  void at(double fraction) const {
    if (callback_ && !callback_(phase_, begin_ + fraction * length_))
      throw Error(ErrorCode::Cancelled, "The run was cancelled.");
  }

 private:
  Callback callback_;
  PhaseClock* clock_ = nullptr;
  std::string_view phase_ = "remesh";
  double begin_ = 0;
  double length_ = 1;
};

}  // namespace remesher
