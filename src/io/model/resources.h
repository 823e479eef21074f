// SPDX-License-Identifier: MIT
// Files that another file refers to: finds them by the name used, decodes data URIs, and makes
// URIs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"

namespace remesher::io {

// The file that `reference` means: the file of exactly this name, else of its percent-decoded form,
// else the only file with the same last path component. Null if there is none.
const File* findResource(const std::vector<File>& resources, std::string_view reference);

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
