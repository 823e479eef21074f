// SPDX-License-Identifier: MIT
// What all readers have in common once the bytes are a file.
#pragma once

#include <string>
#include <utility>

#include "remesher.h"
#include "targets.h"

namespace remesher::fuzz {

// Reads the file, looks at what it holds, writes it in its own format and in another: `other`, a
// file's name. Where the file is refused, the sentence is looked at.
void readAndWrite(const FileBundle& bundle, const std::string& other);

// The bytes before the first zero byte, and those after it.
std::pair<Bytes, Bytes> splitAtZero(Input input);

}  // namespace remesher::fuzz
