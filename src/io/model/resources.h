// SPDX-License-Identifier: MIT
// Files that another file refers to: finds them by the name used, decodes data URIs, and makes
// URIs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"

namespace remesher::io {

// The given files by name: a file may name thousands of others. The files must outlive it.
class Resources {
 public:
  explicit Resources(const std::vector<File>& files);

  // The file that `reference` means: the file of exactly this name, else of its percent-decoded
  // form, else the only file with the same last path component. Null if there is none.
  const File* find(std::string_view reference) const;
  // The first file of exactly this name, or null.
  const File* named(std::string_view name) const;

 private:
  std::map<std::string_view, const File*> byName_;
  std::map<std::string_view, const File*> byBaseName_;  // null: several could be meant
};

// The part behind the last slash or backslash.
std::string_view baseName(std::string_view path);
// Of A to Z only.
std::string lowerCase(std::string_view name);

std::string percentDecoded(std::string_view text);
std::string percentEncoded(std::string_view text);

bool isDataUri(std::string_view uri);
// The bytes of a base64 or percent-encoded data URI; none if it is malformed.
std::optional<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri);
std::string encodeDataUri(std::string_view mediaType, std::span<const std::uint8_t> bytes);

}  // namespace remesher::io
