// SPDX-License-Identifier: MIT
// Where a glTF tree names accessors and buffer views by number; new ones are added behind those
// that are there, so that a number which names nothing would come to name one of them. And whether
// it may name anything by a number that we do not understand.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "io/gltf/gltf_document.h"

namespace remesher::io {

using NumberVisitor = std::function<void(Json& number)>;

void forEachAccessorNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumberOf(Json& accessor, const NumberVisitor& visit);

// Whether there is a whole number in an extension below the value whose name begins with none of
// the prefixes: it may be that of anything.
bool hasUnknownReferences(const Json& value, std::span<const std::string_view> harmless);

// From 0 on.
bool isWholeNumber(const Json& value);

// Throws PARSE_ERROR unless every such number is one of what is there.
void requireReferences(GltfDocument& document);

}  // namespace remesher::io
