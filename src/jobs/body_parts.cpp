// SPDX-License-Identifier: MIT
#include "jobs/body_parts.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "geometry/mesh_triangle.h"
#include "geometry/triangle_tree.h"
#include "io/model/appending.h"
#include "jobs/part_run.h"
#include "jobs/parts/part_places.h"
#include "mesh/attribute_mix.h"

namespace remesher {

namespace {

bool isOfTextures(const Attribute& attribute) {
  return attribute.semantic.find("TEXCOORD") != std::string::npos ||
         attribute.semantic.find("TANGENT") != std::string::npos;
}

TriangleMesh withoutTextures(TriangleMesh mesh) {
  std::erase_if(mesh.attributes, isOfTextures);
  return mesh;
}

// The given surface by its groups, where points of the new one are looked up.
class GivenSurface {
 public:
  explicit GivenSurface(const TriangleMesh& mesh) : mesh_(mesh), mix_(mesh) {
    std::map<Index, std::vector<Index>> ofGroup;
    for (Index t = 0; t < mesh.triangleCount(); ++t)
      ofGroup[mesh.groups.empty() ? 0 : mesh.groups[t]].push_back(t);
    for (auto& [group, triangles] : ofGroup) {
      std::vector<Index> indices;
      for (const Index t : triangles)
        for (std::size_t k = 0; k < 3; ++k) indices.push_back(mesh.indices[3 * std::size_t{t} + k]);
      groups_[group] = {std::move(triangles),
                        std::make_unique<ListedTree>(mesh.positions, std::move(indices),
                                                     TriangleTree::Listed::Anyhow)};
    }
  }

  // Appends the attributes of corner k. Beside an edge the triangle counts that lies a little
  // inside, so that it is on the same side.
  void append(const Triangle& at, std::size_t k, Index group,
              std::vector<Attribute>& attributes) const {
    constexpr double kInwards = 1e-3, kAlike = 0.999;
    const Vec3 centre = (at[0] + at[1] + at[2]) / 3;
    const Group& own = groups_.at(group);
    const auto nearest = [&](const Vec3& p) {
      return own.triangles[own.tree->tree.nearest(p).triangle];
    };
    Index found = nearest(at[k]);
    const Index inside = nearest(at[k] + kInwards * (centre - at[k]));
    if (normalOf(found).dot(normalOf(inside)) < kAlike) found = inside;
    const Index* const v = &mesh_.indices[3 * std::size_t{found}];
    const auto [a, b, c] = cornersOf(mesh_, found);
    mix_.append({{v[0], v[1], v[2]}, closestBarycentric(at[k], a, b, c), areaVector(a, b, c)},
                attributes);
  }

 private:
  struct Group {
    std::vector<Index> triangles;
    std::unique_ptr<ListedTree> tree;
  };

  Vec3 normalOf(Index t) const {
    const auto [a, b, c] = cornersOf(mesh_, t);
    return unitNormal(a, b, c);
  }

  const TriangleMesh& mesh_;
  const AttributeMix mix_;
  std::map<Index, Group> groups_;
};

class BodyMaking {
 public:
  BodyMaking(const io::Part& part, const std::vector<Vec3>& positions)
      : given_(withoutTextures(part.mesh)),
        positions_(positions),
        fromWorld_(firstPlace(part).inverse()),
        isWhereItIs_(firstPlace(part).isApprox(Transform::Identity(), 0.0)) {
    if (!given_.attributes.empty()) surface_ = std::make_unique<GivenSurface>(given_);
    for (const Attribute& attribute : given_.attributes)
      made_.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
    made_.isSingle = given_.isSingle;
  }

  TriangleMesh run(const std::vector<OwnTriangle>& triangles) {
    const bool isMirrored = fromWorld_.linear().determinant() < 0;
    for (OwnTriangle t : triangles) {
      if (isMirrored) std::swap(t.corners[1], t.corners[2]);
      Triangle at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = placeOfVertex(t.corners[k]);
      for (std::size_t k = 0; k < 3; ++k) addCorner(t, at, k);
      if (!given_.groups.empty()) made_.groups.push_back(t.group);
    }
    return std::move(made_);
  }

 private:
  Vec3 placeOfVertex(Index v) const {
    return isWhereItIs_ ? positions_[v] : Vec3(fromWorld_ * positions_[v]);
  }

  void addCorner(const OwnTriangle& t, const Triangle& at, std::size_t k) {
    const auto added = Index(made_.positions.size());
    made_.positions.push_back(at[k]);
    if (surface_) surface_->append(at, k, t.group, made_.attributes);
    std::vector<Index>& copies = copies_[t.corners[k]];
    for (const Index copy : copies) {
      if (!haveSameAttributes(made_, copy, added)) continue;
      dropLastVertex(made_);
      made_.indices.push_back(copy);
      return;
    }
    copies.push_back(added);
    made_.indices.push_back(added);
  }

  const TriangleMesh given_;
  const std::vector<Vec3>& positions_;
  const Transform fromWorld_;
  const bool isWhereItIs_;
  std::unique_ptr<GivenSurface> surface_;
  TriangleMesh made_;
  std::map<Index, std::vector<Index>> copies_;  // per vertex of the complex
};

}  // namespace

TriangleMesh bodyIn(const io::Part& part, const std::vector<OwnTriangle>& triangles,
                    const std::vector<Vec3>& positions) {
  return BodyMaking(part, positions).run(triangles);
}

bool losesAttributes(const TriangleMesh& mesh) {
  return std::any_of(mesh.attributes.begin(), mesh.attributes.end(), isOfTextures);
}

io::Part withBodies(const io::Part& part, const std::vector<TriangleMesh>& bodies) {
  io::Part made = withoutMesh(part);
  made.mesh.isSingle = part.mesh.isSingle;
  made.mesh.frame = part.mesh.frame;
  made.mesh.steps = part.mesh.steps;
  for (const TriangleMesh& body : bodies) {
    made.mesh.groups.insert(made.mesh.groups.end(), body.groups.begin(), body.groups.end());
    appendMesh(made.mesh, body);
  }
  return made;
}

}  // namespace remesher
