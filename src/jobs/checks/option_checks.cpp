// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "jobs/checks/wanted_check.h"

namespace remesher {

namespace {

// An option with the values that are meant.
struct Given {
  const char* name;
  bool isGiven;
};

// A row of the column `excludes` of the package's table of options.
struct Exclusion {
  Given option;
  std::vector<Given> others;
  const char* why;
};

constexpr const char* kNumbers =
    "density and featureEdges number the input's vertices, of which some are left out";

std::vector<Exclusion> exclusionsIn(const RemeshOptions& o) {
  const Given repair = {"repair", o.repair != Repair::Off}, quads = {"quads", o.quads},
              shape = {"prefer: shape", o.prefer == Prefer::Shape},
              rounds = {"scheme: rounds", o.scheme == Scheme::Rounds},
              splitObtuse = {"splitObtuse", o.splitObtuse}, lods = {"lods", !o.lods.empty()},
              density = {"density", !o.density.empty()},
              featureEdges = {"featureEdges", !o.featureEdges.empty()},
              region = {"region", !o.region.empty()},
              keptBorders = {"boundary: keep", o.boundary == Boundary::Keep},
              keptTextures = {"textures: keep", o.textures == Textures::Keep},
              bakedTextures = {"textures: bake", o.textures == Textures::Bake},
              weld = {"weld", o.weld || o.lengths.weld}, unite = {"unite", o.unite},
              dropBelow = {"dropBelow", o.dropBelow || o.dropFloaters},
              dropHidden = {"dropHidden", o.dropHidden};
  return {
      {repair,
       {density, featureEdges},
       "density and featureEdges number the input's vertices, and repair makes others"},
      {{"conform", o.conform},
       {repair, quads, shape, rounds, splitObtuse, keptBorders, keptTextures, bakedTextures, unite,
        lods, dropHidden, density, featureEdges, region},
       "closed bodies are remeshed together, as isotropic triangles of one level without textures"},
      {region,
       {quads, repair, weld, bakedTextures, lods, dropBelow, dropHidden, unite},
       "outside the region everything stays bit for bit"},
      {dropBelow, {density, featureEdges}, kNumbers},
      {dropHidden, {density, featureEdges}, kNumbers},
      {{"a limit of every edge or angle", wantsOfEach(o)},
       {quads, rounds, shape, splitObtuse, lods},
       "minEdge, maxEdge and minAngle are wanted of isotropic triangles of the scheme best"},
  };
}

}  // namespace

void checkTogether(const RemeshOptions& options) {
  for (const auto& [option, others, why] : exclusionsIn(options))
    for (const Given& other : others)
      if (option.isGiven && other.isGiven)
        throw Error(
            ErrorCode::InvalidOption,
            std::string(option.name) + " and " + other.name + " exclude each other: " + why + ".",
            "Leave out one of them.");
  checkWanted(options);
}

}  // namespace remesher
