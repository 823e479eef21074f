// SPDX-License-Identifier: MIT
#include "textures/new_texcoords.h"

#include <string>

#include "base/error.h"
#include "base/place.h"
#include "textures/charts/unwrap.h"
#include "textures/map_size.h"
#include "textures/painting/corner_values.h"
#include "textures/shown_scale.h"

namespace remesher {

namespace {

// The padding of painted maps serves five mip levels. Texture coordinates alone keep half of it,
// for three.
constexpr Index kUnpaintedShare = 2 * kPaddingShare;

// The triangles of all parts, at the sizes at which they are shown.
struct Gathered {
  std::vector<Vec3> positions;
  std::vector<Index> indices;  // welded, part by part
  std::vector<Index> faces;    // see UnwrapInput
};

Gathered gatheredFrom(const std::vector<io::Part>& parts) {
  Gathered all;
  for (const io::Part& part : parts) {
    const Index offset = Index(all.positions.size());
    const double scale = shownScale(part);
    for (const Vec3& p : part.mesh.positions) all.positions.push_back(scale * p);
    const std::vector<Index> first = weld(part.mesh.positions);
    for (std::size_t h = 0; h < part.mesh.indices.size(); ++h) {
      all.indices.push_back(offset + first[part.mesh.indices[h]]);
      const Index face = Index(all.faces.size());
      if (h % 3 == 0) all.faces.push_back(face - (part.mesh.isQuads ? Index(h / 3 % 2) : 0));
    }
  }
  return all;
}

}  // namespace

AtlasReport unwrapParts(std::vector<io::Part>& parts, Index size) {
  const Gathered all = gatheredFrom(parts);
  const std::vector<char> cuts(all.indices.size(), 0);
  const Unwrapped unwrapped =
      unwrap({all.positions, all.indices, cuts, all.faces}, {size, 1 + size / kUnpaintedShare});
  if (!(unwrapped.scale > 0))
    throw Error(ErrorCode::InvalidOption,
                "A square of " + std::to_string(size) + " texels is too small for " +
                    std::to_string(unwrapped.chartCount) + " charts.",
                "Give a larger --texture-size.");
  std::size_t at = 0;
  for (io::Part& part : parts) {
    CornerValues texcoords{"TEXCOORD_0", 2, {}};
    for (std::size_t h = 0; h < part.mesh.indices.size(); ++h, ++at)
      for (const double x : unwrapped.corners[at]) texcoords.values.push_back(float(x / size));
    part.mesh = withCorners(std::move(part.mesh), {&texcoords, 1});
  }
  return reportOf(texcoordFigures(parts), size);
}

AtlasFigures texcoordFigures(const std::vector<io::Part>& parts) {
  const Gathered all = gatheredFrom(parts);
  std::vector<Vec3> positions;
  std::vector<Vec2> texcoords;
  for (const Index v : all.indices) positions.push_back(all.positions[v]);
  for (const io::Part& part : parts) {
    const Attribute* const own = findAttribute(part.mesh, "TEXCOORD_0");
    for (const Index v : part.mesh.indices)
      texcoords.push_back(
          own == nullptr || own->itemSize != 2
              ? Vec2::Zero().eval()
              : Vec2(own->values[2 * std::size_t{v}], own->values[2 * std::size_t{v} + 1]));
  }
  return figuresOf({positions, all.indices, texcoords});
}

AtlasReport reportOf(const AtlasFigures& figures, Index size) {
  AtlasReport report;
  report.size = size;
  report.charts = figures.charts;
  report.coverage = 100 * figures.coverage;
  report.stretch = figures.stretch;
  report.worstStretch = figures.worstStretch;
  return report;
}

}  // namespace remesher
