// SPDX-License-Identifier: MIT
// The seam of the ablation benchmark, which measures what each step of a scheme is worth.
#pragma once

#include <string_view>

namespace remesher {

// Whether the scheme skips the step of that name. The product skips none: its definition is weak,
// and only the program of `npm run bench -- ablation` is linked with another one.
bool isLeftOut(std::string_view step);

}  // namespace remesher
