// SPDX-License-Identifier: MIT
// Counts how often the code falls back to another way, or a limit on its work holds.
#pragma once

#include <string_view>

namespace remesher {

// Called where a fallback is taken or a limit holds; the name is a literal and unique. The
// product's definition is weak and does nothing: only the program of `npm run bench -- fires` is
// linked with one that counts. A fallback that never fires over models, cases and laws is deleted.
void fires(std::string_view name);

}  // namespace remesher
