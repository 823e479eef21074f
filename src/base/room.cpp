// SPDX-License-Identifier: MIT
#include "base/room.h"

#include "base/error.h"
#include "base/legible.h"

namespace remesher {
namespace {

constexpr double kMillion = 1e6, kGigabyte = 1e9;
constexpr int kFewDigits = 3;

}  // namespace

std::string inMillions(double count) {
  if (count < kMillion) return std::to_string(static_cast<std::size_t>(count));
  return inDigits(count / kMillion, kFewDigits) + " M";
}

bool haveRoom(const RoomNeeds& needs, double addresses) { return needs.bytes <= addresses; }

std::string needsInWords(const RoomNeeds& needs, double addresses) {
  return "takes about " + inDigits(needs.bytes / kGigabyte, kFewDigits) +
         " GB of memory; this build has " + inDigits(addresses / kGigabyte, kFewDigits) +
         " GB, enough for about " + inMillions(needs.triangles * addresses / needs.bytes) +
         " triangles.";
}

void refuseSize(const RoomNeeds& needs, const std::string& verb, const std::string& hint,
                double addresses) {
  throw Error(ErrorCode::OutOfMemory,
              "This model has " + inMillions(needs.triangles) + " triangles. To " + verb + " it " +
                  needsInWords(needs, addresses),
              hint);
}

}  // namespace remesher
