// SPDX-License-Identifier: MIT
#include "small_mesh.h"

#include <array>
#include <cstring>

namespace remesher::fuzz {
namespace {

constexpr unsigned kMostPlaces = 64;

}  // namespace

unsigned ByteSource::byte() {
  if (rest_.empty()) return 0;
  const unsigned value = rest_.front();
  rest_ = rest_.subspan(1);
  return value;
}

float ByteSource::real() {
  std::array<std::uint8_t, 4> bytes{};
  for (std::uint8_t& one : bytes) one = static_cast<std::uint8_t>(byte());
  float value = 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

TriangleMesh takeMesh(ByteSource& bytes, std::size_t mostTriangles) {
  TriangleMesh mesh;
  const unsigned vertices = 1 + bytes.byte() % kMostPlaces;
  for (unsigned v = 0; v < vertices; ++v) {
    const double x = bytes.real(), y = bytes.real(), z = bytes.real();
    mesh.positions.emplace_back(x, y, z);
  }
  while (!bytes.isEmpty() && mesh.triangleCount() < mostTriangles)
    for (int corner = 0; corner < 3; ++corner) mesh.indices.push_back(bytes.byte() % vertices);
  return mesh;
}

}  // namespace remesher::fuzz
