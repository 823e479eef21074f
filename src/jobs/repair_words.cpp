// SPDX-License-Identifier: MIT
#include "jobs/repair_words.h"

#include <algorithm>
#include <utility>

#include "base/legible.h"
#include "jobs/checks/result_check.h"

namespace remesher {

void add(RepairReport& sum, const RepairReport& part) {
  sum.holes += part.holes;
  sum.islands += part.islands;
  sum.shells += part.shells;
  sum.rims += part.rims;
  sum.bodies += part.bodies;
  sum.turned += part.turned;
  sum.lostBeyond = std::max(sum.lostBeyond, part.lostBeyond);
  for (std::size_t i = 0; i < 2; ++i) sum.selfIntersections[i] += part.selfIntersections[i];
}

void join(std::vector<PlacedWarning>& all, PlacedWarning warning) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const PlacedWarning& w) {
    return w.warning.code == warning.warning.code;
  });
  if (same == all.end()) {
    all.push_back(std::move(warning));
    return;
  }
  same->warning.count += warning.warning.count;
  if (warning.across > same->across) same->at = warning.at, same->across = warning.across;
}

std::vector<Warning> inWords(std::vector<PlacedWarning> warnings,
                             const std::vector<io::Part>& parts) {
  constexpr int kWidthDigits = 3;
  std::vector<Warning> result;
  for (PlacedWarning& placed : warnings) {
    placed.warning.at = placed.at;
    if (placed.at)
      placed.warning.message
          .append(placed.across > 0 ? " The widest, " + inDigits(placed.across, kWidthDigits) +
                                          " across, is near ("
                                    : " The first is near (")
          .append(placeInWords(*placed.at, parts))
          .append(").");
    result.push_back(std::move(placed.warning));
  }
  return result;
}

}  // namespace remesher
