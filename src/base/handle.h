// SPDX-License-Identifier: MIT
// Typed indices: a Face cannot be passed for a Vertex, at no cost.
#pragma once

#include <compare>

#include "base/types.h"

namespace remesher {

template <class Tag>
struct Handle {
  Index index = kNone;

  constexpr Handle() = default;
  constexpr explicit Handle(Index i) : index(i) {}
  constexpr explicit operator bool() const { return index != kNone; }
  constexpr auto operator<=>(const Handle&) const = default;
};

}  // namespace remesher
