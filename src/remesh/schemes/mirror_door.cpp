// SPDX-License-Identifier: MIT
#include "remesh/schemes/mirror_door.h"

namespace remesher {

std::optional<RemeshOutcome> remeshIfMirrored(const TriangleMesh& input,
                                              const RemeshOptions& options,
                                              const HalfRemesher& remeshHalf) {
  return remeshMirrored(input, options, remeshHalf);
}

}  // namespace remesher
