// SPDX-License-Identifier: MIT
#include "original/patches/patch_atlas.h"

#include <doctest/doctest.h>

#include <limits>
#include <map>

#include "support/soups.h"
#include "support/surfaces.h"

using namespace remesher;
using surfaces::Surface;

namespace {

using Corners = std::array<SurfacePoint, 3>;

double longestEdge(const Surface& surface) {
  double longest = 0;
  for (Index i = 0; i < surface.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Vec3 &a = surface.positions()[surface.mesh().origin(h)],
               &b = surface.positions()[surface.mesh().tip(h)];
    longest = std::max(longest, (b - a).norm());
  }
  return longest;
}

Corners cornersOf(const Surface& surface, Face f) {
  const auto [a, b, c] = surface.mesh().vertices(f);
  return {surface.at(a), surface.at(b), surface.at(c)};
}

// Every triangle of `coarse`, whose vertices are the first of `points`, cut in four with the new
// corners projected onto `fine` through the atlas.
struct Subdivision {
  std::vector<SurfacePoint> points;
  std::vector<Index> triangles;
  std::size_t refused = 0;
};

void subdivide(Subdivision& mesh, PatchAtlas& atlas) {
  std::map<std::pair<Index, Index>, Index> middles;
  std::vector<Index> finer;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::array<Index, 3> corner, middle;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.triangles[t + i];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = corner[i], b = corner[(i + 1) % 3], c = corner[(i + 2) % 3];
      const auto [at, isNew] = middles.insert({std::minmax(a, b), Index(mesh.points.size())});
      middle[i] = at->second;
      if (!isNew) continue;
      const auto point =
          atlas.interpolate({mesh.points[a], mesh.points[b], mesh.points[c]}, Vec3(0.5, 0.5, 0));
      mesh.refused += point ? 0 : 1;
      mesh.points.push_back(point.value_or(mesh.points[a]));
    }
    finer.insert(finer.end(), {corner[0], middle[0], middle[2], corner[1], middle[1], middle[0],
                               corner[2], middle[2], middle[1], middle[0], middle[1], middle[2]});
  }
  mesh.triangles = finer;
}

// The fine vertex nearest to each coarse one.
SurfacePoint nearest(const Surface& fine, const Vec3& p) {
  Vertex best;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < fine.mesh().vertexCapacity(); ++v) {
    const double distance = (fine.positions()[Vertex(v)] - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = Vertex(v);
  }
  return fine.at(best);
}

// Triangles that point away from `outward` at their centroid, after two subdivisions.
template <class Outward>
int foldedAfterSubdivision(const Surface& fine, const Surface& coarse, Outward outward) {
  PatchAtlas atlas(fine.mesh(), fine.positions(), 1.5 * longestEdge(coarse));
  Subdivision mesh;
  mesh.triangles = coarse.mesh().triangles();
  for (Index v = 0; v < coarse.mesh().vertexCapacity(); ++v)
    mesh.points.push_back(nearest(fine, coarse.positions()[Vertex(v)]));
  subdivide(mesh, atlas);
  subdivide(mesh, atlas);
  CHECK(mesh.refused == 0);
  int folded = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const Vec3 a = fine.position(mesh.points[mesh.triangles[t]]),
               b = fine.position(mesh.points[mesh.triangles[t + 1]]),
               c = fine.position(mesh.points[mesh.triangles[t + 2]]);
    folded += areaVector(a, b, c).dot(outward(Vec3((a + b + c) / 3))) > 0 ? 0 : 1;
  }
  return folded;
}

}  // namespace

TEST_CASE("patch_atlas: three equal corners give their own point, on every face") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    PatchAtlas atlas(surface.mesh(), surface.positions(), 0.5);
    for (Index f = 0; f < surface.mesh().faceCapacity(); ++f) {
      const SurfacePoint corner{Face(f), Vec3(0.2, 0.5, 0.3)};
      const auto point = atlas.interpolate({corner, corner, corner}, Vec3(0.25, 0.25, 0.5));
      REQUIRE(point);
      CHECK((surface.position(*point) - surface.position(corner)).norm() < 1e-9);
    }
  }
}

TEST_CASE("patch_atlas: all weight on one corner gives that corner") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    PatchAtlas atlas(surface.mesh(), surface.positions(), longestEdge(surface));
    for (Index f = 0; f < surface.mesh().faceCapacity(); ++f) {
      const Corners corners = cornersOf(surface, Face(f));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto point = atlas.interpolate(corners, Vec3::Unit(Eigen::Index(i)));
        REQUIRE(point);
        CHECK((surface.position(*point) - surface.position(corners[i])).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("patch_atlas: inside a face of the original nothing moves") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    PatchAtlas atlas(surface.mesh(), surface.positions(), longestEdge(surface));
    soups::Random random(3);
    for (Index f = 0; f < surface.mesh().faceCapacity(); ++f) {
      const Vec3 raw = random.point() + Vec3::Constant(1e-3), weights = raw / raw.sum();
      const SurfacePoint flat{Face(f), weights};
      const auto point = atlas.interpolate(
          {SurfacePoint{Face(f), Vec3::Unit(0)}, SurfacePoint{Face(f), Vec3::Unit(1)},
           SurfacePoint{Face(f), Vec3::Unit(2)}},
          weights);
      REQUIRE(point);
      CHECK((surface.position(*point) - surface.position(flat)).norm() < 1e-9);
    }
  }
}

TEST_CASE("patch_atlas: two subdivisions through the patches fold no triangle") {
  const auto radial = [](const Vec3& p) { return p; };
  const auto fromTube = [](const Vec3& p) {
    return Vec3(p - 2 * Vec3(p.x(), p.y(), 0).normalized());
  };
  // The original finer than, as fine as, and coarser than what is laid over it.
  for (const int n : {24, 12, 5}) {
    CAPTURE(n);
    CHECK(foldedAfterSubdivision(surfaces::surface("", shapes::icosphere(n)),
                                 surfaces::surface("", shapes::icosphere(5)), radial) == 0);
    CHECK(foldedAfterSubdivision(surfaces::surface("", shapes::torus(4 * n, 2 * n)),
                                 surfaces::surface("", shapes::torus(20, 10)), fromTube) == 0);
  }
}

TEST_CASE("patch_atlas: large triangles over a fine original are served by patches on demand") {
  const Surface fine = surfaces::surface("", shapes::icosphere(24));
  const Surface coarse = surfaces::surface("", shapes::icosphere(3));
  PatchAtlas atlas(fine.mesh(), fine.positions(), 0.01);  // a margin much too small
  for (Index f = 0; f < coarse.mesh().faceCapacity(); ++f) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = nearest(fine, coarse.positions()[coarse.mesh().vertices(Face(f))[i]]);
    const auto point = atlas.interpolate(corners, Vec3::Constant(1.0 / 3));
    REQUIRE(point);
    // The middle of a spherical triangle, or near it: a third of its side (0.42) is far away.
    const Vec3 middle =
        (fine.position(corners[0]) + fine.position(corners[1]) + fine.position(corners[2])) / 3;
    CHECK((fine.position(*point).normalized() - middle.normalized()).norm() < 0.05);
  }
}

TEST_CASE("patch_atlas: never answers across a barrier") {
  const Surface plane = surfaces::surface("", shapes::grid(20, 20));
  const auto barriers = barriersBetween(plane, [](const Vec3& p) { return p.y() == 10; });
  PatchAtlas atlas(plane.mesh(), plane.positions(), 5, barriers);
  soups::Random random(5);
  const auto sideOf = [&](const SurfacePoint& p) {
    return plane.position({p.face, Vec3::Constant(1.0 / 3)}).y() > 10;
  };
  const auto any = [&] {
    const double faces = double(plane.mesh().faceCapacity());
    return SurfacePoint{Face(Index(faces * random.number())), Vec3(0.3, 0.3, 0.4)};
  };
  int answered = 0;
  for (int i = 0; i < 3000; ++i) {
    const Corners corners = {any(), any(), any()};
    const auto point = atlas.interpolate(corners, Vec3(0.4, 0.3, 0.3));
    if (!point) continue;
    ++answered;
    for (const SurfacePoint& corner : corners) CHECK(sideOf(corner) == sideOf(*point));
  }
  CHECK(answered > 0);
}

TEST_CASE("patch_atlas: corners on different components have nothing between them") {
  const Surface two = surfaces::surface("", shapes::twoComponents());
  PatchAtlas atlas(two.mesh(), two.positions(), 10);
  const SurfacePoint here{Face(0), Vec3(0.2, 0.3, 0.5)}, there{Face(7), Vec3(0.2, 0.3, 0.5)};
  CHECK_FALSE(atlas.interpolate({here, here, there}, Vec3(0.4, 0.4, 0.2)));
}

TEST_CASE("patch_atlas: the order in which patches are asked for changes nothing") {
  const Surface torus = surfaces::surface("", shapes::torus(24, 12));
  PatchAtlas forward(torus.mesh(), torus.positions(), 0.6);
  PatchAtlas backward(torus.mesh(), torus.positions(), 0.6);
  const Index n = Index(torus.mesh().faceCapacity());
  std::vector<SurfacePoint> first(n);
  for (Index f = 0; f < n; ++f)
    first[f] = *forward.interpolate(cornersOf(torus, Face(f)), Vec3(0.5, 0.3, 0.2));
  for (Index f = n; f-- > 0;) {
    const auto point = backward.interpolate(cornersOf(torus, Face(f)), Vec3(0.5, 0.3, 0.2));
    CHECK(point->face == first[f].face);
    CHECK(point->barycentric == first[f].barycentric);
  }
}
