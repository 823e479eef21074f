// SPDX-License-Identifier: MIT
#include "byte_changes.h"

#include <array>
#include <cstring>
#include <limits>

namespace remesher::fuzz {
namespace {

void flipBit(Bytes& bytes, soups::Random& random) {
  bytes[pick(random, bytes.size())] ^= static_cast<std::uint8_t>(1u << pick(random, 8));
}

void setByte(Bytes& bytes, soups::Random& random) {
  constexpr std::array<std::uint8_t, 8> kBytes = {0, 1, 10, 32, 45, 127, 128, 255};
  bytes[pick(random, bytes.size())] = kBytes[pick(random, kBytes.size())];
}

void setFloat(Bytes& bytes, soups::Random& random) {
  const auto value = static_cast<float>(wildNumber(random));
  if (bytes.size() < sizeof value) return;
  const std::size_t place = pick(random, bytes.size() / sizeof value) * sizeof value;
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

void cut(Bytes& bytes, soups::Random& random) { bytes.resize(pick(random, bytes.size())); }

void repeatPiece(Bytes& bytes, soups::Random& random) {
  const std::size_t from = pick(random, bytes.size());
  const std::size_t length = pick(random, std::min<std::size_t>(64, bytes.size() - from)) + 1;
  const Bytes piece(bytes.begin() + std::ptrdiff_t(from),
                    bytes.begin() + std::ptrdiff_t(from + length));
  const std::size_t to = pick(random, bytes.size());
  bytes.insert(bytes.begin() + std::ptrdiff_t(to), piece.begin(), piece.end());
}

}  // namespace

std::size_t pick(soups::Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.number() * double(count));
}

double wildNumber(soups::Random& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 20> kNumbers = {0,
                                               -0.0,
                                               1,
                                               -1,
                                               0.5,
                                               1e-45,
                                               1e-30,
                                               1e-12,
                                               1e-6,
                                               1e6,
                                               1e12,
                                               1e30,
                                               -1e30,
                                               3e38,
                                               255,
                                               65535,
                                               2147483647,
                                               4294967295,
                                               -9007199254740992,
                                               kInfinity};
  return kNumbers[pick(random, kNumbers.size())];
}

Bytes changedBytes(Bytes bytes, soups::Random& random) {
  constexpr std::array kChanges = {flipBit, setByte, setFloat, cut, repeatPiece};
  for (std::size_t times = 1 + pick(random, 3); times > 0 && !bytes.empty(); --times)
    kChanges[pick(random, kChanges.size())](bytes, random);
  return bytes;
}

}  // namespace remesher::fuzz
