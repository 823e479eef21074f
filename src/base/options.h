// SPDX-License-Identifier: MIT
// What a caller can ask of a run. Angles in degrees, lengths in model units, errors in percent of
// the bounding box diagonal. An unset optional means the scheme's own default, which `resolved`
// fills in.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

enum class Scheme { Best, Rounds };          // ours | the report's Algorithm 2
enum class Quality { Draft, Best };          // for scheme `best`: fast | best result
enum class Projection { Patches, Current };  // onto the original | on the current mesh
enum class Fidelity { Strict, Loose, Fold };
enum class Boundary { Resample, Keep };
enum class Prefer { Auto, Even, Shape };  // even triangles, or vertices where shape needs them
// Texture coordinates along their seams | painted anew | painted where repair makes another
// surface.
enum class Textures { Auto, Keep, Bake };
enum class TextureFormat { Png, Jpeg, Webp };
enum class Repair { Off, Holes, Solid, Wrap, Auto };  // what is mended before remeshing
enum class Sheets { Thicken, Drop };                  // what wrap does with open sheets
enum class TooFew { Refuse, Raise };                  // for a target below what the surface needs
// If even triangles exceed an error bound: use those of the original | end the run.
enum class OutOfBound { FromOriginal, GiveUp };

struct RemeshOptions {
  std::optional<Index> vertices;     // exact number of distinct positions of the result
  std::optional<double> ratio;       // the same as a share of the input's
  std::optional<double> edgeLength;  // the same from a mean edge length
  Scheme scheme = Scheme::Best;
  Prefer prefer = Prefer::Auto;
  Quality quality = Quality::Best;
  Projection projection = Projection::Patches;
  std::optional<Fidelity> fidelity;
  double vertexAngle = 20;    // θ1
  double triangleAngle = 20;  // θ2
  bool splitObtuse = false;
  std::optional<double> adaptivity;  // 0 to 1
  double gradation = 1.5;            // > 1
  bool detectFeatures = true;        // false: --feature-angle off
  std::optional<double> featureAngle;
  Boundary boundary = Boundary::Resample;
  std::optional<double> maxError;                     // percent of the diagonal
  std::optional<double> weld;                         // likewise; nearer places become one
  std::vector<float> density;                         // per input vertex, relative; empty: even
  std::vector<std::pair<Index, Index>> featureEdges;  // the caller's, as input vertex pairs
  bool quads = false;                                 // pure quads instead of triangles
  bool exact = false;                                 // of quads: exactly so many vertices
  Textures textures = Textures::Auto;                 // for files
  std::optional<Index> textureSize;                   // texels along a side
  std::optional<TextureFormat> textureFormat;
  Repair repair = Repair::Off;
  std::optional<double> holesUpTo;  // the longest loop to be closed, percent of the diagonal
  std::optional<double> gap;  // the widest opening that repair closes, percent of the diagonal
  bool cavities = false;      // of solids, the inner ones: kept, not filled
  Sheets sheets = Sheets::Thicken;
  std::vector<double> lods;  // shares of the number of vertices, each > 0
  bool lodFiles = false;     // a file for each level, not one for all

  // Not set by the caller: see PartTargets, PartUnions, fewest_vertices.h.
  TooFew tooFew = TooFew::Refuse;
  OutOfBound outOfBound = OutOfBound::FromOriginal;
  std::vector<Index> bodies;      // per input group its body; all bodies form one surface
  std::optional<Index> inBodies;  // exact number of positions, each counted once per body
};

}  // namespace remesher
