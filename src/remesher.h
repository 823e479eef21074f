// SPDX-License-Identifier: MIT
// The public C++ interface: everything the bindings need, and all that a C++ program should
// include. Every failure the caller can cause is an Error; nothing here prints, exits or keeps
// state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/boolean.h"
#include "base/diagnostics.h"
#include "base/error.h"
#include "base/file.h"
#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "base/types.h"

namespace remesher {

struct RemeshResult {
  TriangleMesh mesh;
  Report report;
  std::vector<TriangleMesh> lods;  // coarser levels of detail, as they were asked for
};

RemeshResult remesh(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress = {});

// A mesh of a scene, and the places where it is shown: transforms from its own space to the world.
struct PlacedMesh {
  TriangleMesh mesh;
  std::vector<Transform> places;
  // Numbers of the meshes that this mesh stands for from afar. If any, it is a coarser level of
  // detail, keeps its proportion to them, and the report leaves it out.
  std::vector<std::size_t> finer = {};
};

struct RemeshSceneResult {
  std::vector<TriangleMesh> meshes;  // in the order given
  Report report;
  std::vector<std::vector<TriangleMesh>> lods;  // the same for each coarser level of detail
};

// Remeshes meshes that share the target as those of one file do: vertices by area in the world.
RemeshSceneResult remeshScene(std::vector<PlacedMesh> scene, const RemeshOptions& options,
                              const Progress& progress = {});

// A file with the files that it refers to (a .bin, images, a .mtl), by the names that it uses.
struct FileBundle {
  File file;
  std::vector<File> resources;
  std::vector<Picture> pictures = {};
  ScanSlabs slabs = {};  // for remeshFile; of one slab the result is its thinned-out triangles
};

struct RemeshFileResult {
  // The file asked for first, then those beside it: a .bin, a .mtl, other levels of detail.
  std::vector<File> files;
  std::vector<Picture> pictures;  // baked: the files refer to the n-th as painting:n
  Report report;
};

RemeshFileResult remeshFile(FileBundle input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress = {});

struct RepairResult {
  TriangleMesh mesh;
  Report report;  // without distances
};

// Only repairs, as the options for repair say; all other options are ignored.
RepairResult repair(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress = {});
RemeshFileResult repairFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress = {});

struct BooleanResult {
  TriangleMesh mesh;
  Report report;  // input: of both operands; without distances
  BooleanReport boolean;
};

// The union, difference or intersection of two bodies, exactly, with the attributes of both. The
// operands are made closed first, by the exact steps of repair. What nothing cuts stays as it is,
// bit for bit. Throws Error as repair does, and INVALID_MESH if an operand stays open, NO_TRIANGLES
// if nothing is left.
BooleanResult boolean(const TriangleMesh& a, const TriangleMesh& b, BooleanOperation operation,
                      const Progress& progress = {});

struct BooleanFilesResult {
  std::vector<File> files;  // as above
  Report report;
  BooleanReport boolean;
};

// The same of all bodies that each file shows, in the world.
BooleanFilesResult booleanFiles(const FileBundle& a, const FileBundle& b,
                                BooleanOperation operation, const std::string& outputName,
                                const Progress& progress = {});

struct BakeResult {
  TriangleMesh mesh;          // the low mesh with texture coordinates, normals and tangents
  std::vector<Picture> maps;  // baseColor, surface, emissive, normal: those that are needed
  Report report;              // of the low mesh, with its atlas; without distances
};

// Paints one mesh onto another: its colours and, as normals, its shape. The low mesh keeps its
// vertices, in their order (copies on seams follow behind), its triangles, and its texture
// coordinates if they are unique; else it gets new ones. Of the options those for textures, `cage`
// and `ao` count.
BakeResult bake(const TriangleMesh& high, const TriangleMesh& low, const RemeshOptions& options,
                const Progress& progress = {});
// The same of all that one file shows onto the meshes of another, written as glTF.
RemeshFileResult bakeFiles(FileBundle high, const FileBundle& low, const std::string& outputName,
                           const RemeshOptions& options, const Progress& progress = {});

struct UnwrapResult {
  TriangleMesh mesh;
  Report report;  // with its atlas; without distances
};

// New texture coordinates, as TEXCOORD_0; vertices and triangles stay as above. Of the options
// `textureSize` counts.
UnwrapResult unwrap(const TriangleMesh& mesh, const RemeshOptions& options,
                    const Progress& progress = {});
RemeshFileResult unwrapFile(const FileBundle& input, const std::string& outputName,
                            const RemeshOptions& options, const Progress& progress = {});

struct ConvertFileResult {
  std::vector<File> files;  // as above
  std::vector<Warning> warnings;
};

// Writes the same model in another format, with unchanged triangles.
ConvertFileResult convertFile(const FileBundle& input, const std::string& outputName);

Report inspect(const TriangleMesh& mesh);
Report inspectFile(const FileBundle& input, const Progress& progress = {});

// A report, and what is broken, which takes longer than inspect. Without faults if there is no room
// to look for them: the warning FAULTS_NOT_SOUGHT says why.
struct CloseInspection {
  Report report;
  std::optional<FaultReport> faults;
};
CloseInspection inspectClosely(const TriangleMesh& mesh);
CloseInspection inspectFileClosely(const FileBundle& input, const Progress& progress = {});

// The edges of the mesh by kind.
EdgeReport findEdges(const TriangleMesh& mesh);

}  // namespace remesher
