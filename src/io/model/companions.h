// SPDX-License-Identifier: MIT
// Names for the files that go with a result. A model may name its images anything, even
// ../../.profile, and callers may write `files` into a folder under their names. So each name here
// is plain, leads only below that folder, and is unique.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace remesher::io {

// Whether a name leads to one place below the folder where it is used, on any system. Its parts
// between slashes are not empty, hidden or reserved for devices. It has no backslash, colon or
// control character. All this also holds after any number of percent-decodings.
bool isPlainName(std::string_view name);

// The last part of a path as a plain name without folders; forbidden characters become _.
std::string plainName(std::string_view path);

class CompanionNames {
 public:
  // `result`: the file that the companions go with; its name is taken.
  explicit CompanionNames(std::string_view result);

  // The percent-decoded `reference` if that is plain, else its plainName. A name given out before,
  // in any case, gets a number.
  std::string nameFor(std::string_view reference);
  // For a name that is not percent-encoded, such as an OBJ's mtllib.
  std::string nameForFile(std::string_view name);

 private:
  std::string distinct(const std::string& name);

  std::map<std::string, int> used_;  // how often each name, in lower case, was asked for
};

// A relative reference to a file of this name.
std::string referenceTo(std::string_view name);

}  // namespace remesher::io
