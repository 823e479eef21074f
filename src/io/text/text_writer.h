// SPDX-License-Identifier: MIT
// Builds text files. Numbers get the fewest digits that read back as the same value: as the same
// float if the number is a float, otherwise as the same double.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/triangle_mesh.h"
#include "base/types.h"

namespace remesher::io {

// Fewest: as above. OfDoubles: coordinates are the same to a reader of doubles, too, to whom the
// fewest digits of a float name another number.
enum class Digits { Fewest, OfDoubles };

class TextWriter {
 public:
  explicit TextWriter(Digits digits = Digits::Fewest) : digits_(digits) {}

  TextWriter& text(std::string_view text);
  TextWriter& number(double value);
  TextWriter& doubleNumber(double value);  // always with the digits of a double
  TextWriter& coordinate(double value);
  TextWriter& integer(std::size_t value);
  TextWriter& coordinates(const Vec3& values);  // each behind a blank

  std::vector<std::uint8_t> bytes() const { return {text_.begin(), text_.end()}; }

 private:
  Digits digits_;
  std::string text_;
};

// The digits for a file of these meshes: those of doubles where a coordinate of any mesh is no
// float, so that all vertices of the file have the same precision, or where the caller wants them.
Digits digitsFor(const std::vector<const TriangleMesh*>& meshes, Digits wanted);

// The float that TextWriter writes as this number; the number itself if there is none.
double singleWrittenAs(double value);

}  // namespace remesher::io
