// SPDX-License-Identifier: MIT
#include "remesh/conforming/conforming.h"

#include <vector>

#include "base/place.h"
#include "remesh/conforming/refinement.h"
#include "remesh/conforming/smoothing_facets.h"
#include "remesh/conforming/thinning.h"

namespace remesher {

namespace {

std::size_t placesOf(const FacetedMesh& mesh) {
  std::vector<Vec3> places;
  for (Index i = 0; i < mesh.mesh().vertexCapacity(); ++i)
    if (mesh.mesh().isAlive(Vertex(i))) places.push_back(mesh.positions()[Vertex(i)]);
  return countPlaces(places);
}

}  // namespace

std::unique_ptr<FacetedMesh> makeConforming(const BuiltMesh& original,
                                            const HalfedgeData<char>& seams,
                                            std::size_t positions) {
  auto mesh = std::make_unique<FacetedMesh>(original, seams);
  if (mesh->hasOpenSeam()) return nullptr;
  thinOut(*mesh);
  // Vertices of sheets that coincide may come to lie in one place.
  constexpr int kMostRounds = 4;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t now = placesOf(*mesh);
    if (now > positions || !refineFacets(*mesh, positions - now)) return nullptr;
    if (!mesh->isSound()) return nullptr;
    smoothFacets(*mesh);
    if (placesOf(*mesh) == positions) return mesh;
  }
  return nullptr;
}

}  // namespace remesher
