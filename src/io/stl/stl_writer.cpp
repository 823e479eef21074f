// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "base/error.h"
#include "io/model/bake.h"
#include "io/model/dropped.h"
#include "io/stl/stl.h"

namespace remesher::io {
namespace {

// Must not begin with `solid`, which readers take for text.
constexpr std::string_view kHeader = "binary STL written by remesher";

using Corners = std::array<Eigen::Vector3f, 3>;

Eigen::Vector3f single(const Vec3& position) {
  constexpr auto kLargest = double{std::numeric_limits<float>::max()};
  if (position.lpNorm<Eigen::Infinity>() <= kLargest) return position.cast<float>();
  throw Error(ErrorCode::Unsupported,
              "A coordinate is too large for STL, which has numbers of single precision.",
              "Write OBJ or OFF, or scale the model down.");
}

// The normal of the corners as written; zero for a facet without area. Edges are scaled to unit
// length first, so that no product overflows or vanishes.
Eigen::Vector3f normalOf(const Corners& corners) {
  const Vec3 first = (corners[1].cast<double>() - corners[0].cast<double>()).stableNormalized();
  const Vec3 second = (corners[2].cast<double>() - corners[0].cast<double>()).stableNormalized();
  const Vec3 normal = first.cross(second);
  const double length = normal.norm();
  return length > 0 ? (normal / length).cast<float>().eval() : Eigen::Vector3f::Zero().eval();
}

template <class Value>
void append(std::vector<std::uint8_t>& bytes, const Value& value) {
  std::array<std::uint8_t, sizeof(Value)> raw;
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void append(std::vector<std::uint8_t>& bytes, const Eigen::Vector3f& vector) {
  for (const float coordinate : vector) append(bytes, coordinate);
}

std::vector<std::uint8_t> stlBytes(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> bytes(kHeader.begin(), kHeader.end());
  bytes.resize(kHeaderBytes, ' ');
  bytes.reserve(kFacetsAt + kFacetBytes * mesh.triangleCount());
  append(bytes, static_cast<std::uint32_t>(mesh.triangleCount()));
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = single(mesh.positions[mesh.indices[i + k]]);
    append(bytes, normalOf(corners));
    for (const Eigen::Vector3f& corner : corners) append(bytes, corner);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

WrittenFiles writeStl(const Model& model, const std::string& outputName) {
  WrittenFiles written;
  written.files.push_back({outputName, stlBytes(mergeParts(bakeInstances(model)))});
  written.warnings = droppedAttributes(model, {}, "STL");
  return written;
}

}  // namespace remesher::io
