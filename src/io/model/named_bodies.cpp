// SPDX-License-Identifier: MIT
#include "io/model/named_bodies.h"

#include <map>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "io/model/corner_weld.h"
#include "mesh/submesh.h"

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

// Some triangles of a part, with the groups that they are of.
Part bodyOf(const Part& part, TriangleMesh mesh) {
  Part body{part.name, std::move(mesh), part.instances};
  body.hidden = part.hidden;
  body.mesh.isQuads = part.mesh.isQuads;
  std::map<Index, Index> numbers;
  for (Index& group : body.mesh.groups) {
    const auto [entry, isNew] = numbers.emplace(group, Index(body.groups.size()));
    if (isNew) body.groups.push_back(group < part.groups.size() ? part.groups[group] : GroupInfo{});
    group = entry->second;
  }
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
  Submeshes bodiesOf(part.mesh);
  for (Index name = 0; name < members.size(); ++name) {
    if (triangles[name].empty()) continue;
    all.push_back(bodyOf(part, bodiesOf.of(triangles[name]).mesh));
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
