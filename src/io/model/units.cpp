// SPDX-License-Identifier: MIT
#include "io/model/units.h"

#include <array>
#include <utility>

namespace remesher::io {

std::string unitOf(const Model& model) {
  if (!model.unit.empty()) return model.unit;
  return model.conventions == Conventions::Gltf ? "meter" : "";
}

double metresIn(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 6> kUnits = {{{"micron", 1e-6},
                                                                          {"millimeter", 1e-3},
                                                                          {"centimeter", 1e-2},
                                                                          {"meter", 1},
                                                                          {"inch", 0.0254},
                                                                          {"foot", 0.3048}}};
  for (const auto& [name, metres] : kUnits)
    if (name == unit) return metres;
  return 0;
}

}  // namespace remesher::io
