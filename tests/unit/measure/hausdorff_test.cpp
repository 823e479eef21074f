// SPDX-License-Identifier: MIT
#include "measure/hausdorff.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/place.h"
#include "support/soups.h"

using namespace remesher;
using doctest::Approx;

namespace {

DeviationBothWays proven(const TriangleMesh& original, const TriangleMesh& result) {
  return measureDeviation(original, result, Maximum::Proven);
}

}  // namespace

TEST_CASE("hausdorff: a surface is no distance from itself, however it is cut") {
  const auto check = [](const TriangleMesh& a, const TriangleMesh& b) {
    for (const Maximum maximum : {Maximum::Glimpsed, Maximum::Sampled, Maximum::Proven}) {
      const FidelityReport report = measureFidelity(a, b, maximum);
      CHECK(report.hausdorff < 1e-10);
      CHECK(report.rms < 1e-10);
    }
  };
  check(soups::sphere(6), soups::sphere(6));
  check(soups::square(3), soups::square(7));
  check(soups::cube(0, 1), soups::cube(0, 1));
}

TEST_CASE("hausdorff: parallel squares are everywhere as far apart as their planes") {
  const DeviationBothWays d =
      proven(soups::square(3), soups::moved(soups::square(5), {0, 0, 0.25}));
  CHECK(d.diagonal == Approx(std::sqrt(2)));
  for (const Deviation& way : {d.toResult, d.toOriginal}) {
    CHECK(way.maximum == Approx(0.25).epsilon(1e-12));
    CHECK(way.rms == Approx(0.25).epsilon(1e-12));
  }
}

TEST_CASE("hausdorff: a triangle that is there many times counts once") {
  const TriangleMesh sphere = soups::sphere(6), cube = soups::cube(-1, 1);
  TriangleMesh copies = cube;
  for (Index copy = 0; copy < 1000; ++copy) {
    const Index turn = copy % 3;
    for (Index k = 0; k < 3; ++k) copies.indices.push_back(cube.indices[(k + turn) % 3]);
  }
  const DeviationBothWays once = proven(cube, sphere), often = proven(copies, sphere);
  CHECK(often.toResult.maximum == once.toResult.maximum);
  CHECK(often.toResult.rms == once.toResult.rms);
  CHECK(often.toOriginal.maximum == once.toOriginal.maximum);
  CHECK(often.toOriginal.rms == once.toOriginal.rms);
}

TEST_CASE("hausdorff: a tree at hand changes no distance") {
  const TriangleMesh sphere = soups::sphere(6), cube = soups::cube(-1, 1);
  const DeviationBothWays expected = proven(sphere, cube);
  for (const auto listed : {TriangleTree::Listed::Anyhow, TriangleTree::Listed::SideBySide}) {
    const DeviationBothWays d = measureDeviation(
        sphere, cube, Maximum::Proven, ListedTree(sphere.positions, sphere.indices, listed));
    CHECK(d.diagonal == expected.diagonal);
    CHECK(d.toResult.maximum == Approx(expected.toResult.maximum).epsilon(2e-3));
    CHECK(d.toOriginal.maximum == Approx(expected.toOriginal.maximum).epsilon(2e-3));
    CHECK(d.toResult.rms == Approx(expected.toResult.rms).epsilon(2e-2));
    CHECK(d.toOriginal.rms == expected.toOriginal.rms);
  }
}

TEST_CASE("hausdorff: a cube around a cube is farthest at its corners") {
  const TriangleMesh inner = soups::cube(0, 1), outer = soups::cube(-0.1, 1.1);
  const DeviationBothWays d = proven(inner, outer);
  CHECK(d.toResult.maximum == Approx(0.1));
  CHECK(d.toOriginal.maximum == Approx(0.1 * std::sqrt(3)));
  CHECK(measureFidelity(inner, outer).hausdorff == Approx(10));  // of the diagonal, √3
}

TEST_CASE("hausdorff: the root mean square over a pyramid is its height over √6") {
  // The height over the base is linear on each face, with values 0, 0, h at the corners: the mean
  // of its square over a triangle is h²/6.
  const double h = 0.01;
  TriangleMesh pyramid;
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), top(0.5, 0.5, h);
  soups::addTriangle(pyramid, a, b, top);
  soups::addTriangle(pyramid, b, c, top);
  soups::addTriangle(pyramid, c, d, top);
  soups::addTriangle(pyramid, d, a, top);
  const Deviation way = proven(soups::square(1), pyramid).toOriginal;
  CHECK(way.maximum == Approx(h).epsilon(1e-12));
  CHECK(way.rms == Approx(h / std::sqrt(6)).epsilon(0.01));
}

TEST_CASE("hausdorff: a hole too small for any sample to fall into is found") {
  // The middle of a hole of width w is farthest, off the middle of the square by 0.13 each way, so
  // that nothing halves into it.
  const double w = 0.004, low = 0.63 - w / 2, high = 0.63 + w / 2;
  TriangleMesh frame;
  soups::addQuad(frame, {{0, 0, 0}, {1, 0, 0}, {1, low, 0}, {0, low, 0}});
  soups::addQuad(frame, {{0, high, 0}, {1, high, 0}, {1, 1, 0}, {0, 1, 0}});
  soups::addQuad(frame, {{0, low, 0}, {low, low, 0}, {low, high, 0}, {0, high, 0}});
  soups::addQuad(frame, {{high, low, 0}, {1, low, 0}, {1, high, 0}, {high, high, 0}});
  const Deviation way = proven(soups::square(1), frame).toResult;
  CHECK(way.maximum <= w / 2 + 1e-15);
  CHECK(way.maximum >= w / 2 * 0.998 - 2e-5);
}

TEST_CASE("hausdorff: flat triangles are as far from a sphere as their planes cut into it") {
  // Deepest in the middle of a triangle: the radius less the distance of its plane from the centre.
  const TriangleMesh coarse = soups::sphere(2), fine = soups::sphere(14);
  double deepest = 0;
  for (std::size_t t = 0; t < coarse.indices.size(); t += 3) {
    const Vec3 a = coarse.positions[t], b = coarse.positions[t + 1], c = coarse.positions[t + 2];
    deepest = std::max(deepest, 1 - std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  CHECK(proven(fine, coarse).toResult.maximum == Approx(deepest).epsilon(0.005));
}

TEST_CASE("hausdorff: what is sampled is found, and little less than what is proven") {
  const TriangleMesh a = soups::sphere(7), b = soups::sphere(16);
  const double sampled = measureFidelity(a, b, Maximum::Sampled).hausdorff;
  const double bound = measureFidelity(a, b, Maximum::Proven).hausdorff;
  CHECK(sampled <= bound);
  CHECK(sampled >= 0.98 * bound);
  const FidelityReport glimpsed = measureFidelity(a, b, Maximum::Glimpsed);
  CHECK(glimpsed.hausdorff <= sampled);
  CHECK(glimpsed.hausdorff >= 0.9 * sampled);
}

TEST_CASE("hausdorff: a glimpse sees what the result lacks, not what juts out of it") {
  TriangleMesh fin = soups::square(5);
  soups::addTriangle(fin, {0.2, 0.2, 0}, {0.8, 0.8, 0}, {0.5, 0.5, 1});
  CHECK(measureFidelity(fin, soups::square(5), Maximum::Glimpsed).hausdorff > 30);
  CHECK(measureFidelity(soups::square(5), fin, Maximum::Glimpsed).hausdorff < 1e-10);
  CHECK(measureFidelity(soups::square(5), fin, Maximum::Sampled).hausdorff > 30);
}

TEST_CASE("hausdorff: a glimpse sees a lost tip, however small its area is") {
  TriangleMesh spiked = soups::sphere(40);
  const std::vector<Index> first = weld(spiked.positions);
  for (Index& v : spiked.indices) v = first[v];
  spiked.positions[first[7]] *= 1.05;
  const double exact = measureFidelity(spiked, soups::sphere(40), Maximum::Proven).hausdorff;
  CHECK(measureFidelity(spiked, soups::sphere(40), Maximum::Glimpsed).hausdorff ==
        Approx(exact).epsilon(0.01));
}

TEST_CASE("hausdorff: fewer points change the root mean square by no more than a few percent") {
  for (const int n : {6, 9, 24}) {
    const TriangleMesh a = soups::sphere(n), b = soups::sphere(16);
    const double exact = measureFidelity(a, b, Maximum::Proven).rms;
    CHECK(measureFidelity(a, b, Maximum::Sampled).rms == Approx(exact).epsilon(0.02));
    CHECK(measureFidelity(a, b, Maximum::Glimpsed).rms == Approx(exact).epsilon(0.04));
  }
}

TEST_CASE("hausdorff: border edges that cut the bends of a small hole are seen") {
  constexpr int kOuter = 64;
  constexpr double kHole = 0.05;
  const auto around = [](double radius, double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  // Between a circle of 64 edges and a hole of fewer, all of them chords of a circle.
  const auto ring = [&](int inner) {
    TriangleMesh mesh;
    const int each = kOuter / inner;
    for (int i = 0; i < inner; ++i) {
      const Vec3 a = around(kHole, double(i) / inner), b = around(kHole, double(i + 1) / inner);
      const auto outer = [&](int k) { return around(1, double(i * each + k) / kOuter); };
      for (int k = 0; k < each; ++k) soups::addTriangle(mesh, a, outer(k), outer(k + 1));
      soups::addTriangle(mesh, a, outer(each), b);
    }
    return mesh;
  };
  const double exact =
      kHole * (std::cos(std::numbers::pi / kOuter) - std::cos(std::numbers::pi / 8));
  const double found = measureFidelity(ring(kOuter), ring(8), Maximum::Sampled).hausdorff;
  CHECK(found == Approx(100 * exact / (2 * std::sqrt(2))).epsilon(0.05));
}
