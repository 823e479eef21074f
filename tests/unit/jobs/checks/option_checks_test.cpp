// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include <doctest/doctest.h>

#include <functional>
#include <vector>

#include "base/error.h"

using namespace remesher;

namespace {

using Setting = std::function<void(RemeshOptions&)>;

// The options that exclude each other of an option and others, one by one.
void checkExcludes(const Setting& set, const std::vector<Setting>& others) {
  for (const Setting& setOther : others) {
    RemeshOptions options;
    set(options);
    CHECK_NOTHROW(checkTogether(options));
    setOther(options);
    CHECK_THROWS_AS(checkTogether(options), Error);
    options = {};
    setOther(options);
    CHECK_NOTHROW(checkTogether(options));
  }
}

void setDensity(RemeshOptions& o) { o.density = {1, 2, 3}; }
void setEdges(RemeshOptions& o) { o.featureEdges = {{0, 1}}; }
void setQuads(RemeshOptions& o) { o.quads = true; }
void setLevels(RemeshOptions& o) { o.lods = {0.5}; }
void setShape(RemeshOptions& o) { o.prefer = Prefer::Shape; }

}  // namespace

TEST_CASE("option checks: options that name vertices exclude steps that make or remove some") {
  checkExcludes([](RemeshOptions& o) { o.repair = Repair::Holes; }, {setDensity, setEdges});
  checkExcludes([](RemeshOptions& o) { o.dropBelow = 1; }, {setDensity, setEdges});
  checkExcludes([](RemeshOptions& o) { o.dropFloaters = true; }, {setDensity, setEdges});
  checkExcludes([](RemeshOptions& o) { o.dropHidden = true; }, {setDensity, setEdges});
}

TEST_CASE("option checks: a region excludes whatever changes more than its triangles") {
  checkExcludes([](RemeshOptions& o) { o.region = {0}; },
                {setQuads, setLevels, [](RemeshOptions& o) { o.weld = 1; },
                 [](RemeshOptions& o) { o.lengths.weld = 1; },
                 [](RemeshOptions& o) { o.repair = Repair::Auto; },
                 [](RemeshOptions& o) { o.textures = Textures::Bake; }});
}

TEST_CASE("option checks: common faces exclude other meshes than isotropic triangles") {
  checkExcludes([](RemeshOptions& o) { o.conform = true; },
                {setQuads, setLevels, setShape, setDensity,
                 [](RemeshOptions& o) { o.textures = Textures::Keep; },
                 [](RemeshOptions& o) { o.boundary = Boundary::Keep; },
                 [](RemeshOptions& o) { o.scheme = Scheme::Rounds; }});
}

TEST_CASE("option checks: limits of every edge exclude other meshes than isotropic triangles") {
  checkExcludes([](RemeshOptions& o) { o.minEdge = 1; }, {setQuads, setLevels, setShape});
}

TEST_CASE("option checks: the sentence names both options") {
  RemeshOptions options;
  options.conform = options.quads = true;
  CHECK_THROWS_WITH_AS(checkTogether(options),
                       "conform and quads exclude each other: closed bodies are remeshed together, "
                       "as isotropic triangles of one level without textures.",
                       Error);
}
