// SPDX-License-Identifier: MIT
// Refuses work that no memory has room for, before it begins.
#pragma once

#include <limits>
#include <string>

namespace remesher {

// All bytes that this build can address: 4 GB in WebAssembly.
inline constexpr double kAddresses = double(std::numeric_limits<std::size_t>::max());

// Peak memory of a repair for each triangle of the input, and of the search for faults.
inline constexpr double kRepairBytesPerTriangle = 300;

// `10.2 M`, or all digits of a small number.
std::string inMillions(double count);

// The memory that a model takes.
struct RoomNeeds {
  double triangles, bytes;
};

bool haveRoom(const RoomNeeds& needs, double addresses = kAddresses);
// `takes about 6.12 GB of memory; this build has 4.29 GB, enough for about 7.16 M triangles.`
std::string needsInWords(const RoomNeeds& needs, double addresses = kAddresses);

// OUT_OF_MEMORY for a model if there is no room for the work that the verb names.
[[noreturn]] void refuseSize(const RoomNeeds& needs, const std::string& verb,
                             const std::string& hint, double addresses = kAddresses);

}  // namespace remesher
