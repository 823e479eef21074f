// SPDX-License-Identifier: MIT
#include "original/surface/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <queue>

#include "geometry/triangle.h"
#include "original/surface/accurate_sizes.h"
#include "original/surface/boundary_places.h"
#include "original/surface/boundary_sizes.h"
#include "original/surface/curvature.h"

namespace remesher {

namespace {

constexpr int kNormalizations = 3;
// A scale this near to 1 is good enough.
constexpr double kNormalEnough = 1e-3;
// Edges longer than this, in units of the mean size at their ends, do not survive a run.
constexpr double kLongestEdge = 5.0 / 3;
// Flat faces are divided into parts with edges of at most this many mean lengths.
constexpr double kFinestPart = 1.5;

// Sizes that follow curvature also follow the bends of boundaries. In coarse meshes the chord
// tolerance is this times size² / diagonal, since chords leave arcs by the square of the size.
constexpr double kChordOfSquare = 2.75;
// In mean lengths.
constexpr double kShortestChord = 0.75;

// The median by area of values that are not negative, whose bits rise with the values. Finds 16
// bits after the other.
double medianByArea(const VertexData<double>& values, const VertexData<double>& areas) {
  constexpr int kBits = 16;
  constexpr std::size_t kDigits = 1 << kBits;
  const double total = std::accumulate(areas.values().begin(), areas.values().end(), 0.0);
  double below = 0;
  std::uint64_t median = 0;
  for (int shift = 64 - kBits; shift >= 0; shift -= kBits) {
    std::vector<double> shares(kDigits, 0);
    for (Index i = 0; i < values.size(); ++i) {
      std::uint64_t bits;
      std::memcpy(&bits, &values[Vertex(i)], sizeof bits);
      if ((bits ^ median) >> shift >> kBits == 0)
        shares[std::size_t(bits >> shift) % kDigits] += areas[Vertex(i)];
    }
    std::uint64_t found = 0;
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      if (shares[digit] == 0) continue;
      found = digit;
      if (below + shares[digit] >= total / 2) break;
      below += shares[digit];
    }
    median |= found << shift;
  }
  double result;
  std::memcpy(&result, &median, sizeof result);
  return result;
}

// Multiplies sizes by a factor for curvature, 1 at the median curvature (by area).
void applyCurvature(const OriginalSurface& surface, double adaptivity,
                    const VertexData<double>& areas, VertexData<double>& sizes) {
  const VertexData<double> k = curvatures(surface);
  double median = medianByArea(k, areas);
  if (!(median > 0)) median = 1 / surface.diagonal();
  // h ∝ k^-1/4 at half adaptivity, k^-3/8 at full.
  const double strength = adaptivity * (1.25 - adaptivity / 2);
  for (Index i = 0; i < k.size(); ++i) {
    const double bend = std::max(k[Vertex(i)], 1e-6 * median) / median;
    const double full = std::clamp(1 / std::sqrt(bend), kFinest, kCoarsest);
    sizes[Vertex(i)] *= std::pow(full, strength);
  }
}

// The factor for the sizes that makes a mesh of these sizes have as many vertices as a uniform mesh
// of edge length `mean`.
double normalScale(const VertexData<double>& areas, double mean, const VertexData<double>& sizes) {
  double total = 0, weighted = 0;
  for (Index i = 0; i < sizes.size(); ++i) {
    total += areas[Vertex(i)];
    weighted += areas[Vertex(i)] / (sizes[Vertex(i)] * sizes[Vertex(i)]);
  }
  return mean * std::sqrt(weighted / total);
}

// Edges are as dense as vertices: proportional to area / size².
double meanOverEdges(const VertexData<double>& areas, const VertexData<double>& sizes) {
  double edges = 0, lengths = 0;
  for (Index i = 0; i < sizes.size(); ++i) {
    const double size = sizes[Vertex(i)], share = areas[Vertex(i)] / (size * size);
    edges += share;
    lengths += share * size;
  }
  return lengths / edges;
}

// A chord of length h leaves an arc of curvature k by k·h²/8.
VertexData<double> largestSizes(const OriginalSurface& surface, double error) {
  VertexData<double> sizes = curvatures(surface);
  for (double& k : sizes.values())
    k = std::sqrt(8 * error / std::max(k, 1e-9 / surface.diagonal()));
  return sizes;
}

double verticesOf(const VertexData<double>& areas, const VertexData<double>& sizes) {
  double count = 0;
  for (Index i = 0; i < sizes.size(); ++i)
    count += verticesForEdgeLength(areas[Vertex(i)], sizes[Vertex(i)]);
  return count;
}

// How fast sizes may change along the surface so that the ratio at the two ends of an edge stays
// below the gradation: from size a to b along c·(a + b)/2, where c is kLongestEdge.
double steepestSlope(double gradation) {
  return 2 * (gradation - 1) / (kLongestEdge * (gradation + 1));
}

// Lowers the larger size, at w, to what the size at v allows: over a length d it may grow by
// slope·d. Returns whether it was lowered. Not inlined: one copy is enough for all callers.
[[gnu::noinline]] bool limitBy(const OriginalSurface& surface, double slope,
                               const std::array<Vertex, 2>& edge, VertexData<double>& sizes) {
  const auto [v, w] = edge;
  const double most = (sizes[w] - sizes[v]) / slope;
  const double squaredWay = (surface.positions()[w] - surface.positions()[v]).squaredNorm();
  if (most * most <= squaredWay) return false;
  const double limit = sizes[v] + slope * std::sqrt(squaredWay);
  if (sizes[w] <= limit) return false;
  sizes[w] = limit;
  return true;
}

// Limits every size by the smaller sizes around it. Loops over all edges once, then in rounds over
// the vertices just lowered: limits reach a few edges only, and a queue by size would cost more
// than the few vertices that are lowered twice.
void limitGradation(const OriginalSurface& surface, double slope, VertexData<double>& sizes) {
  const HalfedgeMesh& mesh = surface.mesh();
  std::vector<Vertex> lowered, next;
  VertexData<char> waits(sizes.size(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    std::array<Vertex, 2> edge = {mesh.origin(h), mesh.tip(h)};
    if (sizes[edge[1]] < sizes[edge[0]]) std::swap(edge[0], edge[1]);
    if (limitBy(surface, slope, edge, sizes)) waits[edge[1]] = 1;
  }
  for (Index i = 0; i < sizes.size(); ++i)
    if (waits[Vertex(i)]) lowered.emplace_back(i);
  for (; !lowered.empty(); lowered.swap(next), next.clear())
    for (const Vertex v : lowered) {
      waits[v] = 0;
      mesh.forEachNeighbor(v, [&](Vertex w) {
        if (sizes[w] <= sizes[v] || !limitBy(surface, slope, {v, w}, sizes) || waits[w]) return;
        next.push_back(w);
        waits[w] = 1;
      });
    }
}

// Lengths of kept boundary edges: per vertex the mean of its two edges, 0 elsewhere; empty where
// nothing is kept.
VertexData<double> keptLengths(const OriginalSurface& surface) {
  VertexData<double> lengths;
  for (const Chain& chain : surface.curves().chains()) {
    if (!chain.kept) continue;
    if (lengths.size() == 0) lengths.assign(surface.mesh().vertexCapacity(), 0);
    for (const Vertex end : {chain.vertices.front(), chain.vertices.back()})
      lengths[end] += 0.5 * chain.length();
  }
  return lengths;
}

VertexData<double> chordLimits(const OriginalSurface& surface, double mean) {
  const double tolerance = std::max(kChordTolerance * surface.diagonal(),
                                    kChordOfSquare * mean * mean / surface.diagonal());
  return boundarySizes(surface, {tolerance, kShortestChord * mean});
}

void limit(const VertexData<double>& limits, VertexData<double>& sizes) {
  for (Index v = 0; v < limits.size(); ++v)
    sizes[Vertex(v)] = std::min(sizes[Vertex(v)], limits[Vertex(v)]);
}

// Bounds keep the gradation: they are the same everywhere.
void bound(const SizeRules& rules, VertexData<double>& sizes) {
  if (rules.shortest == 0 && rules.longest == kInfinity) return;
  for (double& size : sizes.values()) size = std::clamp(size, rules.shortest, rules.longest);
}

// Raises sizes around kept edges: a long kept edge needs triangles to match, even if all others are
// much smaller. Processed from the largest size down.
void raiseAround(const OriginalSurface& surface, const VertexData<double>& kept, double slope,
                 VertexData<double>& sizes) {
  std::priority_queue<std::pair<double, Index>> queue;
  const auto raise = [&](Vertex v, double size) {
    if (size <= sizes[v]) return;
    sizes[v] = size;
    queue.emplace(size, v.index);
  };
  for (Index i = 0; i < kept.size(); ++i) raise(Vertex(i), kept[Vertex(i)]);
  while (!queue.empty()) {
    const double size = queue.top().first;
    const Vertex v(queue.top().second);
    queue.pop();
    if (size < sizes[v]) continue;
    surface.mesh().forEachNeighbor(v, [&](Vertex w) {
      raise(w, size - slope * (surface.positions()[w] - surface.positions()[v]).norm());
    });
  }
}

// The area without the skin of spikes; the vertices are shared out over this area.
double areaToShare(const OriginalSurface& surface, const Spikes* spikes) {
  return spikes ? spikes->restOfArea : surface.area();
}

VertexData<double> areasToShare(const OriginalSurface& surface, const Spikes* spikes) {
  if (!spikes) return vertexAreas(surface);
  const HalfedgeMesh& mesh = surface.mesh();
  const VertexData<Vec3>& p = surface.positions();
  VertexData<double> areas(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (spikes->covers(mesh, Face(i))) continue;
    const auto [a, b, c] = mesh.vertices(Face(i));
    for (const Vertex v : {a, b, c}) areas[v] += area(p[a], p[b], p[c]) / 3;
  }
  return areas;
}

// With twice the spike's length as the size at its tip, the target of its edges is about its
// length, because the size at the foot is small: so they are neither split nor collapsed.
void stretchSpikes(const Spikes& spikes, VertexData<double>& sizes) {
  for (Index i = 0; i < sizes.size(); ++i)
    if (spikes.lengths[Vertex(i)] > 0) sizes[Vertex(i)] = 2 * spikes.lengths[Vertex(i)];
}

}  // namespace

double evenEdgeLength(double area, double vertices) {
  return std::sqrt(2 * area / (std::sqrt(3.0) * vertices));
}

double verticesForEdgeLength(double area, double length) {
  return 2 * area / (std::sqrt(3.0) * length * length);
}

SizeField::SizeField(const OriginalSurface& surface, const SizeRules& rules)
    : mesh_(&surface.mesh()),
      sizes_(surface.mesh().vertexCapacity(), 1),
      mean_(evenEdgeLength(areaToShare(surface, rules.spikes), rules.vertices)),
      meanEdge_(mean_),
      vertices_(rules.vertices),
      wished_(!rules.density.empty()),
      bounded_(rules.error > 0),
      spiked_(rules.spikes != nullptr) {
  const VertexData<double> kept = keptLengths(surface);
  even_ = rules.adaptivity == 0 && rules.density.empty() && rules.error == 0 && kept.size() == 0 &&
          !spiked_;
  if (even_) {
    sizes_.assign(sizes_.size(), mean_);
    return;
  }
  const double slope = slope_ = steepestSlope(rules.gradation);
  if (surface.hasFlats() && rules.adaptivity > 0 && kept.size() == 0 && !wished_ && !spiked_) {
    refined_ = std::make_shared<RefinedFaces>(surface, kFinestPart * mean_);
    sizes_ = accurateSizes(surface, *refined_, {mean_, rules.adaptivity, slope, rules.error});
    bound(rules, sizes_);
    meanEdge_ = meanOverEdges(refined_->areas(), sizes_);
    vertices_ = std::max(rules.vertices, verticesOf(refined_->areas(), sizes_));
    return;
  }
  const VertexData<double> areas = areasToShare(surface, rules.spikes);
  if (rules.adaptivity > 0) applyCurvature(surface, rules.adaptivity, areas, sizes_);
  for (Index i = 0; i < rules.density.size(); ++i)
    sizes_[Vertex(i)] /= std::sqrt(std::max(1e-6, double(rules.density[i])));
  // Beside kept edges the smaller size counts. The sooner sizes return to their proper value, the
  // more vertices are left for the rest.
  const double keptSlope = (rules.gradation - 1) / kLong;
  VertexData<double> largest, chords;
  if (rules.adaptivity > 0) chords = chordLimits(surface, mean_);
  if (rules.error > 0) largest = largestSizes(surface, rules.error);
  for (int i = 0; i < kNormalizations; ++i) {
    const double scale = normalScale(areas, mean_, sizes_);
    if (i > 0 && std::abs(scale - 1) < kNormalEnough) break;
    for (double& size : sizes_.values()) size *= scale;
    limit(largest, sizes_);
    limit(chords, sizes_);
    for (Index v = 0; v < kept.size(); ++v)
      if (kept[Vertex(v)] > 0) sizes_[Vertex(v)] = std::min(sizes_[Vertex(v)], kept[Vertex(v)]);
    limitGradation(surface, slope, sizes_);
    bound(rules, sizes_);
    raiseAround(surface, kept, keptSlope, sizes_);
  }
  if (rules.spikes) stretchSpikes(*rules.spikes, sizes_);
  meanEdge_ = meanOverEdges(areas, sizes_);
  vertices_ = std::max(rules.vertices, verticesOf(areas, sizes_));
}

double SizeField::narrow(const OriginalSurface& surface,
                         std::span<const std::pair<Vertex, double>> sizes) {
  if (refined_ || even_ || wished_ || bounded_) return 0;
  const VertexData<double> areas = vertexAreas(surface);
  const double before = verticesOf(areas, sizes_);
  for (const auto& [v, size] : sizes) sizes_[v] = std::min(sizes_[v], size);
  limitGradation(surface, slope_, sizes_);
  return verticesOf(areas, sizes_) - before;
}

void SizeField::moveOnto(const OriginalSurface& finer, const VertexData<Vertex>& collapseMap) {
  VertexData<double> sizes(collapseMap.size());
  for (Index i = 0; i < collapseMap.size(); ++i) sizes[Vertex(i)] = sizes_[collapseMap[Vertex(i)]];
  refined_.reset();
  mesh_ = &finer.mesh();
  sizes_ = std::move(sizes);
}

double SizeField::at(const SurfacePoint& p) const {
  if (refined_) return refined_->interpolate(p, sizes_);
  const auto [a, b, c] = mesh_->vertices(p.face);
  return p.barycentric[0] * sizes_[a] + p.barycentric[1] * sizes_[b] + p.barycentric[2] * sizes_[c];
}

}  // namespace remesher
