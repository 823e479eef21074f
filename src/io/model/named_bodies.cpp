// SPDX-License-Identifier: MIT
#include "io/model/named_bodies.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "io/model/corner_weld.h"

namespace remesher::io {
namespace {

// The names of a part's groups, and the sets of names whose bodies hang together.
struct Bodies {
  std::vector<std::string> names;
  std::vector<Index> ofGroup;  // per group: the number of its name
  DisjointSets sets{0};
  std::size_t count = 0;  // of the sets
};

Bodies bodiesIn(const Part& part, const std::vector<std::string>& names) {
  Bodies bodies;
  std::map<std::string, Index> numbers;
  for (const std::string& name : names) {
    const auto [entry, isNew] = numbers.emplace(name, Index(bodies.names.size()));
    if (isNew) bodies.names.push_back(name);
    bodies.ofGroup.push_back(entry->second);
  }
  bodies.sets = DisjointSets(bodies.names.size());
  bodies.count = bodies.names.size();
  if (bodies.count < 2) return bodies;
  const TriangleMesh& mesh = part.mesh;
  CornerWeld weld;
  std::vector<Index> places;
  for (const Vec3& position : mesh.positions) places.push_back(weld.vertexAt(position));
  std::vector<Index> owners(places.size(), kNone);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const Index name = bodies.ofGroup[mesh.groups[i / 3]];
    Index& owner = owners[places[mesh.indices[i]]];
    if (owner == kNone) owner = name;
    bodies.count -= bodies.sets.unite(owner, name) ? 1 : 0;
  }
  return bodies;
}

// Takes bodies out of a part, each in a time of its own size: a file may have thousands.
class Taking {
 public:
  explicit Taking(const Part& part) : part_(part), numbers_(part.mesh.positions.size(), kNone) {}
  Part bodyOf(const std::vector<Index>& triangles);

 private:
  void takeVertices(TriangleMesh& mesh, std::vector<Index>& vertices);

  const Part& part_;
  std::vector<Index> numbers_;  // per vertex: in the body that is taken
};

// Gives the body its vertices, and its indices the numbers of these.
void Taking::takeVertices(TriangleMesh& mesh, std::vector<Index>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const Index v : vertices) {
    numbers_[v] = Index(mesh.positions.size());
    mesh.positions.push_back(part_.mesh.positions[v]);
  }
  for (Index& v : mesh.indices) v = numbers_[v];
  for (const Attribute& attribute : part_.mesh.attributes) {
    mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
    for (const Index v : vertices) {
      const auto at = attribute.values.begin() + std::ptrdiff_t(v) * attribute.itemSize;
      std::copy_n(at, attribute.itemSize, std::back_inserter(mesh.attributes.back().values));
    }
  }
}

Part Taking::bodyOf(const std::vector<Index>& triangles) {
  Part body{part_.name, {}, part_.instances};
  body.hidden = part_.hidden;
  TriangleMesh& mesh = body.mesh;
  mesh.isSingle = part_.mesh.isSingle, mesh.frame = part_.mesh.frame;
  mesh.steps = part_.mesh.steps, mesh.isQuads = part_.mesh.isQuads;
  std::map<Index, Index> groups;
  for (const Index t : triangles) {
    const auto corners = part_.mesh.indices.begin() + std::ptrdiff_t{3} * t;
    mesh.indices.insert(mesh.indices.end(), corners, corners + 3);
    const Index group = part_.mesh.groups[t];
    const auto [entry, isNew] = groups.emplace(group, Index(body.groups.size()));
    if (isNew)
      body.groups.push_back(group < part_.groups.size() ? part_.groups[group] : GroupInfo{});
    mesh.groups.push_back(entry->second);
  }
  std::vector<Index> vertices = mesh.indices;
  takeVertices(mesh, vertices);
  return body;
}

void appendBodies(std::vector<Part>& all, Part part, const std::vector<std::string>& names) {
  const bool isDivided = part.lods.empty() && part.finer.empty() && !part.mesh.groups.empty() &&
                         groupCount(part.mesh) <= names.size();
  Bodies bodies = isDivided ? bodiesIn(part, names) : Bodies{};
  if (bodies.count < 2) {
    if (bodies.names.size() == 1 && !bodies.names[0].empty()) part.name = bodies.names[0];
    all.push_back(std::move(part));
    return;
  }
  std::vector<std::vector<Index>> triangles(bodies.names.size());
  for (Index t = 0; t < part.mesh.triangleCount(); ++t)
    triangles[bodies.sets.find(bodies.ofGroup[part.mesh.groups[t]])].push_back(t);
  std::vector<Index> members(bodies.names.size(), 0);
  for (Index name = 0; name < members.size(); ++name) ++members[bodies.sets.find(name)];
  Taking taking(part);
  for (Index name = 0; name < members.size(); ++name) {
    if (triangles[name].empty()) continue;
    all.push_back(taking.bodyOf(triangles[name]));
    if (members[name] == 1 && !bodies.names[name].empty()) all.back().name = bodies.names[name];
  }
}

}  // namespace

std::vector<Part> namedBodies(std::vector<Part> parts, const std::vector<std::string>& names) {
  std::vector<Part> all;
  for (Part& part : parts) appendBodies(all, std::exchange(part, {}), names);
  return all;
}

}  // namespace remesher::io
