// SPDX-License-Identifier: MIT
// Materials without their images.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/model/model.h"

namespace remesher {

bool hasImages(const io::Material& look);

// Its colours and factors, under this name.
io::Material withoutImages(io::Material look, const std::string& name);

// The number of this material among all; it is added if it is new.
std::size_t numberOf(const io::Material& look, std::vector<io::Material>& all);

// Leaves out texture coordinates and tangents, and the maps of materials.
void dropTextures(io::Model& model);
void dropTexcoords(TriangleMesh& mesh);

}  // namespace remesher
