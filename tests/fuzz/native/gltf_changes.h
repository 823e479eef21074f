// SPDX-License-Identifier: MIT
// glTF changed as its structure invites to: a field of the JSON, an accessor, sparse data, a skin,
// quantised attributes, compression that is none, or bytes of the buffer. What is no glTF any more
// is changed as bytes.
#pragma once

#include "targets.h"

namespace remesher::fuzz {

Bytes changedGlb(Input input, unsigned seed);
// The JSON, a zero byte, the buffer.
Bytes changedGltf(Input input, unsigned seed);

}  // namespace remesher::fuzz
