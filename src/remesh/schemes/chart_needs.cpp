// SPDX-License-Identifier: MIT
#include "remesh/schemes/chart_needs.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/components.h"
#include "mesh/mesh_builder.h"
#include "original/curves/curve_simplification.h"
#include "original/surface/size_field.h"
#include "remesh/schemes/curve_choice.h"

namespace remesher {

namespace {

// Two charts are on the same place of a texture if they share this much of the smaller one's range
// in every direction.
constexpr float kSamePlace = 0.5F;

// Only charts of textures and of colours are seen, not those of shading and skins.
bool isSeen(const Attribute& attribute, const Seams& seams) {
  const std::vector<std::string>& without = seams.chartless;
  return (attribute.semantic.rfind("TEXCOORD_", 0) == 0 ||
          attribute.semantic.rfind("COLOR_", 0) == 0) &&
         std::find(without.begin(), without.end(), attribute.semantic) == without.end();
}

struct Range {
  float least, most;
};

struct Region {
  double area = 0;
  double rim = 0;             // length of its border
  Border shown;               // the part with something else on the other side
  std::vector<Range> values;  // of all components of the seen attributes
};

bool overlap(const Range& a, const Range& b) {
  const float shared = std::min(a.most, b.most) - std::max(a.least, b.least);
  return shared >= kSamePlace * std::min(a.most - a.least, b.most - b.least);
}

class Measurement {
 public:
  Measurement(const BuiltMesh& built, const TriangleMesh& input, const CurveCandidates& candidates)
      : mesh_(built.mesh),
        built_(built),
        isCurve_(mesh_.halfedgeCapacity(), 0),
        curvesAt_(mesh_.vertexCapacity(), 0),
        region_(mesh_.faceCapacity(), kNone) {
    for (const Halfedge h : candidates.edges.free) mark(h);
    for (const Halfedge h : candidates.edges.fixed) mark(h);
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (mesh_.isBoundary(Halfedge(i))) mark(Halfedge(i));
    for (const Attribute& attribute : input.attributes)
      if (isSeen(attribute, candidates.seams)) seen_.push_back(&attribute);
    numberRegions();
    for (Index f = 0; f < mesh_.faceCapacity(); ++f) addFace(Face(f));
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
      if (!isInside(Halfedge(i))) addBorder(Halfedge(i));
  }

  std::vector<ChartNeed> needs() const {
    std::vector<ChartNeed> result;
    for (const Region& region : regions_) {
      if (region.shown.length <= 0) continue;
      const double width = 2 * region.area / region.rim;
      result.push_back(need(width, width / narrowestWidth(1, region.shown.meanBend())));
    }
    for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
      const Border chain = chainFrom(Halfedge(i));
      if (chain.length > 0)
        result.push_back(need(chain.length, chain.length / shortestChain(1, chain.meanBend())));
    }
    return result;
  }

 private:
  void mark(Halfedge h) {
    if (isCurve_[h]) return;
    isCurve_[h] = 1;
    if (!mesh_.isBoundary(h)) isCurve_[mesh_.twin(h)] = 1;
    ++curvesAt_[mesh_.origin(h)];
    ++curvesAt_[mesh_.tip(h)];
  }

  void numberRegions() {
    FaceRegions regions = regionsOf(mesh_, [&](Halfedge h) { return isInside(h); });
    region_ = std::move(regions.of);
    regions_.resize(regions.count);
  }

  bool isInside(Halfedge h) const { return !isCurve_[h]; }

  // size: the longest edges that keep the chart.
  ChartNeed need(double width, double size) const {
    return {width, verticesForEdgeLength(area_, size)};
  }

  Index region(Halfedge h) const { return region_[mesh_.face(h)]; }

  // The border that begins at this junction; its length is 0 if none begins here, or if the same is
  // shown beyond it.
  Border chainFrom(Halfedge first) const {
    if (isInside(first) || curvesAt_[mesh_.origin(first)] == 2) return {};
    if (mesh_.isBoundary(first) || region(first) == region(mesh_.twin(first)) ||
        !showsAnother(regions_[region(first)], regions_[region(mesh_.twin(first))]))
      return {};
    Border sum;
    for (Halfedge h = first; h;) {
      sum.add(border(h));
      const Vertex end = mesh_.tip(h);
      Halfedge next;
      if (curvesAt_[end] == 2)
        mesh_.forEachOutgoing(end, [&](Halfedge out) {
          if (isCurve_[out] && out != mesh_.twin(h)) next = out;
        });
      h = next;
    }
    return sum;
  }

  double length(Halfedge h) const {
    return (built_.positions[mesh_.tip(h)] - built_.positions[mesh_.origin(h)]).norm();
  }

  Border border(Halfedge h) const { return borderAlong(mesh_, built_.positions, h); }

  void addFace(Face f) {
    Region& mine = regions_[region_[f]];
    const auto [a, b, c] = mesh_.vertices(f);
    const double own = area(built_.positions[a], built_.positions[b], built_.positions[c]);
    mine.area += own;
    area_ += own;
    for (int corner = 0; corner < 3; ++corner)
      addValues(mine.values, built_.wedges[HalfedgeMesh::halfedge(f, corner)]);
  }

  void addValues(std::vector<Range>& ranges, Index wedge) const {
    const bool isFirst = ranges.empty();
    std::size_t at = 0;
    for (const Attribute* attribute : seen_)
      for (int k = 0; k < attribute->itemSize; ++k, ++at) {
        const float value = attribute->values[std::size_t{wedge} * attribute->itemSize + k];
        if (isFirst) ranges.push_back({value, value});
        ranges[at] = {std::min(ranges[at].least, value), std::max(ranges[at].most, value)};
      }
  }

  static bool showsAnother(const Region& a, const Region& b) {
    return !std::equal(a.values.begin(), a.values.end(), b.values.begin(), overlap);
  }

  void addBorder(Halfedge h) {
    const Halfedge twin = mesh_.twin(h);
    const bool isEnd = mesh_.isBoundary(h);
    if (!isEnd && region(h) == region(twin)) return;
    Region& own = regions_[region(h)];
    own.rim += length(h);
    if (isEnd || !showsAnother(own, regions_[region(twin)])) return;
    own.shown.add(border(h));
  }

  const HalfedgeMesh& mesh_;
  const BuiltMesh& built_;
  HalfedgeData<char> isCurve_;
  VertexData<int> curvesAt_;
  FaceData<Index> region_;
  double area_ = 0;
  std::vector<Region> regions_;
  std::vector<const Attribute*> seen_;
};

}  // namespace

std::vector<ChartNeed> chartNeeds(const TriangleMesh& input, const PartOptions& options) {
  constexpr double kEverySize = 0;
  if (input.attributes.empty()) return {};
  const BuiltMesh built = buildMesh(input);
  const CurveCandidates candidates = curveCandidates(built, input, options, kEverySize);
  if (candidates.seams.jumps.empty()) return {};
  return Measurement(built, input, candidates).needs();
}

}  // namespace remesher
