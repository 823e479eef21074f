// SPDX-License-Identifier: MIT
// A target under libFuzzer; the variable REMESHER_FUZZ_TARGET names it.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "targets.h"

using namespace remesher::fuzz;

namespace {

const Target* chosen = nullptr;

}  // namespace

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("REMESHER_FUZZ_TARGET");
  chosen = findTarget(name == nullptr ? "" : name);
  if (chosen != nullptr) return 0;
  std::fprintf(stderr, "REMESHER_FUZZ_TARGET names one of these:");
  for (const Target& target : targets())
    std::fprintf(stderr, " %.*s", int(target.name.size()), target.name.data());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run({data, size});
  return 0;
}

// Every fourth change is libFuzzer's own, which knows what comparisons the program has made.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                    unsigned seed) {
  if (chosen->change == nullptr || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  const Bytes changed = chosen->change({data, size}, seed);
  if (changed.empty() || changed.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, changed.data(), changed.size());
  return changed.size();
}
}
