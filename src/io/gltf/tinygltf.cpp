// SPDX-License-Identifier: MIT
// tinygltf's implementation, which is compiled here, with the type of JSON that keeps the order of
// names, which is ours: a second one is large. The headers are those it forgets to include, or
// includes hidden.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#define TINYGLTF_IMPLEMENTATION
#define json ordered_json
#include "io/gltf/tinygltf.h"
