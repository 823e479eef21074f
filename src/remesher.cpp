// SPDX-License-Identifier: MIT
// The public functions: files in and out around the scheme, and the report of the run.
#include "remesher.h"

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "schemes/remesh.h"

namespace remesher {

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress) {
  RemeshOutcome outcome = remeshSurface(mesh, options, progress.part("remesh", 0, 0.9));
  const Progress measuring = progress.part("measure", 0.9, 1);
  measuring.at(0);
  Report report;
  report.input = inspectMesh(mesh);
  report.output = inspectMesh(outcome.mesh);
  report.fidelity = measureFidelity(mesh, outcome.mesh);
  report.warnings = std::move(outcome.warnings);
  report.stopped = outcome.stopped;
  measuring.at(1);
  return {std::move(outcome.mesh), std::move(report)};
}

RemeshFileResult remeshFile(const File& input, const std::vector<File>& resources,
                            const std::string& outputName, const RemeshOptions&,
                            const Progress&) {
  return {{File{outputName, input.bytes}}, inspectFile(input, resources)};
}

Report inspect(const TriangleMesh& mesh) {
  Report report;
  report.input = inspectMesh(mesh);
  return report;
}

Report inspectFile(const File& input, const std::vector<File>&) {
  if (input.bytes.empty()) throw Error(ErrorCode::EmptyFile, input.name + " is empty.");
  return {};
}

}  // namespace remesher
