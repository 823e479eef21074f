// SPDX-License-Identifier: MIT
#include "remesh/accuracy/narrow_sizes.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

#include "remesh/accuracy/places.h"

namespace remesher {
namespace {

// In target lengths: nearer places do not decide the largest distance.
constexpr double kDecisive = 0.1;
// As many vertices there are for each triangle that is far away.
constexpr std::size_t kVerticesPerFace = 200;
// The largest share of the vertices that may be spent there.
constexpr double kMostSpent = 0.05;

// The distance that all but the farthest triangles keep; places come by falling distance.
double nextDistance(const std::vector<Place>& places, std::size_t vertices) {
  std::unordered_set<Index> faces;
  for (const Place& place : places) {
    faces.insert(place.nearest.index);
    if (faces.size() * kVerticesPerFace > vertices) return place.distance;
  }
  return places.empty() ? 0 : places.back().distance;
}

}  // namespace

std::size_t narrowSizes(Run& run) {
  std::vector<Place> places = measurePlaces(run, kDecisive, kDecisive);
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance > b.distance; });
  const double next = nextDistance(places, run.mesh.mesh().vertexCount());
  std::vector<std::pair<Vertex, double>> sizes;
  for (const Place& place : places) {
    if (place.distance <= next) break;
    for (const Vertex v : run.mesh.surface().mesh().vertices(place.original.face))
      sizes.emplace_back(v, run.sizes.at(v) * std::sqrt(next / place.distance));
  }
  const double more = run.sizes.narrow(run.mesh.surface(), sizes);
  return std::size_t(std::min(more, kMostSpent * double(run.mesh.mesh().vertexCount())));
}

}  // namespace remesher
