// SPDX-License-Identifier: MIT
// What is put into a message of ours. Foreign text: names and lines of files from anywhere may be
// of any length, and may hold what a terminal obeys or what turns the rest of a line around. The
// package's base/legible.js does the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remesher {

// The text with control characters and invisible ones as \u{1b}, bytes that are not UTF-8 as the
// replacement character; so in at most 120 characters, the middle left out of a longer one.
std::string legible(std::string_view text);

// `a, b, c`; of many names the first few, and how many more there are.
std::string legibleList(const std::vector<std::string>& names);

// What printf's %g says of a number, without printf, which is large: as many significant digits,
// from 1 to 17, but no zeros at the end: "0.0125", "1.25e+20", "nan".
std::string inDigits(double x, int digits);

}  // namespace remesher
