// SPDX-License-Identifier: MIT
// What becomes of extensions when triangles or textures are made anew. One table says of each
// extension whether it follows, is dropped, or cannot be affected. An extension that the table does
// not know is dropped if it holds any integer, which may number an old vertex, triangle or
// accessor.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/report.h"
#include "io/gltf/tree/json.h"

namespace remesher::io {

// The parts of extensions that were lost.
struct LostExtensions {
  std::map<std::string, std::size_t> count;  // by extension name
  std::set<int> accessors;                   // accessors that these parts may have named
};

// Whether texture coordinates keep their meaning.
enum class Texcoords { Kept, Painted };

// Settles the extensions of a primitive that already has its new attributes.
void settlePrimitive(const Json& tree, Json& primitive, Texcoords texcoords, LostExtensions& lost);
// Settles the extensions of a mesh or an accessor whose content is new.
void settleHolder(Json& holder, LostExtensions& lost);

// EXTENSION_NOT_CARRIED, if anything was lost.
std::vector<Warning> warningsOf(const LostExtensions& lost);

// Drops the list of variants if no primitive has variants any more.
void dropUnusedVariants(Json& tree);

// Reduces `extensionsUsed` and `extensionsRequired` to what the tree needs. An extension that is
// declared and appeared nowhere before may be needed unseen, and stays, unless it is of triangles.
void settleDeclarations(const Json& before, Json& tree);

// The objects that an extension may name by number without being found here: nothing; materials,
// textures or images; or anything.
enum class Hidden { Nothing, Looks, Anything };
Hidden hiddenIn(std::string_view extension);

// The first extension that the tree requires and the table does not know; empty if none.
std::string requiredUnknown(const Json& tree);

// Whether the file says that its indices may restart strips and fans.
bool restartsPrimitives(const Json& tree);

}  // namespace remesher::io
