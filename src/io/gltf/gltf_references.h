// SPDX-License-Identifier: MIT
// Where a glTF tree names accessors and buffer views by number; new ones are added behind those
// that are there, so that a number which names nothing would come to name one of them. And whether
// it may name anything by a number that we do not understand.
#pragma once

#include <functional>

#include "io/gltf/gltf_document.h"

namespace remesher::io {

using NumberVisitor = std::function<void(Json& number)>;

void forEachAccessorNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumberOf(Json& accessor, const NumberVisitor& visit);

// What numbers name: accessors and buffer views; or materials, textures and images.
enum class Named { Data, Look };

// Whether there is a whole number in an extension below the value that may be one of these without
// being found.
bool mayHideReferences(const Json& value, Named what);

// Throws PARSE_ERROR unless every such number is one of what is there.
void requireReferences(GltfDocument& document);

}  // namespace remesher::io
