// SPDX-License-Identifier: MIT
// CGAL's isotropic remeshing with its sharp edges held, as a peer of the benchmark of parts, where
// CGAL is on the machine. The benchmark compiles it; nothing else needs it.
//   cgal_peer model.off edge-length result.off
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

namespace {

// Degrees between faces: what is sharp; and how often all edges are looked at.
constexpr double kSharp = 40;
constexpr unsigned kIterations = 10;

}  // namespace

int main(int count, char** words) {
  Mesh mesh;
  std::ifstream in(count > 3 ? words[1] : "");
  if (!in || !(in >> mesh)) return 2;
  auto isSharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  processing::detect_sharp_edges(mesh, kSharp, isSharp);
  processing::isotropic_remeshing(
      faces(mesh), std::atof(words[2]), mesh,
      processing::parameters::number_of_iterations(kIterations).edge_is_constrained_map(isSharp));
  mesh.collect_garbage();
  std::ofstream out(words[3]);
  out.precision(17);
  return out << mesh ? 0 : 2;
}
