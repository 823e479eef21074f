// SPDX-License-Identifier: MIT
// A glTF file's JSON, its members in the file's order.
#pragma once

#include <cstdint>

#include "io/model/json.h"

namespace remesher::io {

using Json = nlohmann::ordered_json;

// From 0 on.
inline bool isWholeNumber(const Json& value) {
  return value.is_number_unsigned() ||
         (value.is_number_integer() && value.get<std::int64_t>() >= 0);
}

}  // namespace remesher::io
