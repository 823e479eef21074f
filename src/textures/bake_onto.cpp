// SPDX-License-Identifier: MIT
#include "textures/bake_onto.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/legible.h"
#include "geometry/mesh_triangle.h"
#include "mesh/joining.h"
#include "textures/atlas_painting.h"
#include "textures/new_texcoords.h"
#include "textures/painting/place_search.h"

namespace remesher {

namespace {

// Texture coordinates are used if at most this share of what they cover is covered twice, and of
// the surface is across its border or has no area in it.
constexpr double kMostUnusable = 0.005;
// The cage if none is given: so many times the largest distance found, within these shares of the
// diagonal.
constexpr double kBeyondFarthest = 1.5, kLeastCage = 0.002, kMostCage = 0.05;
// A warning is due from this percentage of texels on for which nothing was found.
constexpr double kMostNotFound = 0.1;

// The largest distance of a part's corners and middles of triangles from the source.
double farthestFrom(const TriangleMesh& mesh, const PaintSource& source) {
  const PlaceSearch search(source);
  double farthest = 0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    const Vec3 middle = (a + b + c) / 3, normal = unitNormal(a, b, c);
    for (const Vec3& p : {a, middle})
      farthest = std::max(farthest, (source.position(search.at(p, normal)) - p).norm());
  }
  return farthest;
}

// Per original the cage for the parts that are painted from it, as a share of its diagonal; the
// same for all.
double cageFor(const io::Model& model, const BakeOriginals& from, std::optional<double> given) {
  if (given) return *given / 100;
  double share = kLeastCage;
  for (Index i = 0; i < from.originals.size(); ++i) {
    const TriangleMesh& original = from.originals[i].mesh;
    const PaintSource source({&original, {}, {}, from.unshaded});
    for (std::size_t p = 0; p < model.parts.size(); ++p)
      if (from.originalOf[p] == i)
        share = std::max(share, kBeyondFarthest * farthestFrom(model.parts[p].mesh, source) /
                                    diagonalOf(original));
  }
  return std::min(share, kMostCage);
}

bool hasTexcoords(const io::Model& model) {
  return std::all_of(model.parts.begin(), model.parts.end(), [](const io::Part& part) {
    return findAttribute(part.mesh, "TEXCOORD_0") != nullptr;
  });
}

std::string percentOf(double share) { return inDigits(100 * share, 3) + " %"; }

// Whether the parts' own texture coordinates are used; why not, if they have some.
bool keepsTexcoords(io::Model& model) {
  if (!hasTexcoords(model)) return false;
  const AtlasFigures figures = texcoordFigures(model.parts);
  if (figures.unusable <= kMostUnusable && figures.overlap <= kMostUnusable) return true;
  const bool isBeyond = figures.unusable > kMostUnusable;
  model.warnings.push_back(
      {"TEXCOORDS_REPLACED",
       isBeyond ? percentOf(figures.unusable) +
                      " of the surface has texture coordinates without an area or across the "
                      "border of the square: the mesh gets new ones."
                : "Texture coordinates overlap on " + percentOf(figures.overlap) +
                      " of what they cover, so that one texel would show several places: the "
                      "mesh gets new ones."});
  return false;
}

std::vector<std::vector<Index>> oneClass(const std::vector<io::Part>& parts) {
  std::vector<std::vector<Index>> classes;
  for (const io::Part& part : parts) classes.emplace_back(groupCount(part.mesh), 0);
  return classes;
}

}  // namespace

AtlasReport bakeOnto(io::Model& model, const BakeOriginals& from, const RemeshOptions& options,
                     const Progress& progress) {
  const bool isGiven = keepsTexcoords(model);
  const double share = cageFor(model, from, options.cage);
  std::vector<double> cages;
  for (const io::Part& original : from.originals)
    cages.push_back(share * diagonalOf(original.mesh));
  std::vector<std::vector<Index>> classes = oneClass(from.originals);
  for (std::size_t i = 1; i < classes.size(); ++i)  // the same surface once more
    std::fill(classes[i].begin(), classes[i].end(), kNone);
  const std::vector<std::vector<Index>> partClasses = oneClass(model.parts);
  const std::vector<std::vector<InputPlace>> places;  // all are searched for
  const PaintingInput input{from.originals,
                            from.images,
                            classes,
                            partClasses,
                            places,
                            options,
                            from.unshaded,
                            std::vector<char>(model.parts.size(), 0),
                            from.originalOf,
                            std::move(cages),
                            OntoRules{isGiven}};
  const AtlasReport painted = paintAtlases(input, model, 1, progress);
  AtlasReport report = reportOf(texcoordFigures(model.parts), painted.size);
  report.isGiven = isGiven;
  report.notFound = painted.notFound;
  report.cage = 100 * share;
  if (report.notFound > kMostNotFound)
    model.warnings.push_back(
        {"TEXELS_NOT_FOUND", "For " + inDigits(report.notFound, 3) +
                                 " % of the texels no surface was found within " +
                                 inDigits(report.cage, 3) +
                                 " % of the diagonal: they take the colours beside them. A "
                                 "larger --cage finds more."});
  for (Warning& warning : unpaintedMaps({from.originals.front()}))
    model.warnings.push_back(std::move(warning));
  return report;
}

}  // namespace remesher
