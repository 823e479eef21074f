// SPDX-License-Identifier: MIT
#include "base/diagnostics.h"

#include <algorithm>
#include <array>

namespace remesher {

namespace {

constexpr std::array kDiagnostics = {
    Diagnostic{"ANGLES_TOO_SMALL", Severity::Loss},
    Diagnostic{"ANGLES_WORSE", Severity::Fault},
    Diagnostic{"ATTRIBUTE_HAS_NO_CHARTS", Severity::Loss},
    Diagnostic{"ATTRIBUTE_NOT_CARRIED", Severity::Loss},
    Diagnostic{"BACK_TO_BACK_TRIANGLES_REMOVED", Severity::Note},
    Diagnostic{"BASE_NOT_MADE", Severity::Loss},
    Diagnostic{"BODIES_ALMOST_TOUCH", Severity::Note},
    Diagnostic{"BODIES_OVERLAP", Severity::Fault},
    Diagnostic{"CAVITIES_FILLED", Severity::Note},
    Diagnostic{"COMMON_FACES_LEFT", Severity::Loss},
    Diagnostic{"COUNT_CONTRADICTS", Severity::Note},
    Diagnostic{"CROSSINGS_LEFT", Severity::Fault},
    Diagnostic{"DEGENERATE_TRIANGLES_MADE", Severity::Fault},
    Diagnostic{"DEGENERATE_TRIANGLES_REMOVED", Severity::Note},
    Diagnostic{"DUPLICATE_TRIANGLES_REMOVED", Severity::Note},
    Diagnostic{"EDGES_TOO_LONG", Severity::Loss},
    Diagnostic{"EDGES_TOO_SHORT", Severity::Loss},
    Diagnostic{"ELEMENTS_LEFT_OUT", Severity::Loss},
    Diagnostic{"EXTENSION_NOT_CARRIED", Severity::Loss},
    Diagnostic{"FAULTS_NOT_SOUGHT", Severity::Note},
    Diagnostic{"GUIDES_FAR_AWAY", Severity::Note},
    Diagnostic{"GUIDES_MIRRORED", Severity::Note},
    Diagnostic{"GUIDES_NOT_KEPT", Severity::Loss},
    Diagnostic{"HIDDEN_BODIES_REMOVED", Severity::Note},
    Diagnostic{"HIDDEN_DROPPED", Severity::Note},
    Diagnostic{"HIDDEN_LEFT_OUT", Severity::Loss},
    Diagnostic{"HOLES_LEFT_OPEN", Severity::Fault},
    Diagnostic{"IMAGES_NOT_FITTING", Severity::Loss},
    Diagnostic{"INCONSISTENT_ORIENTATION_FIXED", Severity::Note},
    Diagnostic{"INSTANCES_NOT_CONFORMED", Severity::Loss},
    Diagnostic{"ISOTROPIC_TAKES_MORE", Severity::Note},
    Diagnostic{"JOINTS_RELEASED", Severity::Loss},
    Diagnostic{"JOINT_NOT_IN_SKIN", Severity::Loss},
    Diagnostic{"LEVELS_REPLACED", Severity::Note},
    Diagnostic{"LEVEL_FARTHER_THAN_ASKED", Severity::Fault},
    Diagnostic{"LEVEL_NOT_COARSER", Severity::Loss},
    Diagnostic{"MAP_NOT_PAINTED", Severity::Loss},
    Diagnostic{"MATERIALS_BY_NAME", Severity::Note},
    Diagnostic{"MATERIAL_IMAGES_NOT_READ", Severity::Loss},
    Diagnostic{"MAX_ERROR_EXCEEDED", Severity::Fault},
    Diagnostic{"MORE_VERTICES_TAKEN", Severity::Note},
    Diagnostic{"NAME_CONTRADICTS", Severity::Note},
    Diagnostic{"NEEDS_THINNING", Severity::Note},
    Diagnostic{"NON_FINITE_ATTRIBUTE", Severity::Loss},
    Diagnostic{"NON_MANIFOLD_EDGES_LEFT", Severity::Note},
    Diagnostic{"NON_MANIFOLD_EDGES_MADE", Severity::Fault},
    Diagnostic{"NON_MANIFOLD_EDGES_SPLIT", Severity::Note},
    Diagnostic{"NON_MANIFOLD_VERTICES_LEFT", Severity::Note},
    Diagnostic{"NON_MANIFOLD_VERTICES_SPLIT", Severity::Note},
    Diagnostic{"NON_ORIENTABLE_CUT", Severity::Note},
    Diagnostic{"NOTHING_TO_REMESH", Severity::Note},
    Diagnostic{"NOT_TRIANGLES", Severity::Loss},
    Diagnostic{"NO_BODIES_TOUCH", Severity::Note},
    Diagnostic{"ONE_SIDED", Severity::Fault},
    Diagnostic{"ONLY_REPAIRED", Severity::Loss},
    Diagnostic{"PARTS_MEET", Severity::Fault},
    Diagnostic{"PARTS_MERGED", Severity::Note},
    Diagnostic{"PASSED_ON", Severity::Note},
    Diagnostic{"PIECES_DROPPED", Severity::Note},
    Diagnostic{"PLACES_JOINED", Severity::Note},
    Diagnostic{"POLYGONS_CUT", Severity::Loss},
    Diagnostic{"QUADS_MADE_SYMMETRIC", Severity::Note},
    Diagnostic{"QUADS_NUMBER_MISSED", Severity::Loss},
    Diagnostic{"QUADS_OFF_BORDER", Severity::Fault},
    Diagnostic{"QUADS_PAIRED", Severity::Note},
    Diagnostic{"QUADS_SYMMETRY_LOST", Severity::Note},
    Diagnostic{"QUADS_TOO_FEW", Severity::Loss},
    Diagnostic{"QUADS_TURNED_AWAY", Severity::Fault},
    Diagnostic{"REMADE_IN_PART", Severity::Note},
    Diagnostic{"RESOURCE_NOT_GIVEN", Severity::Loss},
    Diagnostic{"RIMS_CLOSED", Severity::Note},
    Diagnostic{"RIMS_LEFT_OPEN", Severity::Note},
    Diagnostic{"RIMS_NOT_KEPT", Severity::Loss},
    Diagnostic{"ROUNDED_FAR_FROM_ORIGIN", Severity::Loss},
    Diagnostic{"SCRAPS_REMOVED", Severity::Note},
    Diagnostic{"SEEN_PARTS_LOST", Severity::Loss},
    Diagnostic{"SELF_INTERSECTIONS_MADE", Severity::Fault},
    Diagnostic{"SHAPE_LOST_TO_ROUNDING", Severity::Fault},
    Diagnostic{"SHAPE_NOT_PREFERRED", Severity::Loss},
    Diagnostic{"SHAPE_TAKES_MORE", Severity::Loss},
    Diagnostic{"SHEETS_DROPPED", Severity::Note},
    Diagnostic{"SHEETS_LEFT", Severity::Fault},
    Diagnostic{"SHEETS_MADE_BODIES", Severity::Note},
    Diagnostic{"SHEETS_NOT_MADE_BODIES", Severity::Loss},
    Diagnostic{"SHEETS_THICKENED", Severity::Note},
    Diagnostic{"SPIKES_LEFT_COARSE", Severity::Loss},
    Diagnostic{"SURFACE_OPENED", Severity::Fault},
    Diagnostic{"TEXCOORDS_LEFT_OUT", Severity::Loss},
    Diagnostic{"TEXCOORDS_REPLACED", Severity::Note},
    Diagnostic{"TEXELS_NOT_FOUND", Severity::Loss},
    Diagnostic{"TEXTURES_PAINTED", Severity::Note},
    Diagnostic{"THINNED_OUT", Severity::Note},
    Diagnostic{"TOO_FEW_FACES", Severity::Loss},
    Diagnostic{"TOO_FEW_VERTICES", Severity::Loss},
    Diagnostic{"TRIANGLES_NOT_JOINED", Severity::Note},
    Diagnostic{"VERTICES_COINCIDE", Severity::Fault},
};

}  // namespace

std::span<const Diagnostic> diagnostics() { return kDiagnostics; }

Severity severityOf(const Warning& warning) {
  const auto* const row =
      std::lower_bound(kDiagnostics.begin(), kDiagnostics.end(), warning.code,
                       [](const Diagnostic& d, const std::string& code) { return d.code < code; });
  const bool isKnown = row != kDiagnostics.end() && row->code == warning.code;
  return isKnown ? row->severity : Severity::Loss;
}

}  // namespace remesher
