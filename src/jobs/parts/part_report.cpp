// SPDX-License-Identifier: MIT
#include "jobs/parts/part_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/triangle.h"
#include "io/model/bake.h"
#include "measure/mesh_report.h"
#include "measure/quad_report.h"
#include "mesh/joining.h"

namespace remesher {
namespace {

double interiorVertices(const MeshReport& part) {
  return std::max(0.0, double(part.vertices) - double(part.boundaryEdges));
}

void addWeighted(AngleStatistics& sum, const AngleStatistics& part, double weight) {
  sum.worst = std::min(sum.worst, part.worst);
  sum.mean += weight * part.mean;
  for (std::size_t i = 0; i < sum.histogram.size(); ++i)
    sum.histogram[i] += weight * part.histogram[i];
}

MeshReport combined(const std::vector<MeshReport>& parts) {
  if (parts.size() == 1) return parts.front();
  MeshReport sum;
  double interior = 0;
  for (const MeshReport& part : parts) {
    sum.vertices += part.vertices;
    sum.triangles += part.triangles;
    sum.components += part.components;
    sum.boundaryEdges += part.boundaryEdges;
    sum.nonManifoldEdges += part.nonManifoldEdges;
    sum.eulerCharacteristic += part.eulerCharacteristic;
    sum.degenerateTriangles += part.degenerateTriangles;
    sum.maxAngle = std::max(sum.maxAngle, part.maxAngle);
    interior += interiorVertices(part);
  }
  sum.minAngle.worst = parts.empty() ? 0 : parts.front().minAngle.worst;
  for (const MeshReport& part : parts) {
    if (sum.triangles > 0)
      addWeighted(sum.minAngle, part.minAngle, double(part.triangles) / double(sum.triangles));
    if (interior > 0) sum.valence6 += part.valence6 * interiorVertices(part) / interior;
  }
  return sum;
}

// The figures of quads, if all parts are of quads.
std::optional<QuadReport> reportQuads(const std::vector<io::Part>& parts,
                                      const std::vector<Welding>& weldings) {
  QuadStatistics quads;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].mesh.isQuads) return {};
    quads.add(parts[i].mesh, weldings[i]);
  }
  if (parts.empty()) return {};
  return quads.report();
}

// A triangle with two coincident corners is a line, which the remesher ignores.
bool isLine(const TriangleMesh& mesh, std::size_t first) {
  const Index* const t = &mesh.indices[first];
  return hasTwins(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
}

bool hasOnlyLines(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    if (isLine(mesh, i)) return true;
  return false;
}

// If all triangles are lines, they stay.
void removeLines(TriangleMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (isLine(mesh, i)) continue;
    for (std::size_t k = 0; k < 3; ++k) mesh.indices[kept++] = mesh.indices[i + k];
  }
  if (kept > 0) mesh.indices.resize(kept);
}

// Whether a part keeps a shape at its place: it has none if it is shown as a line, flat, or nearly
// so.
bool keepsShape(const Transform& place) {
  constexpr double kLost = 1e-3;  // mean stretch, relative to the greatest
  return std::cbrt(std::abs(place.linear().determinant())) >= kLost * place.linear().norm();
}

// A part that is shown without a shape is measured in its own space.
Transform placeFor(const PartPlace& place) {
  return keepsShape(place.toWorld) ? Transform(place.toWorld) : Transform::Identity();
}

}  // namespace

std::vector<io::Part> asHeld(const std::vector<io::Part>& parts, Held held) {
  if (held == Held::Apart || parts.size() < 2) return parts;
  return {io::Part{"", io::mergeParts(parts), {Transform::Identity()}}};
}

std::vector<Welding> weldingsOf(const std::vector<io::Part>& parts) {
  std::vector<Welding> weldings;
  for (const io::Part& part : parts) {
    requireValid(part.mesh);
    weldings.emplace_back(part.mesh);
  }
  return weldings;
}

MeshReport inspectParts(const std::vector<io::Part>& parts, const std::vector<Welding>& weldings,
                        const std::vector<PartPlace>& places) {
  std::vector<MeshReport> reports;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].finer.empty()) continue;
    const auto stretch = stretchAt(places[i].toWorld);
    reports.push_back(stretch ? inspectMesh(stretched(parts[i].mesh, *stretch), weldings[i])
                              : inspectMesh(parts[i].mesh, weldings[i]));
  }
  MeshReport report = combined(reports);
  report.quads = reportQuads(parts, weldings);
  return report;
}

TriangleMesh gathered(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places) {
  TriangleMesh all;
  if (parts.empty()) return all;
  // A scene may lie so far from the origin that rounding would lose its shape.
  const Vec3 origin = placeFor(places.front()).translation();
  for (std::size_t n = 0; n < parts.size(); ++n) {
    if (!parts[n].finer.empty()) continue;
    const TriangleMesh& mesh = parts[n].mesh;
    const auto first = static_cast<Index>(all.positions.size());
    Transform place = placeFor(places[n]);
    place.translation() -= origin;
    const std::vector<Vec3>& own = mesh.positions;
    all.positions.insert(all.positions.end(), own.begin(), own.end());
    if (!place.matrix().isIdentity(0))
      for (std::size_t i = first; i < all.positions.size(); ++i)
        all.positions[i] = place * all.positions[i];
    all.indices.reserve(all.indices.size() + mesh.indices.size());
    for (const Index i : mesh.indices) all.indices.push_back(first + i);
  }
  removeLines(all);
  return all;
}

namespace {

FidelityReport fidelityThere(const PartPairs& parts, Maximum maximum,
                             std::optional<ListedTree> tree) {
  const auto& [originals, results, places] = parts;
  const io::Part& first = originals.front();
  const TriangleMesh made = gathered(results, places);
  const bool isByItself = originals.size() == 1 && placeFor(places.front()).linear().isIdentity(0);
  if (isByItself && (tree || !hasOnlyLines(first.mesh)))
    return measureFidelity(first.mesh, made, maximum, std::move(tree));
  return measureFidelity(gathered(originals, places), made, maximum);
}

}  // namespace

FidelityReport fidelityOf(const PartPairs& parts, Maximum maximum, std::optional<ListedTree> tree) {
  const auto& [originals, results, places] = parts;
  FidelityReport most = fidelityThere(parts, maximum, std::move(tree));
  std::optional<double> whole;
  for (std::size_t i = 0; i < originals.size(); ++i) {
    if (!(places[i].elsewhere > 1) || !originals[i].finer.empty()) continue;
    const std::vector<io::Part> original = {originals[i]}, result = {results[i]};
    const std::vector<PartPlace> place = {places[i]};
    const FidelityReport own = fidelityThere({original, result, place}, maximum, {});
    if (!whole) whole = diagonalOf(gathered(originals, places));
    const double share = *whole > 0 ? diagonalOf(gathered(original, place)) / *whole : 1;
    most.hausdorff = std::max(most.hausdorff, own.hausdorff * places[i].elsewhere * share);
    most.rms = std::max(most.rms, own.rms * places[i].elsewhere * share);
  }
  return most;
}

std::vector<Warning> mergedByCode(std::vector<Warning> all, const std::vector<Warning>& more) {
  for (const Warning& warning : more) {
    const auto same = std::find_if(all.begin(), all.end(),
                                   [&](const Warning& w) { return w.code == warning.code; });
    if (same == all.end())
      all.push_back(warning);
    else
      same->count += warning.count;
  }
  return all;
}

}  // namespace remesher
