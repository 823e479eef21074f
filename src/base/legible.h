// SPDX-License-Identifier: MIT
// Makes foreign text safe to show in our messages. Names and lines from files may be of any length,
// and may hold terminal commands or marks that reverse the rest of a line. The package's
// base/legible.js does the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remesher {

// Control and invisible characters become \u{1b}, bytes that are not UTF-8 the replacement
// character. The result has at most 120 characters: a longer text loses its middle.
std::string legible(std::string_view text);

// `a, b, c`; of a long list only the first few names, and the number of the others.
std::string legibleList(const std::vector<std::string>& names);

// Formats a number like printf's %g, but without printf, which is large code. Up to `digits`
// significant digits, from 1 to 17, without trailing zeros: "0.0125", "1.25e+20", "nan".
std::string inDigits(double x, int digits);

}  // namespace remesher
