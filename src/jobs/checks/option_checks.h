// SPDX-License-Identifier: MIT
// Which options go together, for C++ programs; JavaScript's checks come from its table of options.
#pragma once

#include "base/options.h"

namespace remesher {

// Throws INVALID_OPTION for options that exclude each other and would give a wrong result, not just
// be without effect.
void checkTogether(const RemeshOptions& options);

}  // namespace remesher
