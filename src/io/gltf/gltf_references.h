// SPDX-License-Identifier: MIT
// Visits the numbers by which a glTF tree names accessors and buffer views. New ones are added
// behind the existing ones, so a number that names nothing would come to name one of these. Also
// tells whether numbers that we do not understand may name something.
#pragma once

#include <functional>

#include "io/gltf/gltf_document.h"

namespace remesher::io {

using NumberVisitor = std::function<void(Json& number)>;

void forEachAccessorNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumber(Json& tree, const NumberVisitor& visit);
void forEachBufferViewNumberOf(Json& accessor, const NumberVisitor& visit);

// The targets of a number: accessors and buffer views, or materials, textures and images.
enum class Named { Data, Look };

// Whether an extension below the value holds an integer that may name one of these unnoticed.
bool mayHideReferences(const Json& value, Named what);

// Throws PARSE_ERROR unless every such number names something that exists.
void requireReferences(GltfDocument& document);

}  // namespace remesher::io
