// SPDX-License-Identifier: MIT
// The table of diagnostics: the codes of all warnings, each with its severity. Texts in other
// languages than English are keyed by the code.
#pragma once

#include <span>
#include <string_view>

#include "base/report.h"

namespace remesher {

enum class Severity {
  Note,   // how something was done; nothing is lost
  Loss,   // something of the input, or something that was asked for, is not in the result
  Fault,  // the result has a fault that the input does not have, or keeps one that was to be mended
};

struct Diagnostic {
  std::string_view code;
  Severity severity;
};

// Sorted by code.
std::span<const Diagnostic> diagnostics();

// Of a code that is not in the table: Loss.
Severity severityOf(const Warning& warning);

}  // namespace remesher
