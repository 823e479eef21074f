// SPDX-License-Identifier: MIT
// Wedges: the distinct corners at each vertex, where a file gives corners values of their own.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher::io {

// Value: what corners of one vertex differ in; has == and <. The wedges of a vertex are a chain.
// Most are short; a long one, as around the apex of a cone, gets a map beside it.
template <class Value>
class WedgeChains {
 public:
  explicit WedgeChains(std::size_t vertexCount) : first_(vertexCount, kNone) {}

  // The number of the wedge; wedges are numbered in the order of first mention.
  Index wedgeAt(Index vertex, const Value& value) {
    std::size_t steps = 0;
    for (Index wedge = first_[vertex]; wedge != kNone; wedge = next_[wedge]) {
      if (values_[wedge] == value) return wedge;
      if (++steps == kLongest) return wedgeInMap(vertex, value);
    }
    return add(vertex, value);
  }

  // The last wedge of the vertex, or kNone; `next` leads on to those before.
  Index first(Index vertex) const { return first_[vertex]; }
  Index next(Index wedge) const { return next_[wedge]; }
  const Value& value(Index wedge) const { return values_[wedge]; }
  std::size_t count() const { return values_.size(); }

 private:
  static constexpr std::size_t kLongest = 32;  // links of a chain that are walked

  Index add(Index vertex, const Value& value) {
    const auto wedge = static_cast<Index>(values_.size());
    values_.push_back(value);
    next_.push_back(std::exchange(first_[vertex], wedge));
    return wedge;
  }

  Index wedgeInMap(Index vertex, const Value& value) {
    std::map<Value, Index>& known = maps_[vertex];
    if (known.empty())
      for (Index wedge = first_[vertex]; wedge != kNone; wedge = next_[wedge])
        known[values_[wedge]] = wedge;
    const auto [entry, isNew] = known.emplace(value, kNone);
    if (isNew) entry->second = add(vertex, value);
    return entry->second;
  }

  std::vector<Index> first_;  // per vertex
  std::vector<Index> next_;   // per wedge
  std::vector<Value> values_;
  std::map<Index, std::map<Value, Index>> maps_;  // of the vertices with long chains
};

}  // namespace remesher::io
