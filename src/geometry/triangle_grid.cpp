// SPDX-License-Identifier: MIT
#include "geometry/triangle_grid.h"

#include <algorithm>
#include <cmath>

namespace remesher {

TriangleGrid::TriangleGrid(double cell, std::size_t expected) : cell_(cell) {
  std::size_t lines = 1;
  while (lines < 2 * expected) lines *= 2;
  lines_.resize(lines, kNone);
}

int TriangleGrid::levelOf(const Box& box) const {
  const double size = (box.high - box.low).maxCoeff() / cell_;
  if (!(size > 1)) return 0;
  return std::min(int(isUsed_.size()) - 1, int(std::ceil(std::log2(size))));
}

TriangleGrid::Cell TriangleGrid::cellAt(const Vec3& p, int level) const {
  const double farthest = std::ldexp(1.0, 52);  // integers are exact up to here
  const double width = std::ldexp(cell_, level);
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] =
        std::int64_t(std::clamp(std::floor(p[Eigen::Index(axis)] / width), -farthest, farthest));
  return cell;
}

std::size_t TriangleGrid::lineOf(const Cell& cell, int level) const {
  std::uint64_t hash = std::uint64_t(level);
  for (const std::int64_t c : cell) {  // multiplied by a large odd number: Fibonacci hashing
    hash = (hash ^ std::uint64_t(c)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32;
  }
  return std::size_t(hash) & (lines_.size() - 1);
}

bool TriangleGrid::holds(std::size_t line, Index name) const {
  for (Index i = lines_[line]; i != kNone; i = links_[i].next)
    if (links_[i].name == name) return true;
  return false;
}

void TriangleGrid::add(Index name, const Box& box) {
  if (name >= entries_.size()) entries_.resize(name + 1);
  entries_[name].box = box;
  const int level = levelOf(box);
  isUsed_[std::size_t(level)] = true;
  forEachLine(box, level, [&](std::size_t line) {
    if (holds(line, name)) return;
    links_.push_back({name, lines_[line]});
    lines_[line] = Index(links_.size() - 1);
  });
}

}  // namespace remesher
