// SPDX-License-Identifier: MIT
// CGAL as a second judge of repaired surfaces, and its alpha wrap as a peer, where CGAL is on the
// machine. The benchmark of repair compiles it; nothing else needs it.
//   cgal_repair judge mesh.off                prints what is wrong as JSON
//   cgal_repair wrap soup.off share out.off   alpha: the diagonal / share; offset: alpha / 30
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace processing = CGAL::Polygon_mesh_processing;

namespace {

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

// Vertices at one place are one, as in the report: a file may list each of them several times.
int judge(Soup soup) {
  processing::merge_duplicate_points_in_polygon_soup(soup.points, soup.triangles);
  const bool isManifold = processing::is_polygon_soup_a_polygon_mesh(soup.triangles);
  if (!isManifold) {
    std::printf("{\"isManifold\": false}\n");
    return 0;
  }
  Mesh mesh;
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  processing::remove_isolated_vertices(mesh);  // does_bound_a_volume crashes at one
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  processing::self_intersections(mesh, std::back_inserter(pairs));
  const bool isClosed = CGAL::is_closed(mesh);
  const bool isBound = isClosed && pairs.empty() && processing::does_bound_a_volume(mesh);
  std::printf("{\"isManifold\": true, \"isClosed\": %s, \"pairs\": %zu, \"boundsVolume\": %s}\n",
              isClosed ? "true" : "false", pairs.size(), isBound ? "true" : "false");
  return 0;
}

int wrap(const Soup& soup, double share, const std::string& path) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  const double alpha =
      std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / share;
  constexpr double kOffset = 30;
  Mesh mesh;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, alpha / kOffset, mesh);
  return CGAL::IO::write_polygon_mesh(path, mesh, CGAL::parameters::stream_precision(17)) ? 0 : 2;
}

}  // namespace

int main(int count, char** words) {
  Soup soup;
  if (count < 3 || !CGAL::IO::read_polygon_soup(words[2], soup.points, soup.triangles)) return 2;
  const std::string task = words[1];
  if (task == "judge") return judge(std::move(soup));
  return count > 4 ? wrap(soup, std::atof(words[3]), words[4]) : 2;
}
