// SPDX-License-Identifier: MIT
// Material libraries of OBJ. They are passed on as they come; what is read of them is the names of
// their images, which lie beside them and are nobody's business but to be told.
#pragma once

#include <string>
#include <vector>

#include "base/file.h"

namespace remesher::io {

// As the library spells them, each once, in the order of their first use.
std::vector<std::string> imagesOf(const File& library);

}  // namespace remesher::io
