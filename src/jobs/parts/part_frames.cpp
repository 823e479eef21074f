// SPDX-License-Identifier: MIT
#include "jobs/parts/part_frames.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/triangle.h"
#include "mesh/joining.h"

namespace remesher {
namespace {

// Sizes up to this power of two, and down to its inverse, are not scaled.
constexpr int kUsual = 30;
// The largest exponent whose power of two and inverse are both normal doubles.
constexpr int kFarthest = 1022;

// A part farther from the origin than this many times its diagonal is moved there.
constexpr double kFar = 4;

// The points' box at half its size: the full size of the largest doubles would be infinite.
using HalfBox = Eigen::AlignedBox3d;

// The box of triangles that are no lines, their corners mapped; stray vertices do not count.
// Indices are not checked yet.
template <class Map>
HalfBox halfBox(const TriangleMesh& mesh, Map mapped) {
  Box box;
  const std::vector<Vec3>& positions = mesh.positions;
  std::vector<char> isIn(positions.size(), 0);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Index* const t = &mesh.indices[i];
    if (std::max({t[0], t[1], t[2]}) >= positions.size()) continue;
    if (isIn[t[0]] && isIn[t[1]] && isIn[t[2]]) continue;
    if (hasTwins(positions[t[0]], positions[t[1]], positions[t[2]])) continue;
    for (const Index v : {t[0], t[1], t[2]})
      if (!std::exchange(isIn[v], 1)) box.extend(mapped(positions[v]));
  }
  return {0.5 * box.low, 0.5 * box.high};
}

// Whether all scaled positions are finite: a stray vertex may lie far outside the box.
bool fits(const io::Part& part, double scale) {
  return std::all_of(part.mesh.positions.begin(), part.mesh.positions.end(),
                     [&](const Vec3& p) { return (p * scale).allFinite(); });
}

// The box's middle, in few digits, on the axes on which the box is several times as far away as it
// is large: both are then so near to each other that their difference is exact.
Vec3 originOf(const HalfBox& box) {
  constexpr double kTimes = 4;
  if (box.isEmpty()) return Vec3::Zero();
  const Vec3 low = box.min(), high = box.max();
  const double half = (high - low).maxCoeff(), diagonal = 2 * (high - low).stableNorm();
  const double farthest = 2 * high.cwiseAbs().cwiseMax(low.cwiseAbs()).maxCoeff();
  if (!(half > 0) || !std::isfinite(diagonal) || !(farthest > kFar * diagonal)) return Vec3::Zero();
  const double step = std::ldexp(1.0, std::ilogb(half) + 1);
  Vec3 origin = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = low[axis] + high[axis];
    if (!(std::abs(middle) > kTimes * half)) continue;
    origin[axis] = std::round(middle / step) * step;
  }
  return origin.allFinite() ? origin : Vec3::Zero();
}

// Whether the attribute's values are directions or moves in space: their first three numbers turn.
bool isInSpace(const Attribute& attribute) {
  const std::string_view semantic = attribute.semantic;
  const std::string_view own =
      semantic.starts_with("TARGET_") ? semantic.substr(semantic.find('/') + 1) : semantic;
  return attribute.itemSize >= 3 && (own == "NORMAL" || own == "TANGENT" || own == "POSITION");
}

template <class Turned>
void turnDirections(TriangleMesh& mesh, Turned turned) {
  for (Attribute& attribute : mesh.attributes) {
    if (!isInSpace(attribute)) continue;
    const auto stride = std::size_t(attribute.itemSize);
    for (std::size_t at = 0; at + stride <= attribute.values.size(); at += stride) {
      Eigen::Map<Eigen::Vector3f> direction(&attribute.values[at]);
      direction = turned(Eigen::Vector3f(direction));
    }
  }
}

HalfBox movedBy(const HalfBox& box, const Vec3& origin) {
  return box.isEmpty() ? box : HalfBox(box.min() - origin / 2, box.max() - origin / 2);
}

bool isMoved(const Transform& place) { return !place.translation().isZero(0); }

bool isIdentity(const Transform& place) { return place.matrix() == Transform::Identity().matrix(); }

// Whether all parts are first shown in one space, which is also the world.
bool areInWorld(const std::vector<io::Part>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const io::Part& part) {
    return part.instances.empty() || isIdentity(part.instances.front());
  });
}

// The number in single precision, if x is that but for the rounding of the way here and back.
double asSingle(double x, double rounding) {
  const double single = static_cast<float>(x);
  return std::abs(single - x) <= rounding ? single : x;
}

// The way from the frame to written places.
Transform writtenFrom(const Frame& frame) {
  Transform way = Transform::Identity();
  way.translate(frame.written(Vec3::Zero()))
      .rotate(Eigen::Matrix3d(frame.turn.matrix().transpose()))
      .scale(1 / frame.scale());
  return way;
}

// The factor that brings the longest side of the box to between 1 and 2, or below if the box is so
// far away that products of four coordinates would be infinite.
double unitScale(const HalfBox& box) {
  constexpr int kFarAway = 200;
  if (box.isEmpty()) return 1;
  const double half = (box.max() - box.min()).maxCoeff();
  const double farthest = box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()).maxCoeff();
  if (!std::isfinite(half) || farthest == 0) return 1;
  const int bySize = half > 0 ? std::ilogb(half) + 1 : 0;
  const int power = std::max(bySize, std::ilogb(farthest) + 1 - kFarAway);
  if (std::abs(power) <= kUsual) return 1;
  return std::ldexp(1.0, -std::clamp(power, -kFarthest, kFarthest));
}

// The way from written places to the frame.
Transform hereFrom(const Frame& frame) {
  Transform way = Transform::Identity();
  way.scale(frame.scale()).rotate(frame.turn.matrix()).translate(-frame.written(Vec3::Zero()));
  return way;
}

}  // namespace

PartFrames::PartFrames(const std::vector<io::Part>& parts, FrameRounding rounding, FrameAxes axes) {
  const bool isWorld = areInWorld(parts);
  if (isWorld || parts.size() == 1) common_ = commonFrame(parts, axes);
  if (common_ && !common_->isInSteps && rounding == FrameRounding::None) common_.reset();
  if (common_ && !common_->isInSteps) noteRounded(parts);
  isWorldCommon_ = isWorld && common_;
  HalfBox world;
  bool isWorldMoved = false;
  for (const io::Part& part : parts) {
    const HalfBox box =
        halfBox(part.mesh, [&](const Vec3& p) { return common_ ? common_->here(p) : p; });
    const Vec3 origin = part.mesh.isSingle || part.mesh.steps ? Vec3(Vec3::Zero()) : originOf(box);
    origins_.push_back(origin);
    const double own = unitScale(movedBy(box, origin));
    local_.push_back(own != 1 && fits(part, own) ? own : 1);
    const auto inWorld = [&](const Vec3& p) {
      return part.instances.empty() ? p : Vec3(part.instances.front() * p);
    };
    if (!isWorldCommon_) world.extend(halfBox(part.mesh, inWorld));
    isWorldMoved = isWorldMoved || !origin.isZero(0) ||
                   (!part.instances.empty() && isMoved(part.instances.front()));
  }
  if (isWorldCommon_) {
    world_ = common_->frame;
    return;
  }
  if (isWorldMoved) world_.middle = originOf(world);
  world_.unit = unitScale(movedBy(world, world_.middle));
}

void PartFrames::noteRounded(const std::vector<io::Part>& parts) {
  for (const io::Part& part : parts)
    for (const Vec3& p : part.mesh.positions) {
      const Vec3 there = common_->here(p), back = common_->frame.written(there);
      const Vec3 here = common_->frame.turn.turnedBack(there);
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (back[axis] != p[axis]) rounded_[std::size_t(axis)].push_back({here[axis], p[axis]});
    }
  for (std::vector<std::pair<double, double>>& values : rounded_) {
    std::sort(values.begin(), values.end());
    const auto isSame = [](const auto& a, const auto& b) { return a.first == b.first; };
    values.erase(std::unique(values.begin(), values.end(), isSame), values.end());
  }
}

bool PartFrames::isNeeded() const {
  return common_ || world_ != Frame{} ||
         std::any_of(local_.begin(), local_.end(), [](double s) { return s != 1; }) ||
         std::any_of(origins_.begin(), origins_.end(), [](const Vec3& p) { return !p.isZero(0); });
}

Frame PartFrames::frameOf(std::size_t part) const {
  Frame frame = common_ ? common_->frame : Frame{};
  frame.middle += frame.turn.turnedBack(origins_[part]) / frame.unit * frame.shared;
  frame.unit *= local_[part];
  return frame;
}

Transform PartFrames::placed(Transform place, std::size_t part) const {
  const Transform common = common_ ? writtenFrom(common_->frame) : Transform::Identity();
  if (!isWorldCommon_)
    place = place.pretranslate(-world_.middle) * common;
  else if (!isIdentity(place))
    place = hereFrom(common_->frame) * place * common;
  place.translate(origins_[part]);
  if (!isWorldCommon_) place.prescale(world_.unit);
  return place.scale(1 / local_[part]);
}

std::vector<io::Part> PartFrames::applied(std::vector<io::Part> parts) const {
  const QuarterTurn turn = common_ ? common_->frame.turn : QuarterTurn{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    unifyPlaces(parts[i].mesh.positions);  // away from zero nothing tells noise from shape
    for (Vec3& p : parts[i].mesh.positions)
      p = ((common_ ? common_->here(p) : p) - origins_[i]) * local_[i];
    parts[i].mesh.frame = frameOf(i);
    turnDirections(parts[i].mesh, [&](const auto& d) { return turn.turned(d); });
    if (parts[i].instances.empty()) parts[i].instances.push_back(Transform::Identity());
    for (Transform& place : parts[i].instances) place = placed(place, i);
  }
  return parts;
}

PartOptions PartFrames::applied(PartOptions options) const {
  for (std::optional<double>* const length :
       {&options.edgeLength, &options.minEdge, &options.maxEdge, &options.lengths.maxError})
    if (*length) **length *= world_.scale();
  for (Guide& guide : options.guides)
    for (Vec3& p : guide.points) p = world_.here(p);
  return options;
}

Vec3 PartFrames::undone(std::size_t part, const Vec3& p) const {
  const Vec3 common = p / local_[part] + origins_[part];
  if (!common_) return common;
  Vec3 written = common_->frame.written(common);
  const Vec3 here = common_->frame.turn.turnedBack(common);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto& values = rounded_[std::size_t(axis)];
    const auto found =
        std::lower_bound(values.begin(), values.end(), here[axis],
                         [](const auto& value, double x) { return value.first < x; });
    if (found != values.end() && found->first == here[axis]) written[axis] = found->second;
  }
  return written;
}

std::vector<io::Part> PartFrames::undone(std::vector<io::Part> parts,
                                         const std::vector<io::Part>& originals) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TriangleMesh& mesh = parts[i].mesh;
    const Frame frame = frameOf(i);
    const double rounding =
        0x1p-50 * (frame.written(Vec3::Zero()).cwiseAbs().maxCoeff() + 2 / frame.scale());
    for (Vec3& p : mesh.positions) {
      p = undone(i, p);
      if (!mesh.isSingle || !common_) continue;
      for (double& x : p) x = asSingle(x, rounding);
    }
    mesh.frame = {};
    turnDirections(mesh, [&](const auto& d) { return frame.turn.turnedBack(d); });
    parts[i].instances = originals[i].instances;
  }
  return parts;
}

Vec3 PartFrames::inWorld(const io::Part& part, const Vec3& p) const {
  return part.instances.empty() ? p : unscaled(part.instances.front() * p);
}

double PartFrames::growth(const io::Part& part) const {
  if (part.instances.empty()) return 1;
  return std::cbrt(std::abs(part.instances.front().linear().determinant())) / world_.scale();
}

}  // namespace remesher
