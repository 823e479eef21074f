// SPDX-License-Identifier: MIT
#include "original/surface/boundary_places.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A strip 80 long whose upper side has eight slopes of ten edges, in turn up and down by a tenth.
OriginalSurface strip() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 80, 1, [&](int i, int k) {
    const int phase = i % 20;
    return Vec3(i, k == 0 ? 0 : 5 + 0.1 * std::min(phase, 20 - phase), 0);
  });
  return shapes::surfaceOf(mesh);
}

// The long side through a place.
Index sideAt(const OriginalSurface& surface, double height) {
  const auto& chains = surface.curves().chains();
  for (Index i = 0; i < chains.size(); ++i)
    for (const Vertex v : chains[i].vertices)
      if (surface.positions()[v].isApprox(Vec3(40, height, 0))) return i;
  return kNone;
}

double farthest(const OriginalSurface& surface, Index chain, const std::vector<double>& arcs) {
  double most = 0;
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i)
    most = std::max(most, chordDistance(surface, chain, arcs[i], arcs[i + 1]));
  return most;
}

}  // namespace

TEST_CASE("boundary_places: as many vertices as a zigzag has bends find all of them") {
  const OriginalSurface surface = strip();
  const Index chain = sideAt(surface, 5);
  REQUIRE(chain != kNone);
  const double length = surface.curves().chains()[chain].length();
  for (const double shift : {-0.4, -0.2, 0.2, 0.4}) {
    CAPTURE(shift);
    std::vector<double> arcs = {0};
    for (int i = 1; i < 8; ++i) arcs.push_back((i + shift) * length / 8);
    arcs.push_back(length);
    REQUIRE(farthest(surface, chain, arcs) > 0.1);
    const std::vector<double> places = placesAlong(surface, chain, arcs, 0.01);
    CHECK(farthest(surface, chain, places) <= 0.01);
    CHECK(places.front() == arcs.front());
    CHECK(places.back() == arcs.back());
    CHECK(std::is_sorted(places.begin(), places.end()));
  }
}

TEST_CASE("boundary_places: along a straight side even vertices stay, others become more even") {
  const OriginalSurface surface = strip();
  const Index chain = sideAt(surface, 0);
  REQUIRE(chain != kNone);
  const std::vector<double> even = {0, 16, 32, 48, 64, 80};
  CHECK(placesAlong(surface, chain, even, 0.01) == even);
  const std::vector<double> places =
      placesAlong(surface, chain, std::vector<double>{0, 10, 80}, 0.01);
  CHECK(places[1] > 10);
  CHECK(places[1] < 40);
}
