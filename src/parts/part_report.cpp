// SPDX-License-Identifier: MIT
#include "parts/part_report.h"

#include <algorithm>

#include "measure/mesh_report.h"

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

}  // namespace

MeshReport inspectParts(const std::vector<io::Part>& parts) {
  std::vector<MeshReport> reports;
  for (const io::Part& part : parts) {
    requireValid(part.mesh);
    reports.push_back(inspectMesh(part.mesh));
  }
  return combined(reports);
}

TriangleMesh gathered(const std::vector<io::Part>& parts) {
  TriangleMesh all;
  for (const io::Part& part : parts) {
    const auto first = static_cast<Index>(all.positions.size());
    const Transform place = part.instances.empty() ? Transform::Identity() : part.instances.front();
    for (const Vec3& position : part.mesh.positions) all.positions.push_back(place * position);
    for (Index i : part.mesh.indices) all.indices.push_back(first + i);
  }
  return all;
}

std::vector<Warning> joined(std::vector<Warning> all, const std::vector<Warning>& more) {
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
