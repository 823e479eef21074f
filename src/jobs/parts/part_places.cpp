// SPDX-License-Identifier: MIT
#include "jobs/parts/part_places.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/model/bake.h"
#include "measure/facing.h"

namespace remesher {
namespace {

// A ratio of stretches below this changes angles by less than a hundredth of a degree.
constexpr double kEven = 1 + 1e-4;
// A part shown with a ratio of stretches below this has no shape to work on.
constexpr double kFlat = 1e-3;
// Of places that show the same area up to rounding, the first counts.
constexpr double kMore = 1 + 1e-9;

// The approximate area of the triangles at the place: exact if all face one way, or if all
// directions are stretched alike. Fast, because a part may have thousands of places.
double shownArea(const Facing& faces, const Transform& place) {
  const Eigen::Matrix3d m = place.linear();
  Eigen::Matrix3d cofactors;
  cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
  const double squared = (cofactors * faces.moments * cofactors.transpose()).trace();
  return std::sqrt(std::max(0.0, squared * faces.area));
}

// The directions of stretch (eigenvectors of LᵀL) and their factors; the axes if they are such
// directions.
std::pair<Eigen::Matrix3d, Vec3> stretchesOf(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d squares = linear.transpose() * linear;
  constexpr double kNoStretch = 1e-12;
  const Vec3 diagonal = squares.diagonal();
  const Eigen::Matrix3d others = squares - Eigen::Matrix3d(diagonal.asDiagonal());
  const double least = diagonal.minCoeff();
  if (others.cwiseAbs().maxCoeff() <= kNoStretch * least)
    return {Eigen::Matrix3d::Identity(), diagonal.cwiseMax(0).cwiseSqrt()};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  return {solver.eigenvectors(), solver.eigenvalues().cwiseMax(0).cwiseSqrt()};
}

// See PartPlace; 1 if the part has no shape at the place.
double lengthsElsewhere(const io::Part& part, const Transform& place) {
  const double size = place.linear().cwiseAbs().maxCoeff();
  const Vec3 stretches = stretchesOf(place.linear() / size).second;
  if (!(stretches.minCoeff() >= kFlat * stretches.maxCoeff())) return 1;
  const Eigen::Matrix3d back = (place.linear() / size).inverse();
  double most = 1;
  for (const Transform& other : part.instances) {
    const Eigen::Matrix3d way = other.linear() / size * back;
    if (way.squaredNorm() > most * most) most = std::max(most, stretchesOf(way).second.maxCoeff());
  }
  return most > kEven && std::isfinite(most) ? most : 1;
}

// The place with the largest area, and the mean area of all places that show any.
PartPlace placeOf(const io::Part& part, const Facing& faces) {
  PartPlace best;
  double most = 0;
  std::size_t count = 0;
  for (const Transform& place : part.instances) {
    const double area = shownArea(faces, place);
    if (!(area > 0)) continue;
    best.area += area;
    ++count;
    if (area <= most * kMore) continue;
    most = area;
    best.toWorld = place;
  }
  if (count > 0) best.area /= double(count);
  if (count > 1) best.elsewhere = lengthsElsewhere(part, best.toWorld);
  return best;
}

using Coordinates = std::array<double, 3>;
Coordinates coordinatesOf(const Vec3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }

}  // namespace

Transform firstPlace(const io::Part& part) {
  return part.instances.empty() ? Transform::Identity() : part.instances.front();
}

Vec3 inWorldOf(const io::Part& part, const Vec3& p) { return firstPlace(part) * p; }

Transform largestPlace(const io::Part& part) {
  const auto isOutside = [&](Index v) { return v >= part.mesh.positions.size(); };
  if (part.instances.size() < 2 ||
      std::any_of(part.mesh.indices.begin(), part.mesh.indices.end(), isOutside))
    return firstPlace(part);
  const PartPlace place = placeOf(part, facingOf(part.mesh, Moments::All));
  return place.area > 0 ? place.toWorld : firstPlace(part);
}

double longestOf(const io::Part& part) {
  double longest = part.instances.empty() ? 1 : 0;
  for (const Transform& place : part.instances) {
    const double even = std::cbrt(std::abs(place.linear().determinant()));
    const bool isEven = !stretchAt(place) && even > 0;
    longest = std::max(longest, isEven ? even : stretchesOf(place.linear()).second.maxCoeff());
  }
  return longest;
}

std::vector<PartPlace> placesOf(const std::vector<io::Part>& parts) {
  std::vector<PartPlace> places;
  std::vector<double> own;
  double shown = 0, bare = 0;
  for (const io::Part& part : parts) {
    const Facing faces = facingOf(part.mesh, part.instances.empty() ? Moments::None : Moments::All);
    places.push_back(placeOf(part, faces));
    own.push_back(faces.area);
    if (places.back().area > 0) {
      shown += places.back().area;
      bare += faces.area;
    }
  }
  const double ratio = bare > 0 && shown > 0 ? shown / bare : 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (places[i].area > 0) continue;
    places[i].toWorld = Transform(Eigen::Scaling(std::sqrt(ratio)));
    places[i].area = own[i] * ratio;
  }
  return places;
}

std::optional<Eigen::Matrix3d> stretchAt(const Transform& toWorld) {
  const double size = toWorld.linear().cwiseAbs().maxCoeff();
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  auto [axes, stretches] = stretchesOf(toWorld.linear() / size);
  const double least = stretches.minCoeff(), most = stretches.maxCoeff();
  if (!(least >= kFlat * most) || most <= kEven * least) return std::nullopt;
  stretches /= std::cbrt(stretches.prod());
  return Eigen::Matrix3d(axes * stretches.asDiagonal() * axes.transpose());
}

TriangleMesh stretched(TriangleMesh mesh, const Eigen::Matrix3d& stretch) {
  Transform transform = Transform::Identity();
  transform.linear() = stretch;
  io::transformMesh(mesh, transform);
  return mesh;
}

TriangleMesh relaxed(TriangleMesh result, const Eigen::Matrix3d& stretch,
                     const TriangleMesh& original) {
  const TriangleMesh before = stretched({original.positions, {}, {}, {}}, stretch);
  std::map<Coordinates, Index> known;
  for (Index v = 0; v < before.positions.size(); ++v)
    known.emplace(coordinatesOf(before.positions[v]), v);
  std::vector<Index> sources;
  for (const Vec3& p : result.positions) {
    const auto found = known.find(coordinatesOf(p));
    sources.push_back(found == known.end() ? kNone : found->second);
  }
  Transform transform = Transform::Identity();
  transform.linear() = stretch.inverse();
  io::transformMesh(result, transform);
  for (std::size_t v = 0; v < sources.size(); ++v)
    if (sources[v] != kNone) result.positions[v] = original.positions[sources[v]];
  return result;
}

}  // namespace remesher
