// SPDX-License-Identifier: MIT
#include "remesh/schemes/chart_needs.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "remesh/schemes/remesh.h"
#include "support/painted.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

constexpr float kMiddle = 2;

double mostNeeded(const TriangleMesh& mesh) {
  double most = 0;
  for (const ChartNeed& need : chartNeeds(mesh, {})) most = std::max(most, need.vertices);
  return most;
}

// Whether anything of the sheet remeshed shows its middle.
bool showsMiddle(const TriangleMesh& sheet, double vertices) {
  PartOptions options;
  options.vertices = Index(vertices);
  const RemeshOutcome outcome = remeshSurface(sheet, options, {});
  const std::vector<float>& uv = outcome.mesh.attributes.front().values;
  for (std::size_t i = 0; i < uv.size(); i += 2)
    if (uv[i] == kMiddle) return true;
  return false;
}

}  // namespace

TEST_CASE("chart_needs: with so many vertices a chart stays, with fewer it is lost") {
  const TriangleMesh sheet = shapes::paintedSheet(9, kMiddle);
  const double need = mostNeeded(sheet);
  CHECK(showsMiddle(sheet, need + 1));
  CHECK_FALSE(showsMiddle(sheet, 0.9 * need));
}

TEST_CASE("chart_needs: a chart is as wide as twice its area by its border") {
  std::vector<ChartNeed> needs = chartNeeds(shapes::paintedSheet(9, kMiddle), {});
  REQUIRE(needs.size() == 2);
  std::sort(needs.begin(), needs.end(),
            [](const ChartNeed& a, const ChartNeed& b) { return a.width < b.width; });
  CHECK(needs[0].width == doctest::Approx(2.0 * 1 / 4));
  CHECK(needs[1].width == doctest::Approx(2.0 * 80 / 40));
  CHECK(needs[0].vertices == doctest::Approx(64 * needs[1].vertices));
}

TEST_CASE("chart_needs: what shows the same on both sides, or has no texture, needs nothing") {
  CHECK(chartNeeds(shapes::paintedSheet(9, 0.3F), {}).empty());
  CHECK(chartNeeds(shapes::torus(24, 16), {}).empty());
  TriangleMesh shaded = shapes::paintedSheet(9, kMiddle);
  shaded.attributes.front().semantic = "TARGET_0/NORMAL";
  CHECK(chartNeeds(shaded, {}).empty());
}
