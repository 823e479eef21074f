// SPDX-License-Identifier: MIT
#include "jobs/inspected_parts.h"

#include <utility>

#include "jobs/parts/part_lengths.h"
#include "jobs/parts/part_report.h"

namespace remesher {

InspectedParts::InspectedParts(const std::vector<io::Part>& given)
    : given_(given),
      scale_(given),
      scaled_(scale_.isNeeded() ? scale_.applied(given) : std::vector<io::Part>{}),
      weldings_(weldingsOf(parts())),
      places_(placesOf(parts())),
      report_(inspectParts(parts(), weldings_, places_)) {
  report_.diagonal = worldDiagonal(given_);
}

RemeshOptions InspectedParts::scaled(const RemeshOptions& options) const {
  return scale_.isNeeded() ? scale_.applied(options) : options;
}

std::vector<io::Part> InspectedParts::unscaled(std::vector<io::Part> results) const {
  return scale_.isNeeded() ? scale_.undone(std::move(results), given_) : results;
}

Vec3 InspectedParts::given(std::size_t part, const Vec3& p) const {
  return scale_.isNeeded() ? scale_.undone(part, p) : p;
}

MeshReport inspectScaled(const std::vector<io::Part>& parts) {
  return InspectedParts(parts).report();
}

}  // namespace remesher
