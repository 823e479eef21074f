// SPDX-License-Identifier: MIT
// Runs a target on files, and on changed copies of each, without libFuzzer:
//   fuzz_replay TARGET COPIES KEPT FILE…
// The same files and number of copies are the same inputs. Each is written to KEPT before it runs,
// so that what crashes is there afterwards.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "byte_changes.h"
#include "targets.h"

using namespace remesher::fuzz;

namespace {

Bytes contentsOf(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void runKept(const Target& target, const Bytes& input, const char* kept) {
  std::ofstream(kept, std::ios::binary)
      .write(reinterpret_cast<const char*>(input.data()), std::ptrdiff_t(input.size()));
  target.run(input);
}

Bytes changed(const Target& target, const Bytes& input, unsigned seed) {
  if (target.change != nullptr && seed % 4 != 0) return target.change(input, seed);
  remesher::soups::Random random(seed);
  return changedBytes(input, random);
}

}  // namespace

int main(int count, char** words) {
  const Target* const target = count > 3 ? findTarget(words[1]) : nullptr;
  if (target == nullptr) {
    std::fprintf(stderr, "fuzz_replay TARGET COPIES KEPT FILE…\n");
    return 2;
  }
  const auto copies = unsigned(std::atoi(words[2]));
  unsigned inputs = 0;
  for (int i = 4; i < count; ++i) {
    const Bytes input = contentsOf(words[i]);
    runKept(*target, input, words[3]);
    for (unsigned seed = 1; seed <= copies; ++seed)
      runKept(*target, changed(*target, input, seed), words[3]);
    inputs += 1 + copies;
  }
  std::printf("%u inputs\n", inputs);
  return 0;
}
