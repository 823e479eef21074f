// SPDX-License-Identifier: MIT
// Builds the body of a PLY file, value after value, in any encoding.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/ply/ply_header.h"
#include "io/text/text_writer.h"

namespace remesher::io {

class PlySink {
 public:
  explicit PlySink(const PlyHeader& header);

  // Integers are rounded to the nearest and clamped to their range.
  void put(PlyType type, double value);
  void endRow();
  std::vector<std::uint8_t> bytes() const;

 private:
  template <class Number>
  void store(double value);
  void putBinary(PlyType type, double value);

  PlyEncoding encoding_;
  TextWriter text_;
  bool isRowBegun_ = false;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace remesher::io
