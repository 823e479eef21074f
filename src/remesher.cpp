// SPDX-License-Identifier: MIT
// The public functions: files in and out around the scheme, and the report of the run.
#include "remesher.h"

namespace remesher {
namespace {

Report inspected(const TriangleMesh& mesh) {
  Report report;
  report.input.vertices = mesh.positions.size();
  report.input.triangles = mesh.triangleCount();
  return report;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions&, const Progress& progress) {
  progress.at(0);
  RemeshResult result{mesh, inspected(mesh)};
  result.report.output = result.report.input;
  progress.at(1);
  return result;
}

RemeshFileResult remeshFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions&, const Progress&) {
  return {{File{outputName, input.file.bytes}}, inspectFile(input)};
}

Report inspect(const TriangleMesh& mesh) { return inspected(mesh); }

Report inspectFile(const FileBundle& input) {
  if (input.file.bytes.empty()) throw Error(ErrorCode::EmptyFile, input.file.name + " is empty.");
  return {};
}

}  // namespace remesher
