// SPDX-License-Identifier: MIT
// Builds text files. Numbers get the fewest digits that read back as the same value: as the same
// float if the number is a float, otherwise as the same double.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace remesher::io {

class TextWriter {
 public:
  TextWriter& text(std::string_view text);
  TextWriter& number(double value);
  TextWriter& doubleNumber(double value);  // always with the digits of a double
  TextWriter& integer(std::size_t value);
  TextWriter& numbers(const Vec3& values);  // each behind a blank

  std::vector<std::uint8_t> bytes() const { return {text_.begin(), text_.end()}; }

 private:
  std::string text_;
};

// The float that TextWriter writes as this number; the number itself if there is none.
double singleWrittenAs(double value);

}  // namespace remesher::io
