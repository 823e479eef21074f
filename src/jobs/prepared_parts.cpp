// SPDX-License-Identifier: MIT
#include "jobs/prepared_parts.h"

#include <utility>

#include "jobs/parts/part_joining.h"
#include "jobs/parts/quad_diagonals.h"

namespace remesher {

namespace {

std::vector<io::Part>& joinedIn(std::vector<io::Part>& parts, const PartOptions& options) {
  parts = joinedPlaces(std::move(parts), options);
  if (options.quads) parts = cutAlongShorter(std::move(parts));
  return parts;
}

}  // namespace

PreparedParts::PreparedParts(PreparationInput input, const PartOptions& options,
                             const Progress& progress)
    : thinned_(thinnedParts(joinedIn(input.parts, options), options, input.slabs)),
      given_(input.keepsGiven ? input.parts : std::vector<io::Part>()),
      mending_(input.parts, options, progress),
      touching_(input.parts, options),
      chosen_(mending_.chosen(options)) {
  if (input.keepsGiven) given_ = mending_.kept(std::move(given_));
  if (thinned_) chosen_ = thinned_->applied(std::move(chosen_));
  chosen_ = touching_.applied(std::move(chosen_));
}

void PreparedParts::finish(std::vector<SceneRun>& runs, Held held) const {
  touching_.finish(runs);
  mending_.note(runs.front(), held);
  if (thinned_) thinned_->note(runs);
}

}  // namespace remesher
