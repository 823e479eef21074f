// SPDX-License-Identifier: MIT
// The bodies that a file names within one mesh, such as the objects of an OBJ, as parts.
#pragma once

#include <string>
#include <vector>

#include "io/model/model.h"

namespace remesher::io {

// The parts, each divided into the bodies that its groups are of: `names`, by number of the group.
// Bodies that share places of the surface stay one part with its name, so that no border opens; so
// does a part with levels of detail.
std::vector<Part> namedBodies(std::vector<Part> parts, const std::vector<std::string>& names);

}  // namespace remesher::io
