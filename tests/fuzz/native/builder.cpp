// SPDX-License-Identifier: MIT
#include "laws.h"
#include "mesh/mesh_builder.h"
#include "small_mesh.h"
#include "support/mesh_check.h"
#include "targets.h"

void remesher::fuzz::buildAnyMesh(Input input) {
  constexpr std::size_t kMostTriangles = 1000;
  ByteSource bytes(input);
  const TriangleMesh mesh = takeMesh(bytes, kMostTriangles);
  try {
    const BuiltMesh built = buildMesh(mesh);
    const std::string broken = check(built.mesh);
    require(broken.empty(), broken.c_str());
    require(built.mesh.faceCount() <= mesh.triangleCount(), "no triangle is made");
  } catch (const Error& error) {
    requireSentence(error);
  }
}
