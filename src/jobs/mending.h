// SPDX-License-Identifier: MIT
// Repairs the parts of a file before any other step, and leaves out small and hidden pieces, if
// asked for.
#pragma once

#include <optional>
#include <vector>

#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/dropping.h"
#include "jobs/part_repair.h"
#include "jobs/parts/part_report.h"
#include "jobs/scene_run.h"

namespace remesher {

// The approximate share of a run's time.
double mendShare(const PartOptions& options);

// Repairs the parts in place, leaves out small and hidden pieces if asked to, and keeps the
// reports. Small pieces go before repair, hidden triangles afterwards. A part that keeps no
// triangle goes.
class Mending {
 public:
  // Before remeshing the surface is as fine as the target asks for.
  enum class Purpose { Remeshing, Itself };

  Mending(std::vector<io::Part>& parts, const PartOptions& options, const Progress& progress,
          Purpose purpose = Purpose::Remeshing);

  // The options with the way of repair that was chosen, if the choice was repair's own. Without a
  // number of vertices, `ratio` is a share of the input's number, not of the repaired one, which
  // may be many times larger; where both are equal the number stays open.
  PartOptions chosen(PartOptions options) const;

  // Whether a lattice has replaced the triangles of any part.
  bool isRemade() const { return repair_ && repair_->isRemade; }

  // Adds the repair to the report; the report's input is the given one, not the repaired one.
  void note(Report& report) const;
  // The same for a remeshed result, whose self-intersections are those that the report has: of the
  // surfaces that the file will hold.
  void note(SceneRun& run, Held held) const;

  // Per part given whether it is gone.
  const std::vector<char>& isGone() const { return isGone_; }
  // The parts that were given without those that are gone.
  std::vector<io::Part> kept(std::vector<io::Part> given) const;
  // The numbers in the file of the meshes that are gone.
  std::vector<int> leftOut() const;

 private:
  void dropPieces(std::vector<io::Part>& parts, const PartOptions& options);
  void repair(std::vector<io::Part>& parts, const PartOptions& options, const Progress& progress,
              Purpose purpose);
  void dropHidden(std::vector<io::Part>& parts, const PartOptions& options);
  void take(Dropped dropped);

  MeshReport input_;
  std::optional<PartsRepair> repair_;
  std::optional<Dropped> dropped_;
  std::vector<char> isGone_;
  std::vector<int> sources_;     // per part given its number in the file
  std::optional<double> ratio_;  // of the repaired parts' vertices, where the input's number counts
};

// What parts with nothing wrong become: if all are so, the given file is the result; or they are
// rounded for the file that is written.
enum class IfSound { FileStays, IsRounded };

struct RepairedParts {
  Report report;
  bool isRemade;             // see Mending
  bool isUnchanged;          // whether every part is as it was given, bit for bit
  std::vector<int> leftOut;  // see Mending::leftOut
  std::size_t quadsCut;      // of parts that were all quads and are no more
};

// Repairs the parts in place. The report describes them as the file holds them, and lacks only the
// times.
RepairedParts repairOnly(std::vector<io::Part>& parts, Held held, IfSound ifSound,
                         const PartOptions& options, const Progress& progress);

// Sets textures to be baked if the options leave it open and repair has made another surface
// (more than closed holes), because charts may end anywhere on it. Adds a warning to the model.
PartOptions chooseBaking(PartOptions options, io::Model& model);

}  // namespace remesher
