// SPDX-License-Identifier: MIT
#include "repair/body_union.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/fires.h"
#include "geometry/extent.h"
#include "measure/self_intersections.h"
#include "mesh/used_vertices.h"
#include "repair/ladder.h"
#include "repair/loose_pieces.h"
#include "repair/seen_share.h"
#include "repair/touching_faces.h"
#include "repair/united.h"

namespace remesher {

namespace {

// Notes what is lost; returns whether it is too much. What is inside is not seen.
bool isSeenLost(const TriangleMesh& bodies, United& outside) {
  if (!outside.isOutsideDropped) return false;
  outside.lost = seenShareLost(bodies, outside.mesh, outside.parents);
  return 100 * outside.lost > ladder::kMostLost;
}

// Where parts that are inside out are seen, they are inside, too; none if parts are lost even so.
std::optional<United> seenUnion(const TriangleMesh& bodies, std::span<const Index> crossings) {
  std::optional<United> outside = united(bodies, crossings);
  if (!outside || !isSeenLost(bodies, *outside)) return outside;
  fires("exact repair: parts inside out are seen");
  outside = united(bodies, crossings, Inside::EitherWay);
  if (outside && isSeenLost(bodies, *outside)) outside.reset();
  return outside;
}

struct ClosedUnion {
  United outside;
  Defects defects;
};

// None if it is not closed.
std::optional<ClosedUnion> closedUnion(const TriangleMesh& bodies,
                                       std::span<const Index> crossings) {
  if (std::optional<United> outside = seenUnion(bodies, crossings))
    if (const Defects defects = defectsOf(*outside); defects.unbalanced == 0)
      return ClosedUnion{std::move(*outside), defects};
  fires("exact repair: the union is not closed");
  return std::nullopt;
}

// The union with touching faces joined, if it has fewer defects: first of those as near to each
// other as single precision brings them, then as few decimals do.
void joinTouching(const TriangleMesh& bodies, ClosedUnion& closed) {
  for (const double steps : {4.0, 32.0}) {
    if (closed.defects == Defects{}) return;
    const std::optional<JoinedFaces> joined = withFacesJoined(bodies, steps, SharedFaces::Dropped);
    if (!joined) continue;
    std::optional<ClosedUnion> other = closedUnion(joined->mesh, selfIntersections(joined->mesh));
    if (!other || other->defects >= closed.defects) continue;
    fires("exact repair: united with touching faces joined");
    for (Index& parent : other->outside.parents) parent = joined->parents[parent];
    closed = std::move(*other);
  }
}

// The union of all of them; none if that is not sound.
std::optional<United> soundUnion(const TriangleMesh& bodies, std::span<const Index> crossings,
                                 double mostLeft) {
  std::optional<ClosedUnion> closed = closedUnion(bodies, crossings);
  if (!closed) return std::nullopt;
  joinTouching(bodies, *closed);
  if (double(closed->defects.crossings) > mostLeft * double(crossings.size())) {
    fires("exact repair: the union intersects itself");
    return std::nullopt;
  }
  return std::move(closed->outside);
}

// Per triangle the group of bodies whose boxes meet, from 0 on in the order of first triangles.
std::vector<Index> groupsOf(const TriangleMesh& bodies) {
  const LoosePieces pieces(bodies.positions, bodies.indices);
  const std::vector<LoosePiece>& all = pieces.all();
  std::vector<Index> order(all.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index p, Index q) { return all[p].box.low.x() < all[q].box.low.x(); });
  DisjointSets sets(all.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Box &one = all[order[i]].box, &other = all[order[k]].box;
      if (other.low.x() > one.high.x()) break;
      if ((one.low.array() <= other.high.array()).all() &&
          (other.low.array() <= one.high.array()).all())
        sets.unite(order[i], order[k]);
    }
  std::vector<Index> numbers(all.size(), kNone), groups;
  Index count = 0;
  for (const Index piece : pieces.ofTriangles()) {
    Index& number = numbers[sets.find(piece)];
    if (number == kNone) number = count++;
    groups.push_back(number);
  }
  return groups;
}

// Collects the unions of groups of bodies.
class Collector {
 public:
  Collector(const TriangleMesh& bodies, double mostLeft) : mostLeft_(mostLeft) {
    result_.mesh = bodies;
    result_.mesh.positions.clear(), result_.mesh.indices.clear(), result_.mesh.groups.clear();
    result_.mesh.isQuads = false;
    for (Attribute& attribute : result_.mesh.attributes) attribute.values.clear();
  }

  void add(SelectedTriangles bodies, std::span<const Index> allCrossings) {
    const std::vector<Index> crossings = numbersAmong(bodies.triangles, allCrossings);
    keepUsedVertices(bodies.mesh);
    std::optional<United> outside = soundUnion(bodies.mesh, crossings, mostLeft_);
    if (!outside) {
      result_.undecided.insert(result_.undecided.end(), bodies.triangles.begin(),
                               bodies.triangles.end());
      return;
    }
    const Index before = Index(result_.mesh.triangleCount());
    for (const Index parent : outside->parents) result_.parents.push_back(bodies.triangles[parent]);
    for (const Index t : outside->crossings) result_.crossings.push_back(before + t);
    const double area = extentOf(bodies.mesh).area;
    result_.lost += outside->lost * area;
    area_ += area;
    append(result_.mesh, outside->mesh);
  }

  std::optional<BodyUnion> taken() {
    if (result_.mesh.indices.empty()) return std::nullopt;
    if (area_ > 0) result_.lost /= area_;
    std::sort(result_.undecided.begin(), result_.undecided.end());
    return std::move(result_);
  }

 private:
  const double mostLeft_;
  double area_ = 0;
  BodyUnion result_;
};

// Group by group; all groups without crossings together.
std::optional<BodyUnion> unionByGroup(const TriangleMesh& bodies, std::span<const Index> crossings,
                                      double mostLeft) {
  std::vector<Index> groups = groupsOf(bodies);
  const Index count = groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
  if (count < 2) return std::nullopt;
  fires("exact repair: united group by group");
  std::vector<std::size_t> crossed(count, 0);
  for (const Index t : crossings) ++crossed[groups[t]];
  for (Index& group : groups)
    if (crossed[group] == 0) group = count;
  Collector collector(bodies, mostLeft);
  if (SelectedTriangles clear = selected(bodies, groups, count); !clear.triangles.empty())
    collector.add(std::move(clear), {});
  for (Index group = 0; group < count; ++group)
    if (crossed[group] > 0) collector.add(selected(bodies, groups, group), crossings);
  return collector.taken();
}

}  // namespace

std::optional<BodyUnion> unionOf(const TriangleMesh& bodies, std::span<const Index> crossings,
                                 double mostLeft) {
  std::optional<United> whole = soundUnion(bodies, crossings, mostLeft);
  if (!whole) return unionByGroup(bodies, crossings, mostLeft);
  return BodyUnion{std::move(whole->mesh),
                   std::move(whole->parents),
                   std::move(whole->crossings),
                   whole->lost,
                   {}};
}

SelectedTriangles selected(const TriangleMesh& mesh, std::span<const Index> marks, Index mark) {
  SelectedTriangles part{mesh, {}};
  part.mesh.indices.clear(), part.mesh.groups.clear();
  part.mesh.isQuads = false;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (marks[t] != mark) continue;
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    part.mesh.indices.insert(part.mesh.indices.end(), v, v + 3);
    part.triangles.push_back(t);
    if (!mesh.groups.empty()) part.mesh.groups.push_back(mesh.groups[t]);
  }
  return part;
}

}  // namespace remesher
