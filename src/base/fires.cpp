// SPDX-License-Identifier: MIT
#include "base/fires.h"

namespace remesher {

[[gnu::weak]] void fires(std::string_view) {}

}  // namespace remesher
