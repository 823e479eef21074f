// SPDX-License-Identifier: MIT
// Where formats disagree: the origin of texture coordinates, and the meaning of colours.
#pragma once

#include <limits>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher::io {

// Gltf: TEXCOORD_n counts from the image's top left corner, COLOR_n is linear. Classic, as in OBJ,
// OFF and PLY: texture coordinates count from the bottom left corner, colours are sRGB as in
// images.
enum class Conventions { Gltf, Classic };

// The transfer function of sRGB, IEC 61966-2-1, and its inverse.
double linearFromSrgb(double value);
double srgbFromLinear(double value);

// Marks the colour of a vertex without one in a mesh with colours: it becomes white.
inline constexpr float kUncolored = std::numeric_limits<float>::infinity();

// Colours as fractions. Some programs write bytes, which only the values show: a value above 2
// cannot be a rounded fraction.
std::vector<float> fractionsOf(std::vector<float> channels);

// The same mesh under other conventions. A byte of an sRGB colour survives the way there and back.
TriangleMesh converted(TriangleMesh mesh, Conventions from, Conventions to);

}  // namespace remesher::io
