// SPDX-License-Identifier: MIT
#include "io/model/wedges.h"

#include <doctest/doctest.h>

#include <map>
#include <utility>

using namespace remesher;
using namespace remesher::io;

namespace {

// A value that counts how often it is compared.
struct Counted {
  int value;
  static inline std::size_t comparisons = 0;

  bool operator==(const Counted& other) const { return ++comparisons, value == other.value; }
  bool operator<(const Counted& other) const { return ++comparisons, value < other.value; }
};

std::size_t comparisonsFor(int wedges) {
  Counted::comparisons = 0;
  WedgeChains<Counted> chains(1);
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < wedges; ++i) CHECK(chains.wedgeAt(0, {i * 7 % wedges}) < Index(wedges));
  CHECK(chains.count() == std::size_t(wedges));
  return Counted::comparisons;
}

}  // namespace

TEST_CASE("wedges: each value of a vertex is one wedge, numbered by first mention") {
  WedgeChains<int> chains(3);
  std::map<std::pair<Index, int>, Index> known;
  for (int i = 0; i < 3000; ++i) {
    const auto vertex = Index(i % 2);
    const int value = (i * 37) % 500;
    const auto [entry, isNew] = known.emplace(std::pair(vertex, value), Index(known.size()));
    CHECK(chains.wedgeAt(vertex, value) == entry->second);
  }
  CHECK(chains.count() == known.size());
  CHECK(chains.first(2) == kNone);
  for (Index vertex = 0; vertex < 2; ++vertex) {
    Index last = kNone;
    for (Index wedge = chains.first(vertex); wedge != kNone; wedge = chains.next(wedge)) {
      CHECK(wedge < last);
      CHECK(known.at({vertex, chains.value(wedge)}) == wedge);
      last = wedge;
    }
  }
}

TEST_CASE("wedges: many at one vertex take about as many steps each as few") {
  CHECK(comparisonsFor(8000) < 12 * comparisonsFor(1000));
}
