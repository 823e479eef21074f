// SPDX-License-Identifier: MIT
#include "laws.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace remesher::fuzz {

void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", law);
  std::abort();
}

void requireSentence(const Error& error) {
  const bool isOurs = error.code == ErrorCode::Internal || error.code == ErrorCode::Cancelled;
  const std::string_view message = error.what();
  if (isOurs || !message.ends_with('.')) std::fprintf(stderr, "%s\n", error.what());
  require(!isOurs, "an error is the caller's fault");
  require(message.ends_with('.'), "a message is a sentence");
  require(message.size() < 1000, "a message is short");
}

void requireWhole(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.indices.size() % 3 == 0, "triangles have three corners");
  require(
      std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](Index v) { return v < vertices; }),
      "corners are vertices");
  require(std::all_of(mesh.positions.begin(), mesh.positions.end(),
                      [](const Vec3& p) { return p.allFinite(); }),
          "coordinates are finite");
  require(mesh.groups.empty() || mesh.groups.size() == mesh.triangleCount(),
          "every triangle has a group, or none has");
  for (const Attribute& attribute : mesh.attributes) {
    require(attribute.values.size() == vertices * std::size_t(attribute.itemSize),
            "an attribute has a value per vertex");
    require(std::all_of(attribute.values.begin(), attribute.values.end(),
                        [](float x) { return std::isfinite(x); }),
            "values of attributes are finite");
  }
}

}  // namespace remesher::fuzz
