// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/holes.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "base/disjoint_sets.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

namespace {

// A hole with more sides is no slip of the map.
constexpr std::size_t kLongestLoop = 64;

// Quads that are unsound by themselves or beside others.
std::vector<char> unsoundQuads(const QuadMesh& mesh) {
  std::vector<char> isBad(mesh.quads.size(), 0);
  std::map<std::pair<Index, Index>, Index> owner;
  for (Index q = 0; q < mesh.quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = mesh.quads[q][i], b = mesh.quads[q][(i + 1) % 4];
      if (a == b || a == mesh.quads[q][(i + 2) % 4]) isBad[q] = 1;
      const auto [known, isNew] = owner.try_emplace({a, b}, q);
      if (!isNew) isBad[q] = isBad[known->second] = 1;
    }
  return isBad;
}

// The sides that leave v, fan by fan, each counterclockwise from its boundary, if it has one.
std::vector<std::vector<Index>> fansOf(const QuadSides& sides, const std::vector<Index>& out) {
  std::set<Index> left(out.begin(), out.end());
  std::vector<std::vector<Index>> fans;
  while (!left.empty()) {
    Index first = *left.begin();
    for (Index back = sides.across(first); back != kNone && nextSide(back) != *left.begin();
         back = sides.across(first))
      first = nextSide(back);
    std::vector<Index> fan;
    for (Index side = first; side != kNone && left.erase(side) > 0;
         side = sides.across(prevSide(side)))
      fan.push_back(side);
    fans.push_back(std::move(fan));
  }
  return fans;
}

// Marks the quads to drop: at each vertex with several fans all but the first of the largest.
std::vector<char> lesserFans(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  std::vector<std::vector<Index>> leaving(mesh.vertices.size());
  for (Index side = 0; side < sides.size(); ++side) leaving[sides.origin(side)].push_back(side);
  std::vector<char> isGone(mesh.quads.size(), 0);
  for (const std::vector<Index>& out : leaving) {
    const std::vector<std::vector<Index>> fans = fansOf(sides, out);
    const auto isShorter = [](const auto& a, const auto& b) { return a.size() < b.size(); };
    const auto largest = std::max_element(fans.begin(), fans.end(), isShorter);
    for (auto fan = fans.begin(); fan != fans.end(); ++fan)
      if (fan != largest)
        for (const Index side : *fan) isGone[side / 4] = 1;
  }
  return isGone;
}

bool hasAny(const std::vector<char>& marks) {
  return std::find(marks.begin(), marks.end(), 1) != marks.end();
}

// How a hole is divided: into a grid, or into sectors around a middle.
struct Division {
  std::vector<std::size_t> spans;  // of a grid two; else one per sector, its part of the side
  std::size_t first = 0;           // the place of its first corner on the loop
  int cost = 0;
  bool isGrid() const { return spans.size() == 2; }
};

// The places of the corners on the loop, from the first corner on.
std::vector<std::size_t> cornersOf(const std::vector<std::size_t>& spans) {
  if (spans.size() == 2) return {0, spans[0], spans[0] + spans[1], 2 * spans[0] + spans[1]};
  std::vector<std::size_t> corners;
  std::size_t at = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    corners.push_back(at);
    at += spans[i] + spans[(i + 2) % spans.size()];
  }
  return corners;
}

class Filling {
 public:
  Filling(QuadMesh& mesh, const WorkingMesh& ground, std::vector<Index> loop)
      : mesh_(mesh), ground_(ground), loop_(std::move(loop)) {}

  // quadsAround: for each vertex of the loop.
  void run(const std::vector<int>& quadsAround) {
    const Division division = bestDivision(quadsAround);
    firstQuad_ = mesh_.quads.size();
    firstVertex_ = Index(mesh_.vertices.size());
    std::rotate(loop_.begin(), loop_.begin() + std::ptrdiff_t(division.first), loop_.end());
    if (division.isGrid())
      makeGrid(division.spans[0], division.spans[1]);
    else
      makeSectors(division.spans);
    place();
  }

 private:
  // Of all divisions, the one with the fewest irregular vertices, then with the most even parts.
  Division bestDivision(const std::vector<int>& quadsAround) const {
    const std::size_t half = loop_.size() / 2;
    Division best;
    best.cost = std::numeric_limits<int>::max();
    const auto consider = [&](const std::vector<std::size_t>& spans) {
      const auto [low, high] = std::minmax_element(spans.begin(), spans.end());
      const int uneven = int(*high - *low);
      const std::vector<std::size_t> corners = cornersOf(spans);
      for (std::size_t first = 0; first < loop_.size(); ++first) {
        int cost = spans.size() == 2 ? 0 : 1;
        for (const std::size_t corner : corners) {
          const int around = quadsAround[(first + corner) % loop_.size()];
          cost += std::abs(around + 1 - 4) - std::abs(around + 2 - 4);
        }
        cost = cost * int(kLongestLoop) + uneven;
        if (cost < best.cost) best = {spans, first, cost};
      }
    };
    for (std::size_t a = 1; a < half; ++a) consider({a, half - a});
    for (std::size_t a = 1; a + 1 < half; ++a)
      for (std::size_t b = 1; a + b < half; ++b) {
        consider({a, b, half - a - b});
        const std::size_t rest =
            half - a - b;  // of five sectors: three share it as evenly as can be
        if (rest >= 3) consider({a, b, rest / 3, (rest + 1) / 3, (rest + 2) / 3});
      }
    return best;
  }

  Index newVertex() {
    mesh_.vertices.push_back(mesh_.vertices[loop_.front()]);
    return Index(mesh_.vertices.size() - 1);
  }

  void addQuad(Index a, Index b, Index c, Index d) {
    mesh_.quads.push_back({a, b, c, d});
    mesh_.curves.push_back({kNone, kNone, kNone, kNone});
  }

  void makeGrid(std::size_t a, std::size_t b) {
    const std::size_t n = loop_.size();
    std::map<std::pair<std::size_t, std::size_t>, Index> inside;
    const auto at = [&](std::size_t i, std::size_t k) {
      if (k == 0) return loop_[i];
      if (i == a) return loop_[a + k];
      if (k == b) return loop_[a + b + (a - i)];
      if (i == 0) return loop_[n - k];
      const auto known = inside.find({i, k});
      return known != inside.end() ? known->second : inside[{i, k}] = newVertex();
    };
    for (std::size_t i = 0; i < a; ++i)
      for (std::size_t k = 0; k < b; ++k)
        addQuad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
  }

  // Sector i reaches from its corner along its side by spans[i], and back along the side before by
  // spans[i + 1]. From its ends on both sides spokes lead to the middle.
  void makeSectors(const std::vector<std::size_t>& spans) {
    const std::size_t n = loop_.size(), count = spans.size();
    const std::vector<std::size_t> corners = cornersOf(spans);
    const Index middle = newVertex();
    std::map<std::pair<std::size_t, std::size_t>, Index> spokes;
    for (std::size_t sector = 0; sector < count; ++sector) {
      const std::size_t wide = spans[sector], high = spans[(sector + 1) % count];
      std::map<std::pair<std::size_t, std::size_t>, Index> inside;
      const auto made = [&](auto& known, std::size_t i, std::size_t k) {
        const auto found = known.find({i, k});
        return found != known.end() ? found->second : known[{i, k}] = newVertex();
      };
      const auto at = [&](std::size_t i, std::size_t k) {
        if (k == 0) return loop_[(corners[sector] + i) % n];
        if (i == 0) return loop_[(corners[sector] + n - k) % n];
        if (i == wide && k == high) return middle;
        if (i == wide) return made(spokes, sector, k);
        if (k == high) return made(spokes, (sector + count - 1) % count, i);
        return made(inside, i, k);
      };
      for (std::size_t i = 0; i < wide; ++i)
        for (std::size_t k = 0; k < high; ++k)
          addQuad(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    }
  }

  // Puts new vertices between their neighbours, then on the original.
  void place() {
    const std::size_t count = mesh_.vertices.size() - firstVertex_;
    Vec3 middle = Vec3::Zero();
    for (const Index v : loop_) middle += mesh_.position(v) / double(loop_.size());
    for (std::size_t i = 0; i < count; ++i) mesh_.vertices[firstVertex_ + i].position = middle;
    std::vector<std::vector<Index>> neighbors(count);
    for (std::size_t q = firstQuad_; q < mesh_.quads.size(); ++q)
      for (std::size_t i = 0; i < 4; ++i)
        if (const Index v = mesh_.quads[q][i]; v >= firstVertex_) {
          neighbors[v - firstVertex_].push_back(mesh_.quads[q][(i + 1) % 4]);
          neighbors[v - firstVertex_].push_back(mesh_.quads[q][(i + 3) % 4]);
        }
    for (int k = 0; k < kSmoothingSweeps; ++k)
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 sum = Vec3::Zero();
        for (const Index w : neighbors[i]) sum += mesh_.position(w);
        mesh_.vertices[firstVertex_ + i].position = sum / double(neighbors[i].size());
      }
    for (std::size_t i = 0; i < count; ++i) {
      Placement& vertex = mesh_.vertices[firstVertex_ + i];
      const Vec3 p = vertex.position;
      vertex = ground_.onSurface(closestPointFrom(ground_.surface(), nearest(p).at, p));
    }
  }

  // The vertex of the loop nearest to p; those of kind Curve come last, for they have more than one
  // place on the original.
  const Placement& nearest(const Vec3& p) const {
    const auto distance = [&](Index v) {
      const bool isCurve = mesh_.vertices[v].kind == VertexKind::Curve;
      return std::pair(isCurve, (mesh_.position(v) - p).squaredNorm());
    };
    const auto isNearer = [&](Index v, Index w) { return distance(v) < distance(w); };
    return mesh_.vertices[*std::min_element(loop_.begin(), loop_.end(), isNearer)];
  }

  QuadMesh& mesh_;
  const WorkingMesh& ground_;
  std::vector<Index> loop_;
  std::size_t firstQuad_ = 0;
  Index firstVertex_ = 0;
};

// Whether a side between two vertices follows an open boundary: both are on one of its chains.
bool isOnBoundary(const QuadMesh& mesh, const WorkingMesh& ground, Index a, Index b) {
  const auto& chains = ground.surface().curves().chains();
  const auto isOn = [&](Index v) {
    const Placement& place = mesh.vertices[v];
    if (place.kind == VertexKind::Curve) return chains[place.on.chain].boundary;
    return place.kind == VertexKind::Corner &&
           ground.surface().mesh().isBoundary(ground.originalCorner(place.at));
  };
  return isOn(a) && isOn(b);
}

}  // namespace

void dropUnsound(QuadMesh& mesh) {
  for (;;) {
    std::vector<char> isGone = unsoundQuads(mesh);
    if (!hasAny(isGone)) isGone = lesserFans(mesh);
    if (!hasAny(isGone)) break;
    dropQuads(mesh, isGone);
  }
  dropUnusedVertices(mesh);
}

void keepLargestPiece(QuadMesh& mesh) {
  DisjointSets pieces(mesh.vertices.size());
  for (const auto& [a, b, c, d] : mesh.quads)
    for (const Index v : {b, c, d}) pieces.unite(a, v);
  std::vector<std::size_t> sizes(mesh.vertices.size(), 0);
  for (const Four<Index>& quad : mesh.quads) ++sizes[pieces.find(quad[0])];
  const auto largest = Index(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::vector<char> isGone;
  for (const Four<Index>& quad : mesh.quads) isGone.push_back(pieces.find(quad[0]) != largest);
  dropQuads(mesh, isGone);
  dropUnusedVertices(mesh);
}

void fillHoles(QuadMesh& mesh, const WorkingMesh& ground) {
  const std::vector<Four<Index>> quads = mesh.quads;
  const QuadSides sides(mesh.vertices.size(), quads);
  std::vector<char> seen(sides.size(), 0);
  for (Index i = 0; i < sides.size(); ++i) {
    if (sides.across(i) != kNone || seen[i]) continue;
    std::vector<Index> loop;
    std::vector<int> around;
    bool isHole = true;
    for (Index side = i; !seen[side]; side = sides.outgoing(sides.tip(side))) {
      seen[side] = 1;
      loop.push_back(sides.origin(side));
      around.push_back(sides.quadsAround(sides.origin(side)));
      isHole &= !isOnBoundary(mesh, ground, sides.origin(side), sides.tip(side));
    }
    if (!isHole || loop.size() % 2 != 0 || loop.size() > kLongestLoop) continue;
    std::reverse(loop.begin(), loop.end());
    std::reverse(around.begin(), around.end());
    Filling(mesh, ground, std::move(loop)).run(around);
  }
}

}  // namespace remesher
