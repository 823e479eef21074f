// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "laws.h"
#include "remesher.h"
#include "small_mesh.h"
#include "targets.h"

namespace remesher::fuzz {
namespace {

// Limits that keep a run well below a second under sanitizers.
constexpr std::size_t kMostTriangles = 48;
constexpr unsigned kMostAskedFor = 40;

// What adds to a mesh: groups, texture coordinates, densities, edges to be kept.
enum Extras : unsigned { kGroups = 1, kTexcoords = 2, kDensity = 4, kFeatureEdges = 8 };

void takeTarget(ByteSource& bytes, RemeshOptions& options) {
  const unsigned kind = bytes.byte(), amount = bytes.byte();
  if (kind % 8 == 0) return;
  if (kind % 8 == 1)
    options.ratio = 0.1 + amount / 128.0;
  else
    options.vertices = 4 + amount % kMostAskedFor;
}

void takeScheme(ByteSource& bytes, RemeshOptions& options) {
  constexpr std::array kFidelities = {Fidelity::Strict, Fidelity::Loose, Fidelity::Fold};
  const unsigned flags = bytes.byte(), fidelity = bytes.byte();
  if (flags & 1) options.scheme = Scheme::Rounds;
  if (flags & 2) options.quality = Quality::Draft;
  if (flags & 4) options.projection = Projection::Current;
  if (flags & 8) options.boundary = Boundary::Keep;
  if (flags & 16) options.detectFeatures = false;
  if ((flags & 96) == 96) options.splitObtuse = true;
  if (fidelity % 4 < 3) options.fidelity = kFidelities[fidelity % 4];
}

void takeNumbers(ByteSource& bytes, RemeshOptions& options) {
  const unsigned adaptivity = bytes.byte(), gradation = bytes.byte();
  const unsigned angle = bytes.byte(), error = bytes.byte();
  if (adaptivity > 0) options.adaptivity = adaptivity / 255.0;
  if (gradation > 0) options.gradation = 1 + gradation / 64.0;
  if (angle > 0) options.featureAngle = 180 * angle / 255.0;
  if (error % 4 == 3) options.maxError = std::pow(10, error / 64.0 - 2);
}

// The same for the same mesh: numbers that depend on where a vertex is in the list.
void addExtras(unsigned extras, TriangleMesh& mesh, RemeshOptions& options) {
  const std::size_t vertices = mesh.positions.size();
  if (extras & kGroups)
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) mesh.groups.push_back(t % 3 == 0);
  if (extras & kTexcoords) {
    mesh.attributes.push_back({"TEXCOORD_0", 2, {}});
    for (std::size_t v = 0; v < 2 * vertices; ++v)
      mesh.attributes.back().values.push_back(float(v * 7 % 11) / 11);
  }
  if (extras & kDensity)
    for (std::size_t v = 0; v < vertices; ++v) options.density.push_back(1 + float(v % 5));
  if (extras & kFeatureEdges && mesh.triangleCount() > 0)
    options.featureEdges.emplace_back(mesh.indices[0], mesh.indices[1]);
}

bool warnsOf(const Report& report, std::string_view code) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const Warning& warning) { return warning.code == code; });
}

void judge(const RemeshResult& result, const RemeshOptions& options) {
  const Report& report = result.report;
  requireWhole(result.mesh);
  const bool isCounted = options.vertices && !options.splitObtuse;
  require(!isCounted || report.stopped != Stopped::Target || !report.warnings.empty() ||
              report.output->vertices == *options.vertices,
          "as many vertices as asked for, or a reason");
  require(report.output->nonManifoldEdges <= report.input.nonManifoldEdges ||
              warnsOf(report, "NON_MANIFOLD_EDGES_MADE"),
          "edges of three triangles are the input's, or said");
  const bool wasClosed = report.input.boundaryEdges + report.input.nonManifoldEdges == 0;
  require(!wasClosed || report.output->boundaryEdges == 0 || warnsOf(report, "SURFACE_OPENED"),
          "what is closed stays closed, or it is said");
}

}  // namespace

void remeshSmallMesh(Input input) {
  ByteSource bytes(input);
  RemeshOptions options;
  takeTarget(bytes, options);
  takeScheme(bytes, options);
  takeNumbers(bytes, options);
  const unsigned extras = bytes.byte();
  TriangleMesh mesh = takeMesh(bytes, kMostTriangles);
  addExtras(extras, mesh, options);
  try {
    judge(remesh(mesh, options), options);
  } catch (const Error& error) {
    requireSentence(error);
  }
}

}  // namespace remesher::fuzz
