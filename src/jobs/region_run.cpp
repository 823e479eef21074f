// SPDX-License-Identifier: MIT
#include "jobs/region_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/fires.h"
#include "base/place.h"
#include "jobs/inspected_parts.h"
#include "jobs/parts/part_report.h"
#include "mesh/joining.h"

namespace remesher {
namespace {

void requireAlone(bool isAlone, const std::string& message, const std::string& hint) {
  if (!isAlone) throw Error(ErrorCode::InvalidOption, message, hint);
}

void checkRegion(const std::vector<io::Part>& parts, const PartOptions& options) {
  requireAlone(parts.size() == 1,
               "region needs one mesh, not " + std::to_string(parts.size()) + ".",
               "Give the meshes one by one.");
  const std::size_t triangles = parts.front().mesh.triangleCount();
  for (const Index t : options.region)
    requireAlone(t < triangles,
                 "region names triangle " + std::to_string(t) + "; the mesh has " +
                     std::to_string(triangles) + ", counted from 0.",
                 "Give numbers of triangles of the input.");
}

using Triple = std::array<double, 3>;

Triple tripleOf(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

// How much two vertices of different meshes differ in the attributes that both have.
double differenceOf(const TriangleMesh& mesh, Index v, const TriangleMesh& other, Index w) {
  double sum = 0;
  for (const Attribute& own : mesh.attributes) {
    const Attribute* const its = findAttribute(other, own.semantic);
    if (!its || its->itemSize != own.itemSize) continue;
    const auto size = std::size_t(own.itemSize);
    for (std::size_t k = 0; k < size; ++k) {
      const double d = double(own.values[v * size + k]) - double(its->values[w * size + k]);
      sum += d * d;
    }
  }
  return sum;
}

// Per vertex of what was made of the region the vertex of the whole that it is, or kNone.
class BorderMatch {
 public:
  BorderMatch(const TriangleMesh& whole, const std::vector<Index>& border, const TriangleMesh& made)
      : whole_(whole), made_(made), matches_(made.positions.size(), kNone) {
    std::map<Triple, std::vector<Index>> at;
    for (const Index v : border) at[tripleOf(whole.positions[v])].push_back(v);
    std::map<Triple, bool> isFound;
    for (Index w = 0; w < made.positions.size(); ++w) {
      const auto found = at.find(tripleOf(made.positions[w]));
      if (found == at.end()) continue;
      isFound[found->first] = true;
      matches_[w] = likest(found->second, w);
    }
    for (const auto& [place, vertices] : at)
      if (!isFound.contains(place)) matchNearest(vertices);
  }

  const std::vector<Index>& matches() const { return matches_; }

 private:
  // Of the vertices at one place the one with the attributes most like those of w.
  Index likest(const std::vector<Index>& vertices, Index w) const {
    return *std::min_element(vertices.begin(), vertices.end(), [&](Index a, Index b) {
      return differenceOf(whole_, a, made_, w) < differenceOf(whole_, b, made_, w);
    });
  }

  // Coordinates with noise around zero come back without it.
  void matchNearest(const std::vector<Index>& vertices) {
    fires("region: a border vertex came back with other digits");
    const Vec3& place = whole_.positions[vertices.front()];
    double least = kInfinity;
    for (const Vec3& p : made_.positions) least = std::min(least, (p - place).squaredNorm());
    for (Index w = 0; w < made_.positions.size(); ++w)
      if ((made_.positions[w] - place).squaredNorm() == least) matches_[w] = likest(vertices, w);
  }

  const TriangleMesh& whole_;
  const TriangleMesh& made_;
  std::vector<Index> matches_;
};

void setVertex(TriangleMesh& mesh, Index v, const TriangleMesh& made, Index w) {
  mesh.positions[v] = made.positions[w];
  for (Attribute& attribute : mesh.attributes) {
    const Attribute& its = *findAttribute(made, attribute.semantic);
    const auto size = std::size_t(attribute.itemSize);
    std::copy_n(&its.values[w * size], size, &attribute.values[v * size]);
  }
}

void addVertex(TriangleMesh& mesh) {
  mesh.positions.emplace_back(Vec3::Zero());
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(attribute.values.size() + std::size_t(attribute.itemSize));
}

// Leaves out vertices; the others stay in their order.
void removeVertices(TriangleMesh& mesh, const std::vector<char>& isRemoved) {
  std::vector<Index> numbers(mesh.positions.size(), kNone);
  Index kept = 0;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (isRemoved[v]) continue;
    mesh.positions[kept] = mesh.positions[v];
    for (Attribute& attribute : mesh.attributes) {
      const auto size = std::size_t(attribute.itemSize);
      std::copy_n(&attribute.values[v * size], size, &attribute.values[kept * size]);
    }
    numbers[v] = kept++;
  }
  mesh.positions.resize(kept);
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(std::size_t(attribute.itemSize) * kept);
  for (Index& i : mesh.indices) i = numbers[i];
}

}  // namespace

RegionRun::RegionRun(std::vector<io::Part>& parts, const PartOptions& options) {
  if (options.region.empty()) return;
  checkRegion(parts, options);
  io::Part& part = parts.front();
  requireValid(part.mesh);
  isInside_.assign(part.mesh.triangleCount(), 0);
  for (const Index t : options.region) isInside_[t] = 1;
  whole_ = part;
  takeOut(part);
}

void RegionRun::takeOut(io::Part& part) {
  const TriangleMesh& whole = whole_->mesh;
  isOutside_.assign(whole.positions.size(), 0);
  std::vector<char> isUsed(whole.positions.size(), 0);
  for (std::size_t i = 0; i < whole.indices.size(); ++i)
    (isInside_[i / 3] ? isUsed : isOutside_)[whole.indices[i]] = 1;
  const std::vector<Index> first = weld(whole.positions);
  std::vector<char> isPlace(first.size(), 0), isPlaceOutside(first.size(), 0);
  for (Index v = 0; v < first.size(); ++v) {
    if (isUsed[v] || isOutside_[v]) isPlace[first[v]] = 1;
    if (isOutside_[v]) isPlaceOutside[first[v]] = 1;
  }
  std::vector<char> isBorder(first.size(), 0);
  std::vector<Index> numbers(first.size(), kNone);
  TriangleMesh inside = whole;
  std::vector<char> isLeftOut;
  for (Index v = 0; v < first.size(); ++v) {
    isLeftOut.push_back(char(!isUsed[v]));
    if (!isUsed[v]) continue;
    sources_.push_back(v);
    if (!isPlaceOutside[first[v]]) continue;
    border_.push_back(v);
    isBorder[first[v]] = 1;
  }
  for (Index v = 0; v < first.size(); ++v) {
    places_ += std::size_t(isPlace[v]);
    others_ += std::size_t(isPlaceOutside[v] && !isBorder[v]);
  }
  inside.indices.clear();
  inside.groups.clear();
  for (std::size_t t = 0; t < isInside_.size(); ++t) {
    trianglesOutside_ += isInside_[t] ? 0 : 1;
    if (!isInside_[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) inside.indices.push_back(whole.indices[3 * t + k]);
    if (!whole.groups.empty()) inside.groups.push_back(whole.groups[t]);
  }
  inside.isQuads = false;
  removeVertices(inside, isLeftOut);
  growth_ = diagonalOf(whole) / diagonalOf(inside);
  part.mesh = std::move(inside);
}

PartOptions RegionRun::applied(PartOptions options) const {
  if (!whole_) return options;
  options.region.clear();
  options.boundary = Boundary::Keep;
  const auto left = [](double wanted, std::size_t outside, const char* what) {
    if (wanted > double(outside)) return Index(wanted - double(outside));
    throw Error(ErrorCode::TargetTooSmall,
                "The target of " + std::to_string(std::llround(wanted)) + " " + what +
                    " is too small: outside the region there are " + std::to_string(outside) + ".",
                "Ask for more than that, or for a larger region.");
  };
  if (options.ratio) options.vertices = Index(std::llround(*options.ratio * double(places_)));
  options.ratio.reset();
  if (options.vertices) options.vertices = left(*options.vertices, others_, "vertices");
  if (options.faces) options.faces = left(*options.faces, trianglesOutside_, "triangles");
  if (options.maxError) *options.maxError *= growth_;
  std::vector<Index> numbers(isOutside_.size(), kNone);
  for (Index v = 0; v < sources_.size(); ++v) numbers[sources_[v]] = v;
  if (options.density.size() == isOutside_.size()) {
    std::vector<float> density;
    for (const Index v : sources_) density.push_back(options.density[v]);
    options.density = std::move(density);
  }
  std::erase_if(options.featureEdges, [&](const std::pair<Index, Index>& edge) {
    const bool isKnown = edge.first < numbers.size() && edge.second < numbers.size();
    return isKnown && (numbers[edge.first] == kNone || numbers[edge.second] == kNone);
  });
  for (auto& [a, b] : options.featureEdges)
    if (a < numbers.size() && b < numbers.size()) a = numbers[a], b = numbers[b];
  return options;
}

// The numbers of the vertices and triangles outside stay, unless the region has fewer than before:
// then all later ones close up.
TriangleMesh RegionRun::joinedWith(const TriangleMesh& made) const {
  TriangleMesh mesh = whole_->mesh;
  mesh.isQuads = false;
  std::erase_if(mesh.attributes, [&](const Attribute& attribute) {
    const Attribute* const its = findAttribute(made, attribute.semantic);
    return !its || its->itemSize != attribute.itemSize;
  });
  const BorderMatch match(whole_->mesh, border_, made);
  std::vector<Index> numbers = match.matches();
  std::vector<char> isFree(mesh.positions.size(), 0);
  for (const Index v : sources_) isFree[v] = char(!isOutside_[v]);
  for (const Index v : numbers)
    if (v != kNone) isFree[v] = 0;
  Index next = 0;
  for (Index w = 0; w < numbers.size(); ++w) {
    if (numbers[w] != kNone) continue;
    while (next < isFree.size() && !isFree[next]) ++next;
    if (next == isFree.size()) {
      addVertex(mesh);
      isFree.push_back(1);
    }
    isFree[next] = 0;
    setVertex(mesh, next, made, w);
    numbers[w] = next;
  }
  const std::vector<Index> given = std::exchange(mesh.indices, {});
  const std::vector<Index> groups = std::exchange(mesh.groups, {});
  std::size_t put = 0;
  const auto putNext = [&] {
    if (put == made.triangleCount()) return;
    for (std::size_t k = 0; k < 3; ++k) mesh.indices.push_back(numbers[made.indices[3 * put + k]]);
    if (!groups.empty()) mesh.groups.push_back(made.groups[put]);
    ++put;
  };
  for (std::size_t t = 0; t < isInside_.size(); ++t) {
    if (isInside_[t]) {
      putNext();
      continue;
    }
    mesh.indices.insert(mesh.indices.end(), &given[3 * t], &given[3 * t] + 3);
    if (!groups.empty()) mesh.groups.push_back(groups[t]);
  }
  while (put < made.triangleCount()) putNext();
  if (std::find(isFree.begin(), isFree.end(), 1) != isFree.end()) removeVertices(mesh, isFree);
  return mesh;
}

void RegionRun::finish(std::vector<SceneRun>& runs) const {
  if (!whole_) return;
  SceneRun& run = runs.front();
  io::Part& part = run.parts.front();
  part.mesh = joinedWith(part.mesh);
  const std::vector<io::Part> originals = {*whole_};
  Report& report = run.report;
  std::optional<WantedReport> wanted = std::move(report.output->wanted);
  report.input = inspectScaled(originals);
  report.output = inspectScaled(run.parts);
  report.output->wanted = std::move(wanted);
  report.fidelity = fidelityOf({originals, run.parts, placesOf(originals)}, Maximum::Sampled, {});
}

}  // namespace remesher
