// SPDX-License-Identifier: MIT
#include "targets.h"

#include <algorithm>
#include <array>

#include "gltf_changes.h"

namespace remesher::fuzz {
namespace {

constexpr std::array<Target, 12> kTargets = {{
    {"glb", readGlb, changedGlb},
    {"gltf", readGltf, changedGltf},
    {"obj", readObj, nullptr},
    {"off", readOff, nullptr},
    {"ply", readPly, nullptr},
    {"stl", readStl, nullptr},
    {"msh", readGmsh, nullptr},
    {"vtu", readVtu, nullptr},
    {"3mf", readThreemf, nullptr},
    {"builder", buildAnyMesh, nullptr},
    {"remesh", remeshSmallMesh, nullptr},
    {"repair", repairSmallMesh, nullptr},
}};

}  // namespace

std::span<const Target> targets() { return kTargets; }

const Target* findTarget(std::string_view name) {
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [&](const Target& target) { return target.name == name; });
  return found == kTargets.end() ? nullptr : &*found;
}

}  // namespace remesher::fuzz
