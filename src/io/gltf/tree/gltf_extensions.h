// SPDX-License-Identifier: MIT
// What becomes of extensions where triangles or textures are made anew: one table says of each
// whether it follows, goes, or cannot be affected; what it does not know goes if it holds any
// number, for that may be one of a vertex, a triangle or an accessor that were.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/report.h"
#include "io/gltf/tree/json.h"

namespace remesher::io {

// What of an extension went.
struct LostExtensions {
  std::map<std::string, std::size_t> count;  // by its name
  std::set<int> accessors;                   // that it may have named
};

// Whether texture coordinates still mean what they did.
enum class Texcoords { Kept, Painted };

// A primitive that has its new attributes.
void settlePrimitive(const Json& tree, Json& primitive, Texcoords texcoords, LostExtensions& lost);
// A mesh or an accessor whose content is made anew.
void settleHolder(Json& holder, LostExtensions& lost);

// EXTENSION_NOT_CARRIED, if anything went.
std::vector<Warning> warningsOf(const LostExtensions& lost);

// Variants that no primitive has any more go.
void dropUnusedVariants(Json& tree);

// `extensionsUsed` and `extensionsRequired` name no more than the tree needs; what is never seen,
// and so may be needed unseen, stays.
void settleDeclarations(const Json& before, Json& tree);

// What an extension names by number beside what is found in it: nothing; materials, textures or
// images; or anything at all.
enum class Hidden { Nothing, Looks, Anything };
Hidden hiddenIn(std::string_view extension);

// The first extension that the tree requires and the table does not know; empty: there is none.
std::string requiredUnknown(const Json& tree);

// Whether the file says that its indices may begin a strip or fan anew.
bool restartsPrimitives(const Json& tree);

}  // namespace remesher::io
