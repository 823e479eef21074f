// SPDX-License-Identifier: MIT
// The report of a run or an inspection; the names are those of the JSON report.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/options.h"
#include "base/types.h"

namespace remesher {

// Something the caller should know but need not act on. `code` is stable, `message` is for people.
// base/diagnostics.h lists the codes.
struct Warning {
  std::string code;
  std::string message;
  std::size_t count = 1;
  std::optional<Vec3> at = {};  // the place of the first or the worst, in the world of the file
};

// Angles in degrees; histogram in percent of the triangles, by minimum angle 0–10, 10–20, … 50–60.
struct AngleStatistics {
  double worst = 0;
  double mean = 0;
  std::array<double, 6> histogram{};
};

// A connected part whose quads are pairs of triangles, divided, with more irregular vertices.
struct PairedPart {
  Vec3 at = Vec3::Zero();  // one of its vertices
  std::size_t quads = 0;
};

// Figures of a mesh of quads. irregular: interior vertices whose valence is not 4. angleDeviation:
// |angle − 90°| over all corners. scaledJacobian: of each quad's worst corner, 1 in a square,
// negative in a fold. edgeVariation: standard deviation of the edge lengths over their mean.
// symmetry: planes about which the quads were made their own mirror images, in all parts together.
// parts: connected ones; paired: those of them for which no map to squares was found.
struct QuadReport {
  struct Deviation {
    double mean = 0, p95 = 0, worst = 0;
  };
  struct Jacobian {
    double min = 0, mean = 0;
  };
  // Loops go from each quad to the one across the opposite side, until they close or come to a
  // boundary. longest: percent of all edges that one loop crosses; selfCrossing: percent of the
  // quads in which a loop crosses itself.
  struct Loops {
    std::size_t count = 0;
    double longest = 0, selfCrossing = 0;
  };
  std::size_t count = 0;
  std::size_t irregular = 0;
  Deviation angleDeviation;
  Jacobian scaledJacobian;
  double edgeVariation = 0;
  std::size_t symmetry = 0;
  Loops loops;
  std::size_t parts = 0;
  std::vector<PairedPart> paired = {};
};

// What came of a limit that was wanted of every edge or triangle: lengths in the world's units,
// angles in degrees.
struct WantedFigure {
  double asked = 0, worst = 0;
  std::size_t missed = 0;       // edges or triangles
  double kept = 100;            // percent of the edges or triangles
  std::optional<Vec3> at = {};  // the place of the worst, if any missed it
};

struct WantedReport {
  std::optional<WantedFigure> minEdge, maxEdge, minAngle;
};

struct MeshReport {
  std::size_t vertices = 0;  // distinct positions
  std::size_t triangles = 0;
  std::size_t components = 0;
  std::size_t boundaryEdges = 0;
  std::size_t nonManifoldEdges = 0;
  long eulerCharacteristic = 0;
  std::size_t degenerateTriangles = 0;
  AngleStatistics minAngle;
  double maxAngle = 0;                 // the largest angle of any triangle
  double valence6 = 0;                 // percent of the interior vertices
  std::optional<QuadReport> quads;     // only for a mesh of quads
  std::optional<WantedReport> wanted;  // only of a result of which something was wanted
  double diagonal = 0;                 // of the box in the world; of what goes in only
};

// Two-sided distance between the result and the original, percent of the original's diagonal.
struct FidelityReport {
  double hausdorff = 0;
  double rms = 0;
};

// When a level of detail takes over: once its largest distance is seen as a pixel of 1080, by the
// disk around the model. coverage: the disk's share of a screen of 1920 × 1080; distance: the
// camera's from the model, at an angle of view of 50 degrees.
struct SwitchReport {
  double coverage = 1;
  double distance = 0;
};

enum class Stopped { Target, Fidelity, MaxError };

struct Phase {
  std::string name;
  double milliseconds = 0;
};

struct Timings {  // milliseconds
  double read = 0;
  double build = 0;
  double remesh = 0;
  double write = 0;
};

// A loop or a piece: its middle, and twice the largest distance from there, in model units.
struct SizedPlace {
  Vec3 at = Vec3::Zero();
  double across = 0;
};

// The most places that a report lists of a kind, the widest first.
inline constexpr std::size_t kMostSizedPlaces = 10;

// The outcome of a repair. For files of several parts: sums, and the mode that mended most
// triangles.
struct RepairReport {
  std::string mode;
  std::string reason;                        // why that one: asked, sound, shells, enclosed, open
  std::size_t holes = 0;                     // open loops closed
  std::size_t islands = 0;                   // open pieces removed
  std::size_t shells = 0;                    // bodies inside other bodies, removed
  std::size_t turned = 0;                    // triangles turned over
  std::size_t rims = 0;                      // open loops that look intended, left open
  std::size_t bodies = 0;                    // sheets that became bodies: thickened, or with a base
  std::vector<SizedPlace> closedAt, rimsAt;  // some of the loops closed, and of those rims
  double lost = 0;           // percent of the area that the result lacks: seen and farther than:
  double lostBeyond = 0;     // percent of the diagonal
  std::vector<Vec3> lostAt;  // a few places of it, apart from each other, the farthest first
  std::array<std::size_t, 2> selfIntersections{};  // triangles that meet others, before and after
};

// Where it is broken: per open loop one place, in the order of their lengths; of triangles that
// meet others the first of each mesh; per piece one place.
struct FaultPlaces {
  std::vector<Vec3> openLoops, selfIntersections, innerShells, insideOut;
};

// The time and memory of a repair, known before it begins. Approximate.
struct RepairNeeds {
  double bytes = 0;
  double seconds = 0;  // of one core, in WebAssembly
};

// The faults of a mesh, and the repair that would mend them.
struct FaultReport {
  std::vector<double> openLoops;      // lengths in percent of the diagonal, the longest first
  std::size_t selfIntersections = 0;  // triangles that meet others
  std::size_t innerShells = 0;        // closed pieces inside others, cavities not counted
  std::size_t insideOut = 0;          // pieces that face inwards, open ones once closed
  Repair repair = Repair::Off;        // Off: nothing is broken, or only sheets are there
  RepairNeeds needs;                  // of that repair
  FaultPlaces places;
};

// The edges of a mesh by kind, as pairs of its vertices; of vertices at one place the first.
struct EdgeReport {
  std::vector<Index> boundary;     // of one triangle
  std::vector<Index> nonManifold;  // of more than two
  std::vector<Index> flipped;      // of two that face opposite ways
  std::vector<Index> bent;         // of two that bend there by 5 degrees or more, sharpest first
  std::vector<double> bends;       // of each of these, in degrees
  std::vector<Index> first;        // per vertex the first at its place
};

// Pieces and triangles that were left out on request.
struct DropReport {
  std::size_t pieces = 0;            // smaller than asked for
  std::size_t hidden = 0;            // triangles that nobody sees
  double lost = 0;                   // percent of the area, both together
  std::vector<SizedPlace> piecesAt;  // some of the pieces
  std::vector<Vec3> hiddenAt;        // a corner of some of the triangles
};

// Faces that closed bodies have in common.
struct ConformReport {
  std::size_t faces = 0;      // connected, of two bodies each
  std::size_t triangles = 0;  // of these faces, each once
  double area = 0;            // in the world
};

// Texture coordinates, and the maps that were painted for them.
struct AtlasReport {
  Index size = 0;          // texels along a side
  std::size_t charts = 0;  // pieces that no texture coordinates connect
  bool isGiven = false;    // the mesh's own texture coordinates
  double coverage = 0;     // percent of the square
  double stretch = 0;  // the root mean square of lengths on the surface per length in the square
  double worstStretch = 0;  // the largest; both relative to an even map
  double notFound = 0;      // percent of the texels for which nothing to paint was found
  double cage = 0;          // how far it was looked for, percent of the diagonal; 0: nowhere
};

// The row of the chooser that took the resulting mesh; src/README.md lists the rows.
struct Chosen {
  std::string rule;
  std::string reason;  // a sentence

  bool operator==(const Chosen&) const = default;
};

struct Report {
  MeshReport input;
  std::optional<MeshReport> output;  // none after an inspection
  std::optional<FidelityReport> fidelity;
  std::optional<RepairReport> repair;    // only if requested
  std::optional<DropReport> dropped;     // likewise
  std::optional<ConformReport> conform;  // if bodies were to share faces
  std::optional<AtlasReport> atlas;      // of baking onto a mesh, and of unwrapping
  Timings timings;
  std::vector<Phase> phases;  // in order; together they make up the run
  std::uint64_t peakBytes = 0;
  std::vector<Warning> warnings;
  Stopped stopped = Stopped::Target;
  std::vector<Prefer> prefer;  // what each part is made of: Even or Shape; none after an inspection
  std::vector<Chosen> chosen;  // why each part is the mesh that it is; none after an inspection
  std::optional<SwitchReport> takesOver;  // only of a coarser level of detail
  std::vector<Report> lods;               // of the coarser levels of detail, in the order requested
};

}  // namespace remesher
