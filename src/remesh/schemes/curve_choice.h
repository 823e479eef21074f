// SPDX-License-Identifier: MIT
// Which edges of the original become feature curves: detected, given by the caller, or seams.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/joints.h"
#include "original/curves/curve_simplification.h"
#include "original/curves/feature_curves.h"
#include "original/curves/seams.h"
#include "original/curves/spikes.h"
#include "remesh/transfer/attribute_transfer.h"

namespace remesher {

struct CurveChoice {
  FeatureCurves curves;
  TransferRules transfer;  // for the attributes whose seams are not kept, or not as curves
  FlatRegions flats;
  std::vector<Warning> warnings;
};

// The edges that curves are chosen from.
struct CurveCandidates {
  CurveEdges edges;
  Seams seams;
  bool isDetecting;  // whether sharp edges are among them
};

// size: the target edge length, model units.
CurveCandidates curveCandidates(const BuiltMesh& built, const TriangleMesh& input,
                                const PartOptions& options, double size);

// Whether flat regions are bordered by curves, or treated like all others.
enum class Flats { Bordered, Unknown };

struct CurveScale {
  double size;                          // the target edge length, model units
  const Spikes& spikes;                 // their corners stay
  const std::vector<Halfedge>& joints;  // they stay, so that cut parts still meet
  Flats flats = Flats::Bordered;
  // Curves are those that edges so many times as long can follow; above 1 borders of materials are
  // released like others, and tips are no corners.
  double followed = 1;
};

CurveChoice chooseCurves(const BuiltMesh& built, const TriangleMesh& input,
                         const PartOptions& options, const CurveScale& scale);

}  // namespace remesher
