// SPDX-License-Identifier: MIT
// tinygltf as all our files include it: without images and file access, where it may read without
// checking that all bytes exist.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS

#include <tiny_gltf.h>
