// SPDX-License-Identifier: MIT
// The options that a caller sets. Angles in degrees, lengths in model units, errors in percent of
// the bounding box diagonal. An unset optional means the scheme's own default, which each step
// fills in where it reads the option.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

enum class Scheme { Best, Rounds };          // ours | [DGP 2016], Algorithm 2
enum class Quality { Draft, Best };          // for scheme `best`: fast | best result
enum class Projection { Patches, Current };  // onto the original | on the current mesh
enum class Fidelity { Strict, Loose, Fold };
enum class Boundary { Resample, Keep };
enum class Prefer { Auto, Even, Shape };  // isotropic triangles, or vertices where shape needs them
// Baked where repair makes another surface | texture coordinates along their seams | left
// out | baked.
enum class Textures { Auto, Keep, Drop, Bake };
enum class TextureFormat { Png, Jpeg, Webp };
// Of quads: mirrored exactly where the input is mirrored, or never, or about planes at right angles
// to these axes, whatever the input is.
enum class Symmetry { Auto, Off, X, Y, Z, XY, XZ, YZ, XYZ };
// Whether the caller names the planes.
inline bool isForced(Symmetry symmetry) {
  return symmetry != Symmetry::Auto && symmetry != Symmetry::Off;
}
enum class Repair { Off, Holes, Solid, Wrap, Auto };  // before remeshing
// Whether a lattice makes the surface anew: of the way that was taken, not of Auto.
inline bool isRemade(Repair repair) { return repair == Repair::Solid || repair == Repair::Wrap; }
enum class Sheets { Thicken, Drop };   // what wrap does with open sheets
enum class LodsBy { Shares, Pixels };  // what `lods` says of each level

// The effect of a guide on quads: along which directions they lie beside it, or that it becomes
// sides of quads.
enum class GuideKind { Direction, Loop };

// A line on or near the surface, in the model's world, that quads follow.
struct Guide {
  std::vector<Vec3> points;
  GuideKind kind = GuideKind::Direction;
  bool isClosed = false;  // by a last side from the last point to the first
  std::string name = {};  // for messages
};

// Edges with a larger dihedral angle, in degrees, count as features unless the caller sets another.
inline constexpr double kFeatureAngle = 40;

// Percent options given as lengths instead, in units of the model's world. Each sets the option of
// its name: jobs/parts/part_lengths.h.
struct Lengths {
  std::optional<double> maxError, weld, holesUpTo, gap, dropBelow;
};

struct RemeshOptions {
  std::optional<Index> vertices;     // exact number of distinct positions of the result
  std::optional<Index> faces;        // at most so many triangles, or quads
  std::optional<double> ratio;       // the same as a share of the input's
  std::optional<double> edgeLength;  // the same from a mean edge length
  Scheme scheme = Scheme::Best;
  Prefer prefer = Prefer::Auto;
  Quality quality = Quality::Best;
  Projection projection = Projection::Patches;
  std::optional<Fidelity> fidelity;
  // Wanted of every edge, lengths, and of every triangle's angles, degrees.
  std::optional<double> minEdge, maxEdge, minAngle;
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
  std::vector<Index> region;                          // triangles to remesh; empty: all
  bool quads = false;                                 // pure quads instead of triangles
  std::vector<Guide> guides;                          // of quads: lines that they follow
  bool exact = false;                                 // of quads: exactly so many vertices
  Symmetry symmetry = Symmetry::Auto;
  Textures textures = Textures::Auto;  // for files
  std::optional<Index> textureSize;    // texels along a side
  std::optional<TextureFormat> textureFormat;
  std::optional<double> cage;  // of baking onto a mesh: how far is looked, percent of the diagonal
  bool ao = false;             // ambient occlusion is baked, too
  Repair repair = Repair::Off;
  std::optional<double> holesUpTo;  // the longest loop to be closed, percent of the diagonal
  std::optional<double> gap;  // the widest opening that repair closes, percent of the diagonal
  bool cavities = false;      // of solids, the inner ones: kept, not filled
  Sheets sheets = Sheets::Thicken;
  bool keepRims = false;            // loops that look intended stay open
  std::optional<double> thickness;  // of the bodies that sheets become, a length in the world
  bool base = false;                // open reliefs get upright walls and a flat base
  bool unite = false;               // of files: all meshes become one surface
  std::optional<double> dropBelow;  // smaller pieces are left out, percent of the diagonal
  bool dropFloaters = false;        // so are small pieces away from the rest: dropBelow auto
  bool dropHidden = false;          // so are triangles that nobody sees from outside
  bool conform = false;             // bodies that touch share the triangles of their common face
  std::vector<double> lods;         // of levels of detail, each > 0: shares of the vertices
  LodsBy lodsBy = LodsBy::Shares;   // or how far a level may be off, in pixels of 1080
  bool lodFiles = false;            // a file for each level, not one for all
  Lengths lengths;
};

// Whether a number of vertices is asked for, by itself or by a mean length of edges.
inline bool asksForNumber(const RemeshOptions& options) {
  return options.vertices || options.faces || options.ratio || options.edgeLength;
}

// Whether something is wanted of every edge or triangle.
inline bool wantsOfEach(const RemeshOptions& options) {
  return options.minEdge || options.maxEdge || options.minAngle;
}

// Edges of a finished mesh are about this many times as long as their target at most, or as short.
inline constexpr double kLongestOfSize = 1.3, kShortestOfSize = 0.75;

// Whether the lengths wanted of edges lead to the number of vertices.
inline bool leadsByEdges(const RemeshOptions& options) {
  return (options.minEdge || options.maxEdge) && !asksForNumber(options);
}

// Thins out a scan slab by slab, whatever its size. Slabs that are joined in their order are
// remeshed to the mesh that one run of all of them makes.
struct ScanSlabs {
  Index count = 0;  // 1 to 256; 0: not asked for
  Index only = 0;   // the number of the only slab to make, from 1 on; 0: all
};

}  // namespace remesher
