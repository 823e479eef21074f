// SPDX-License-Identifier: MIT
// When a level of detail may be shown instead of the finer one.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// `finer` is the report of the finer level, which a level does not take over before.
SwitchReport switchTo(const Report& level, const Report& finer);

// Of each part at its first place, the share of a screen that its disk covers at the switches.
void setCoverages(std::vector<io::Part>& parts, const Report& finest);

}  // namespace remesher
