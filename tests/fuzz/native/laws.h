// SPDX-License-Identifier: MIT
// Ends the process, as fuzzers expect of a failure.
#pragma once

#include "base/error.h"
#include "base/triangle_mesh.h"

namespace remesher::fuzz {

// Prints the law and aborts, unless it holds.
void require(bool holds, const char* law);

// An error is an answer where it is the caller's fault and says so in a sentence.
void requireSentence(const Error& error);

// Numbers are finite, indices in range, lists as long as they must be.
void requireWhole(const TriangleMesh& mesh);

}  // namespace remesher::fuzz
