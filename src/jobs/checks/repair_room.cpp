// SPDX-License-Identifier: MIT
#include "jobs/checks/repair_room.h"

#include <algorithm>

#include "base/error.h"

namespace remesher {
namespace {

// A part that waits for its turn is held twice: as given, and at unit size or repaired.
constexpr double kBytesToWait = 50;

RoomNeeds roomToRepair(const std::vector<io::Part>& parts) {
  double all = 0, largest = 0;
  for (const io::Part& part : parts) {
    const double own = double(part.mesh.triangleCount());
    all += own;
    largest = std::max(largest, own);
  }
  return {all, kBytesToWait * (all - largest) + kRepairBytesPerTriangle * largest};
}

}  // namespace

void requireRoomToRepair(const std::vector<io::Part>& parts, double addresses) {
  const RoomNeeds needs = roomToRepair(parts);
  if (haveRoom(needs, addresses)) return;
  refuseSize(needs, "repair",
             "Give it in parts, or remesh it to few vertices without repair, which thins it out, "
             "and repair the result.",
             addresses);
}

void requireRoomForTwo(const RoomNeeds& needs, const std::string& verb, double addresses) {
  if (haveRoom(needs, addresses)) return;
  throw Error(ErrorCode::OutOfMemory,
              "The two models have " + inMillions(needs.triangles) + " triangles. To " + verb +
                  " them " + needsInWords(needs, addresses),
              "Remesh the larger one to fewer vertices first, or give it in parts.");
}

std::optional<Warning> noRoomForFaults(const std::vector<io::Part>& parts, double addresses) {
  const RoomNeeds needs = roomToRepair(parts);
  if (haveRoom(needs, addresses)) return std::nullopt;
  return Warning{"FAULTS_NOT_SOUGHT",
                 "Faults are not looked for, and nothing can be repaired: for " +
                     inMillions(needs.triangles) + " triangles that " +
                     needsInWords(needs, addresses),
                 std::size_t(needs.triangles)};
}

}  // namespace remesher
