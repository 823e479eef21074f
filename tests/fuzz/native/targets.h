// SPDX-License-Identifier: MIT
// What is fuzzed: each target takes any bytes and returns; what must not happen ends the process.
// A file of its own implements each, so that a crash names it; libfuzzer.cpp and replay.cpp are the
// two programs around them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace remesher::fuzz {

using Bytes = std::vector<std::uint8_t>;
using Input = std::span<const std::uint8_t>;

// Readers: the bytes as a file of the format, with what it may refer to.
void readGlb(Input input);
void readGltf(Input input);  // up to the first zero byte the JSON, then the buffer it refers to
void readObj(Input input);   // up to the first zero byte the model, then its material library
void readOff(Input input);
void readPly(Input input);
void readStl(Input input);
void readGmsh(Input input);
void readVtu(Input input);
void readThreemf(Input input);  // the XML of the model
// See small_mesh.h for the bytes of these three.
void buildAnyMesh(Input input);
void remeshSmallMesh(Input input);
void repairSmallMesh(Input input);  // with groups and attributes, as arrays and as files

struct Target {
  std::string_view name;
  void (*run)(Input input);
  // The input, changed as its format invites to; unset: bytes are changed at random.
  Bytes (*change)(Input input, unsigned seed);
};

std::span<const Target> targets();

// Null if there is none of this name.
const Target* findTarget(std::string_view name);

}  // namespace remesher::fuzz
