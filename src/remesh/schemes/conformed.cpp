// SPDX-License-Identifier: MIT
#include "remesh/schemes/conformed.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "mesh/attribute_mix.h"
#include "remesh/conforming/conforming.h"
#include "remesh/schemes/shape_comparison.h"
#include "remesh/transfer/attribute_transfer.h"

namespace remesher {

namespace {

// Each corner takes its attributes from the triangle of the original below it, in its own facet.
// Corners at one vertex with the same attributes are one.
class ConformedExtraction {
 public:
  ConformedExtraction(const FacetedMesh& mesh, const OriginalSurface& surface,
                      const TriangleMesh& input)
      : mesh_(mesh),
        surface_(surface),
        input_(input),
        mix_(input),
        copies_(mesh.mesh().vertexCapacity()) {
    for (const Attribute& attribute : input.attributes)
      result_.mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  }

  Followed run() {
    const HalfedgeMesh& m = mesh_.mesh();
    for (Index f = 0; f < m.faceCapacity(); ++f) {
      if (!m.isAlive(Face(f))) continue;
      SurfacePoint last;
      for (const Vertex v : m.vertices(Face(f))) {
        last = mesh_.pointIn(v, mesh_.facet(Face(f)));
        addCorner(v, last);
      }
      if (!input_.groups.empty())
        result_.mesh.groups.push_back(input_.groups[surface_.built().triangles[last.face]]);
    }
    return std::move(result_);
  }

 private:
  void addCorner(Vertex v, const SurfacePoint& point) {
    TriangleMesh& mesh = result_.mesh;
    result_.places.push_back(inputPlace(point, surface_.built(), input_));
    const auto added = Index(mesh.positions.size());
    mesh.positions.push_back(mesh_.positions()[v]);
    if (!mesh.attributes.empty()) mix_.append(mixPoint(surface_, point, mix_), mesh.attributes);
    for (const Index copy : copies_[v]) {
      if (!haveSameAttributes(mesh, copy, added)) continue;
      dropLastVertex(mesh);
      mesh.indices.push_back(copy);
      return;
    }
    copies_[v].push_back(added);
    mesh.indices.push_back(added);
  }

  const FacetedMesh& mesh_;
  const OriginalSurface& surface_;
  const TriangleMesh& input_;
  AttributeMix mix_;
  VertexData<std::vector<Index>> copies_;  // of the result
  Followed result_;
};

// Whether textures or colours are on the surface: within a plane they may bend at edges that would
// not stay.
bool isDrawnOn(const TriangleMesh& input) {
  return std::any_of(input.attributes.begin(), input.attributes.end(), [](const Attribute& a) {
    return !a.semantic.ends_with("NORMAL") && !a.semantic.ends_with("TANGENT");
  });
}

}  // namespace

std::optional<Followed> conformed(const BuiltMesh& original, const TriangleMesh& input,
                                  std::size_t positions, Textures textures,
                                  const FacetLimits& limits) {
  if (isDrawnOn(input)) return {};
  const HalfedgeData<char> seams = seamsOf(original, input, textures);
  const std::unique_ptr<FacetedMesh> mesh = makeConforming(original, seams, positions, limits);
  if (!mesh) return {};
  const OriginalSurface surface(original, mesh->curves());
  Followed result = ConformedExtraction(*mesh, surface, input).run();
  if (hasDegenerate(result.mesh)) return {};
  result.away = awayFrom({mesh->mesh(), mesh->positions()}, original.mesh, original.positions);
  return result;
}

std::size_t fewestConformed(const TriangleMesh& input) {
  if (isDrawnOn(input)) return 0;
  const BuiltMesh built = buildMesh(input);
  return isFaceted(built) ? fewestConforming(built, seamsOf(built, input, Textures::Keep)) : 0;
}

}  // namespace remesher
