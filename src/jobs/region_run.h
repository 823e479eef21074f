// SPDX-License-Identifier: MIT
// Remeshes some triangles of a mesh and leaves all others as they are, bit for bit: the triangles
// become a part of their own, whose border is kept, and the result is put in their place.
#pragma once

#include <optional>
#include <vector>

#include "base/part_options.h"
#include "io/model/model.h"
#include "jobs/scene_run.h"
#include "remesh/schemes/targets.h"

namespace remesher {

class RegionRun {
 public:
  // Takes the triangles of the options' region out of the only part; does nothing without a region.
  // Throws INVALID_OPTION for several parts, and for triangles that do not exist; the Errors
  // of requireValid.
  RegionRun(std::vector<io::Part>& parts, const PartOptions& options);

  // The options for the region: its share of the number of vertices or faces, its border kept.
  // Throws TARGET_TOO_SMALL if the others alone have more.
  PartOptions applied(PartOptions options) const;

  // What `run` returns; numbers in its errors become those of the whole.
  template <class Run>
  auto within(const Run& run) const {
    try {
      return run();
    } catch (const TooFewVertices& error) {
      throw TooFewVertices(
          error.code, {error.target + others_, error.needed + others_, error.enough + others_});
    }
  }

  // Puts the result back into the whole, and describes the whole.
  void finish(std::vector<SceneRun>& runs) const;

 private:
  void takeOut(io::Part& part);
  TriangleMesh joinedWith(const TriangleMesh& made) const;

  std::optional<io::Part> whole_;
  std::vector<char> isInside_;   // per triangle
  std::vector<char> isOutside_;  // per vertex: whether a triangle outside uses it
  std::vector<Index> sources_;   // per vertex of the region, that of the whole
  std::vector<Index> border_;    // vertices of the region's triangles at places of others
  std::size_t others_ = 0;       // places outside, without those on the border
  std::size_t places_ = 0;       // of the whole
  std::size_t trianglesOutside_ = 0;
  double growth_ = 1;  // the whole's diagonal over the region's
};

}  // namespace remesher
