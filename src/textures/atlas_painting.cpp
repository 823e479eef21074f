// SPDX-License-Identifier: MIT
#include "textures/atlas_painting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"
#include "textures/charts/atlas_figures.h"
#include "textures/charts/unwrap.h"
#include "textures/map_size.h"
#include "textures/painting/look_borders.h"
#include "textures/painting/new_surface.h"
#include "textures/painting/place_search.h"
#include "textures/painting/tangents.h"
#include "textures/shown_scale.h"

namespace remesher {

namespace {

Index groupOf(const TriangleMesh& mesh, std::size_t triangle) {
  return mesh.groups.empty() ? 0 : mesh.groups[triangle];
}

// A triangle of an atlas, which is one set of maps for triangles of all parts.
struct AtlasTriangle {
  Index part, triangle;
};

struct Atlas {
  std::vector<AtlasTriangle> triangles;
  Index size = 0;
  double finer = 1;
};

// The cosine between normals that part: charts end there, since one texel cannot hold a direction
// in two frames.
const double kParted = std::cos(radians(15));

// The content of an image: images with alpha or normals cannot be JPEG.
enum class Content { Opaque, Alpha, Normals };

class AtlasPainting {
 public:
  AtlasPainting(const PaintingInput& input, io::Model& model) : input_(input), model_(model) {
    for (const io::Part& original : input.originals) {
      std::vector<io::Material> materials;
      for (Index g = 0; g < groupCount(original.mesh); ++g)
        materials.push_back(lookOf(original, g));
      sources_.push_back(std::make_unique<PaintSource>(
          SourceInput{&original.mesh, std::move(materials), input.images, input.unshaded}));
    }
    places_.reserve(model.parts.size());  // surfaces refer to them
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      const TriangleMesh& mesh = model.parts[i].mesh;
      const PaintSource& source = *sources_[input.originalOf[i]];
      places_.push_back(input.areGiven[i] ? input.places[i] : placesOn(mesh, source));
      surfaces_.emplace_back(mesh, places_.back(), source);
      if (!input.onto) continue;
      surfaces_.back().takeNormals();
      surfaces_.back().joinFacings();
    }
    if (areAllOnFacets())
      for (NewSurface& surface : surfaces_) surface.dropNormals();
  }

  void paintClass(Index number, const Progress& progress) {
    Atlas atlas;
    for (Index p = 0; p < surfaces_.size(); ++p)
      for (Index t = 0; t < surfaces_[p].mesh().triangleCount(); ++t)
        if (input_.partClasses[p][groupOf(surfaces_[p].mesh(), t)] == number)
          atlas.triangles.push_back({p, t});
    if (atlas.triangles.empty()) return;
    const double texels = originalTexels(number);
    atlas.size = input_.options.textureSize.value_or(sizeFor(texels, storedTexels(number)));
    std::vector<char> rims = placed(atlas);
    for (; rims.empty(); rims = placed(atlas)) atlas.size *= 2;
    atlas.finer = std::sqrt(texels / std::max(1.0, paintedTexels(atlas)));
    const bool isLit =
        !looksOf(number).front().isUnlit && surfaces_[atlas.triangles.front().part].hasNormals();
    if (isLit) orient(atlas);
    report_.size = atlas.size;
    const std::vector<io::Material> looks = looksOf(number);
    const bool isOpaque = input_.onto ? areOpaque(looks) : looks.front().isOpaque;
    PaintRules rules{atlas.size, isOpaque, atlas.finer};
    rules.cages = input_.cages;
    rules.occludes = input_.options.ao;
    Painting painting = paint(canvasOf(atlas, rims), sources_, rules, progress);
    report_.notFound =
        painting.texels > 0 ? 100.0 * double(painting.lost) / double(painting.texels) : 0;
    remember(number, std::move(painting), isLit);
  }

  void finish() {
    std::vector<TriangleMesh> meshes;  // surfaces_ still refers to the old meshes
    for (const NewSurface& surface : surfaces_)
      meshes.push_back(input_.onto ? surface.paintedInOrder() : surface.painted());
    for (std::size_t i = 0; i < meshes.size(); ++i) model_.parts[i].mesh = std::move(meshes[i]);
  }

  const AtlasReport& report() const { return report_; }

 private:
  Index classOf(Index part, Index group) const { return input_.classes[part][group]; }

  template <class Visit>
  void forEachGroup(Index number, const Visit& visit) const {
    for (Index p = 0; p < input_.originals.size(); ++p)
      for (Index g = 0; g < input_.classes[p].size(); ++g)
        if (classOf(p, g) == number) visit(p, g);
  }

  template <class Visit>
  void forEachPartGroup(Index number, const Visit& visit) const {
    for (Index p = 0; p < input_.partClasses.size(); ++p)
      for (Index g = 0; g < input_.partClasses[p].size(); ++g)
        if (input_.partClasses[p][g] == number) visit(p, g);
  }

  // Whether all parts look like their originals without normals. Coarser levels share the maps, but
  // do not lie on the facets.
  bool areAllOnFacets() const {
    if (input_.onto || !input_.options.lods.empty()) return false;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const TriangleMesh& mesh = surfaces_[i].mesh();
      const PaintSource& source = *sources_[input_.originalOf[i]];
      if (!source.isFaceted()) return false;
      const auto places = input_.areGiven[i] ? placesOn(mesh, source) : places_[i];
      if (!liesOnFacets(mesh, source, places)) return false;
    }
    return true;
  }

  std::vector<io::Material> looksOf(Index number) const {
    std::vector<io::Material> looks;
    forEachGroup(number,
                 [&](Index p, Index g) { looks.push_back(lookOf(input_.originals[p], g)); });
    return looks;
  }

  double originalTexels(Index number) const {
    double texels = 0, bare = 0, steps = 0;
    for (Index p = 0; p < sources_.size(); ++p) {
      const TriangleMesh& mesh = sources_[p]->mesh();
      for (Index t = 0; t < mesh.triangleCount(); ++t) {
        if (classOf(p, groupOf(mesh, t)) != number) continue;
        texels += sources_[p]->texels(InputTriangle(t));
        bare += kBareTexels;
        steps += sources_[p]->colorTexels(InputTriangle(t));
      }
    }
    return std::max({texels, bare, std::min(steps, kMostForSteps)});
  }

  // The texels that a class's maps hold.
  double storedTexels(Index number) const {
    double texels = 0;
    forEachGroup(number, [&](Index p, Index g) { texels += sources_[p]->largestMap(g); });
    return texels;
  }

  // Per part and corner, whether charts end at the edge from it.
  std::vector<std::vector<char>> bordersOf(const Atlas& atlas) const {
    double area = 0;
    std::vector<double> scales;
    for (const io::Part& part : model_.parts) scales.push_back(shownScale(part));
    for (const auto& [part, t] : atlas.triangles) {
      const auto& [a, b, c] = surfaces_[part].onSource(t).corners;
      area += scales[part] * scales[part] * areaVector(a, b, c).norm() / 2;
    }
    const double texel = std::sqrt(area / kUse) / atlas.size;
    std::vector<std::vector<char>> borders;
    for (Index p = 0; p < surfaces_.size(); ++p)
      borders.push_back(
          lookBorders(surfaces_[p], *sources_[input_.originalOf[p]], texel / scales[p]));
    return borders;
  }

  static bool areOpaque(const std::vector<io::Material>& looks) {
    return std::all_of(looks.begin(), looks.end(),
                       [](const io::Material& look) { return look.isOpaque; });
  }

  // Per corner whether the edge from it is where normals part.
  std::vector<std::vector<char>> hardEdges() const {
    std::vector<std::vector<char>> hard;
    for (const NewSurface& surface : surfaces_) {
      std::vector<Index> corners;
      for (Index h = 0; h < surface.mesh().indices.size(); ++h)
        corners.push_back(surface.welded(h));
      hard.emplace_back(corners.size(), 0);
      const EdgeGroups edges(surface.positions().size(), corners);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        if (edges[e].size() != 2) continue;
        const Index a = edges[e][0], b = edges[e][1];
        if (areOneQuad(surface.kind(), a / 3, b / 3)) continue;
        const auto parts = [&](Index i, Index j) {
          return surface.normal(i).dot(surface.normal(j)) < kParted;
        };
        hard.back()[a] = hard.back()[b] = parts(a, nextCorner(b)) || parts(nextCorner(a), b);
      }
    }
    return hard;
  }

  // Sets the texture coordinates of all corners of an atlas, the parts' own or new ones. Returns
  // where its charts end, or nothing if an automatically chosen size is too small.
  std::vector<char> placed(const Atlas& atlas) {
    if (!input_.onto || !input_.onto->keepsTexcoords) return layOut(atlas);
    std::vector<char> rims;
    for (const auto& [part, t] : atlas.triangles) {
      NewSurface& surface = surfaces_[part];
      const Attribute& own = *findAttribute(surface.mesh(), "TEXCOORD_0");
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const float* const uv = &own.values[2 * std::size_t{surface.mesh().indices[h]}];
        surface.setTexcoord(h, Vec2(uv[0], uv[1]), 1);
        rims.push_back(0);
      }
    }
    return rims;
  }

  // Triangles in the order of their corners around the square; a chart may be mirrored.
  std::vector<CanvasTriangle> canvasOf(const Atlas& atlas, const std::vector<char>& rims) const {
    std::vector<CanvasTriangle> canvas;
    for (const AtlasTriangle& t : atlas.triangles) {
      const auto corner = [&](Index k) {
        return surfaces_[t.part].canvasCorner(3 * t.triangle + k, atlas.size);
      };
      const char* const rim = &rims[3 * canvas.size()];
      const Index source = input_.originalOf[t.part];
      canvas.push_back({{corner(0), corner(1), corner(2)}, source, {rim[0], rim[1], rim[2]}});
      CanvasTriangle& made = canvas.back();
      const Vec2 tile =
          tileOf(made.corners[0].texel / atlas.size, made.corners[1].texel / atlas.size,
                 made.corners[2].texel / atlas.size);
      for (CanvasCorner& c : made.corners) c.texel -= atlas.size * tile;
      const Vec2 a = made.corners[1].texel - made.corners[0].texel;
      const Vec2 b = made.corners[2].texel - made.corners[0].texel;
      if (a.x() * b.y() - a.y() * b.x() >= 0) continue;
      std::swap(made.corners[1], made.corners[2]);
      std::swap(made.rims[0], made.rims[2]);
    }
    return canvas;
  }

  // Sets new texture coordinates of all corners of an atlas. Returns where its charts end, or
  // nothing if an automatically chosen size is too small.
  std::vector<char> layOut(const Atlas& atlas) {
    std::vector<Vec3> positions;
    std::vector<Index> indices, offsets;
    for (const NewSurface& surface : surfaces_) {
      offsets.push_back(Index(positions.size()));
      const double scale = shownScale(model_.parts[offsets.size() - 1]);
      for (const Vec3& p : surface.positions()) positions.push_back(scale * p);
    }
    const std::vector<std::vector<char>> borders = input_.onto ? hardEdges() : bordersOf(atlas);
    std::vector<char> cuts;
    std::vector<Index> faces;
    for (const auto& [part, t] : atlas.triangles) {
      const auto number = Index(faces.size());
      faces.push_back(number - (surfaces_[part].kind() == FaceKind::Quads ? t % 2 : 0));
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        indices.push_back(offsets[part] + surfaces_[part].welded(h));
        cuts.push_back(borders[part][h]);
      }
    }
    const Index padding = 1 + atlas.size / kPaddingShare;
    const Unwrapped unwrapped = unwrap({positions, indices, cuts, faces}, {atlas.size, padding});
    if (!(unwrapped.scale > 0) && !input_.options.textureSize && atlas.size < kLargest) return {};
    if (!(unwrapped.scale > 0))
      throw Error(ErrorCode::InvalidOption,
                  "Textures of " + std::to_string(atlas.size) + " texels are too small for " +
                      std::to_string(unwrapped.chartCount) + " charts.",
                  "Give a larger textureSize, or keep the textures.");
    report_.charts = unwrapped.chartCount;
    for (std::size_t i = 0; i < atlas.triangles.size(); ++i)
      for (Index k = 0; k < 3; ++k)
        surfaces_[atlas.triangles[i].part].setTexcoord(3 * atlas.triangles[i].triangle + k,
                                                       unwrapped.corners[3 * i + k], atlas.size);
    // Both sides of a seam find the same places: none is cut off from the other.
    if (input_.onto) return std::vector<char>(unwrapped.rims.size(), 0);
    return unwrapped.rims;
  }

  double paintedTexels(const Atlas& atlas) const {
    double sum = 0;
    for (const auto& [part, t] : atlas.triangles) {
      const NewSurface& s = surfaces_[part];
      const Vec2 a = s.texcoord(3 * t + 1) - s.texcoord(3 * t);
      const Vec2 b = s.texcoord(3 * t + 2) - s.texcoord(3 * t);
      sum += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
    }
    return sum * atlas.size * atlas.size;
  }

  // Sets the tangents of all corners of an atlas, part by part: equal positions in two parts are
  // different places.
  void orient(const Atlas& atlas) {
    for (std::size_t begin = 0; begin < atlas.triangles.size();) {
      const Index part = atlas.triangles[begin].part;
      NewSurface& surface = surfaces_[part];
      std::vector<Vec3> positions, normals;
      std::vector<Vec2> texcoords;
      std::size_t end = begin;
      for (; end < atlas.triangles.size() && atlas.triangles[end].part == part; ++end)
        for (Index k = 0; k < 3; ++k) {
          const Index h = 3 * atlas.triangles[end].triangle + k;
          positions.push_back(surface.position(h));
          normals.push_back(surface.normal(h));
          texcoords.push_back(surface.texcoord(h));
        }
      const auto tangents = computeTangents({positions, normals, texcoords});
      for (std::size_t i = 0; i < tangents.size(); ++i)
        surface.setTangent(3 * atlas.triangles[begin + i / 3].triangle + Index(i % 3), tangents[i]);
      begin = end;
    }
  }

  std::string typeFor(Content content) const {
    const bool isLossless = content != Content::Opaque;
    const auto usual = isLossless ? TextureFormat::Png : TextureFormat::Jpeg;
    const TextureFormat format = input_.options.textureFormat.value_or(usual);
    if (format == TextureFormat::Webp) return "image/webp";
    return format == TextureFormat::Png || isLossless ? "image/png" : "image/jpeg";
  }

  io::Map add(const std::string& name, io::Image image, const std::string& type) {
    io::Map map;
    map.image = std::to_string(model_.images.size());
    model_.images.push_back({name, type, std::move(image)});
    return map;
  }

  bool hasColors(Index number) const {
    bool result = false;
    forEachGroup(number, [&](Index p, Index) {
      result |= findAttribute(input_.originals[p].mesh, "COLOR_0") != nullptr;
    });
    return result;
  }

  // The material for parts of another file than the originals'.
  static io::Material asOwn(io::Material made, const std::vector<io::Material>& looks) {
    made.number = -1;
    if (made.name.empty()) made.name = "baked";
    made.isOpaque = areOpaque(looks);
    made.keepsRest = std::all_of(looks.begin(), looks.end(), [&](const io::Material& look) {
      return look.rest == looks.front().rest;
    });
    return made;
  }

  // Whether no texel of a map of normals bends them.
  static bool isFlat(const io::Image& normals) {
    for (std::size_t i = 0; i < normals.texels.size(); i += 4)
      if (std::abs(normals.texels[i] - 128) > 1 || std::abs(normals.texels[i + 1] - 128) > 1)
        return false;
    return true;
  }

  // Adds the painted maps as a material; a value that is the same everywhere stays a factor.
  void remember(Index number, Painting painting, bool bendsNormals) {
    const std::vector<io::Material> looks = looksOf(number);
    const io::Material& first = looks.front();
    const auto isConstant = [&](const auto& isSame) {
      return std::all_of(looks.begin(), looks.end(), isSame);
    };
    io::Material made = first;
    made.baseColorMap = made.metalRoughMap = made.occlusionMap = made.emissiveMap =
        made.normalMap = {};
    const bool plainColor = !hasColors(number) && isConstant([&](const io::Material& m) {
      return !m.baseColorMap && m.baseColor == first.baseColor;
    });
    if (!plainColor) {
      made.baseColorMap = add("baseColor", std::move(painting.baseColor),
                              typeFor(first.isOpaque ? Content::Opaque : Content::Alpha));
      made.baseColor.setOnes();
    }
    const bool plainSurface = !input_.options.ao && isConstant([&](const io::Material& m) {
      return !m.metalRoughMap && !m.occlusionMap && m.metallic == first.metallic &&
             m.roughness == first.roughness;
    });
    if (!plainSurface) {
      const bool occludes =
          input_.options.ao || !isConstant([](const io::Material& m) { return !m.occlusionMap; });
      made.metalRoughMap = add("surface", std::move(painting.surface), typeFor(Content::Opaque));
      if (occludes) made.occlusionMap = made.metalRoughMap;
      made.metallic = made.roughness = made.occlusionStrength = 1;
    }
    const bool plainLight = isConstant(
        [&](const io::Material& m) { return !m.emissiveMap && m.emissive == first.emissive; });
    if (!plainLight) {
      made.emissiveMap = add("emissive", std::move(painting.emissive), typeFor(Content::Opaque));
      made.emissive.setOnes();
    }
    if (bendsNormals && !isFlat(painting.normal))
      made.normalMap = add("normal", std::move(painting.normal), typeFor(Content::Normals));
    made.normalScale = 1;
    if (input_.onto) made = asOwn(std::move(made), looks);
    forEachPartGroup(number, [&](Index p, Index g) {
      io::Part& part = model_.parts[p];
      if (part.groups.size() <= g) part.groups.resize(std::size_t{g} + 1);
      part.groups[g].painted = int(model_.paintings.size());
      std::erase_if(part.groups[g].lacks, isPainted);
      if (first.isUnlit) part.groups[g].lacks.push_back("TANGENT");
    });
    model_.paintings.push_back(std::move(made));
  }

  const PaintingInput& input_;
  io::Model& model_;
  std::vector<std::unique_ptr<PaintSource>> sources_;
  std::vector<std::vector<InputPlace>> places_;
  std::vector<NewSurface> surfaces_;
  AtlasReport report_;
};

}  // namespace

bool isPainted(const std::string& semantic) {
  const std::string own = semantic.substr(semantic.find('/') + 1);  // of a morph target, too
  return own == "TANGENT" || own.starts_with("TEXCOORD_") || own.starts_with("COLOR_") ||
         semantic == "NORMAL";
}

io::Material lookOf(const io::Part& part, Index group) {
  return group < part.groups.size() ? part.groups[group].look : io::Material();
}

// A warning for each kind of map that cannot be painted.
std::vector<Warning> unpaintedMaps(const std::vector<io::Part>& parts) {
  std::map<std::string, std::size_t> counts;
  std::set<std::pair<int, std::string>> seen;
  for (const io::Part& part : parts)
    for (const io::GroupInfo& group : part.groups) {
      if (!seen.insert({group.look.number, group.look.name}).second) continue;
      for (const std::string& name : group.look.unpaintable) ++counts[name];
    }
  std::vector<Warning> warnings;
  for (const auto& [name, count] : counts)
    warnings.push_back(
        {"MAP_NOT_PAINTED", "The map " + legible(name) + " cannot be baked and is lost.", count});
  return warnings;
}

std::vector<Warning> furtherTexcoords(const std::vector<io::Part>& parts) {
  std::set<std::string> names;
  for (const io::Part& part : parts)
    for (const Attribute& attribute : part.mesh.attributes)
      if (attribute.semantic.starts_with("TEXCOORD_") && attribute.semantic != "TEXCOORD_0")
        names.insert(attribute.semantic);
  if (names.empty()) return {};
  return {{"ATTRIBUTE_NOT_CARRIED",
           "Baked textures have one set of texture coordinates: the result has no " +
               legibleList({names.begin(), names.end()}) + ".",
           names.size()}};
}

AtlasReport paintAtlases(const PaintingInput& input, io::Model& model, Index classCount,
                         const Progress& progress) {
  AtlasPainting painting(input, model);
  for (Index c = 0; c < classCount; ++c)
    painting.paintClass(
        c, progress.part(double(c) / double(classCount), double(c + 1) / double(classCount)));
  painting.finish();
  return painting.report();
}

}  // namespace remesher
