// SPDX-License-Identifier: MIT
// A Boolean of two operands, with its report.
#pragma once

#include "base/boolean.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/operands.h"

namespace remesher {

struct BooleanRun {
  io::Part part;  // with the groups of both operands
  Report report;  // of both operands as input; without the times
  BooleanReport boolean;
};

// Makes closed bodies of the operands, by the exact steps of repair, and arranges them. Throws
// Error: INVALID_MESH, if an operand stays open or encloses nothing; NO_TRIANGLES, if the result is
// empty; UNSUPPORTED, if the operands cannot be cut along each other.
BooleanRun runBoolean(OperandPair pair, BooleanOperation operation, const Progress& progress);

}  // namespace remesher
