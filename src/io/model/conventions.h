// SPDX-License-Identifier: MIT
// What the formats do not agree on: where texture coordinates begin, and what colours mean.
#pragma once

#include <limits>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::io {

// Gltf: TEXCOORD_n counts from the image's top left corner, COLOR_n is linear. Classic, as in OBJ,
// OFF and PLY: from the bottom left corner, and colours are sRGB, as bytes of pictures are.
enum class Conventions { Gltf, Classic };

// The transfer function of sRGB, IEC 61966-2-1.
double linearFromSrgb(double value);

// Stands for the colour of a vertex that has none, where others have: it is white.
inline constexpr float kUncolored = std::numeric_limits<float>::infinity();

// Colours as fractions. Some programs write bytes, which nothing but the numbers tells: one beyond
// 2 is more than any rounding leaves of a fraction.
std::vector<float> fractionsOf(std::vector<float> channels);

// The same mesh under other conventions. A byte of an sRGB colour survives the way there and back.
TriangleMesh converted(TriangleMesh mesh, Conventions from, Conventions to);

}  // namespace remesher::io
