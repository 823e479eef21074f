// SPDX-License-Identifier: MIT
// Files that another file refers to: found by the name it uses, decoded from data URIs, and named
// as URIs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"

namespace remesher::io {

// The file that `reference` means: of exactly this name, else of its percent-decoded form, else
// the only one whose last path component is the same. Null when there is none.
const File* findResource(const std::vector<File>& resources, std::string_view reference);

// What follows the last slash, forward or backward.
std::string_view baseName(std::string_view path);

std::string percentDecoded(std::string_view text);
std::string percentEncoded(std::string_view text);

bool isDataUri(std::string_view uri);
// The bytes of a base64 or percent-encoded data URI; nothing if it is malformed.
std::optional<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri);
std::string encodeDataUri(std::string_view mediaType, std::span<const std::uint8_t> bytes);

}  // namespace remesher::io
