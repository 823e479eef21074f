// SPDX-License-Identifier: MIT
// What the files that go with a result are called. A model may call its images anything,
// ../../.profile too: whoever writes `files` into a folder as they are named must be safe, so each
// name here is plain, leads nowhere but below that folder, and is there once.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace remesher::io {

// Whether a name leads to one place below the folder it is used in, on any system: parts between
// slashes, none of them empty, hidden, or kept for a device; no backslash, colon or control
// character; and nothing else after any number of percent-decodings.
bool isPlainName(std::string_view name);

// The last part of a path as a plain name without folders: what no system takes becomes _.
std::string plainName(std::string_view path);

class CompanionNames {
 public:
  // `result`: the file they go with, whose name is taken.
  explicit CompanionNames(std::string_view result);

  // As `reference` says, once percent-decoded, where that is plain; else what plainName makes of
  // it. A name given out before, in whatever case, gets a number.
  std::string nameFor(std::string_view reference);
  // For a name that was not decoded from anything, like an OBJ's mtllib.
  std::string nameForFile(std::string_view name);

 private:
  std::string distinct(const std::string& name);

  std::map<std::string, int> used_;  // how often each name, in lower case, was asked for
};

// A relative reference to a file of this name.
std::string referenceTo(std::string_view name);

}  // namespace remesher::io
