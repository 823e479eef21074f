// SPDX-License-Identifier: MIT
// tinygltf as all of our files see it: without images and files, of which it reads some without
// looking whether they are all there.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS

#include <tiny_gltf.h>
