// SPDX-License-Identifier: MIT
#include "repair/sheet_bodies.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "arrangement/points.h"
#include "base/disjoint_sets.h"
#include "geometry/box.h"
#include "geometry/triangle.h"
#include "mesh/edge_groups.h"
#include "mesh/mesh_builder.h"
#include "repair/flat_base.h"
#include "repair/holes/plug.h"
#include "repair/holes/turn_over.h"

namespace remesher {

namespace {

Vec3 normalOf(const BuiltMesh& built, Face f) {
  const auto [a, b, c] = built.mesh.vertices(f);
  return unitNormal(built.positions[a], built.positions[b], built.positions[c]);
}

// The way that moves the planes of all triangles around the vertex by a unit, as nearly as there
// is one; along flat directions it does not move.
Vec3 wayOf(const BuiltMesh& built, Vertex v) {
  constexpr double kFlat = 0.05;  // of the largest eigenvalue: planes some 25 degrees apart
  constexpr double kLongestMitre = 3;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 sum = Vec3::Zero();
  built.mesh.forEachOutgoing(v, [&](Halfedge h) {
    const Face f = HalfedgeMesh::face(h);
    const auto [a, b, c] = built.mesh.vertices(f);
    const std::array<double, 3> own =
        angles(built.positions[a], built.positions[b], built.positions[c]);
    const double weight = own[v == a ? 0 : v == b ? 1 : 2];
    const Vec3 normal = normalOf(built, f);
    moments += weight * normal * normal.transpose();
    sum += weight * normal;
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  const double largest = solver.eigenvalues()[2];
  Vec3 way = Vec3::Zero();
  for (int k = 0; k < 3 && largest > 0; ++k)
    if (solver.eigenvalues()[k] > kFlat * largest)
      way += solver.eigenvectors().col(k).dot(sum) / solver.eigenvalues()[k] *
             solver.eigenvectors().col(k);
  return way.norm() > kLongestMitre ? Vec3(kLongestMitre / way.norm() * way) : way;
}

// The axis that the triangles face, and which way.
struct Upright {
  Eigen::Index axis = 2;
  double sign = 1;
};

class BodyMaker {
 public:
  BodyMaker(const TriangleMesh& mesh, BuiltMesh built, const BodyRule& rule)
      : input_(mesh),
        rule_(rule),
        built_(std::move(built)),
        loops_(boundaryLoops(built_)),
        components_(built_.mesh.vertexCapacity()) {
    for (Index f = 0; f < built_.mesh.faceCapacity(); ++f) {
      const auto [a, b, c] = built_.mesh.vertices(Face(f));
      components_.unite(a.index, b.index);
      components_.unite(b.index, c.index);
    }
    result_.mesh = mesh;
    result_.mesh.isQuads = false;
    result_.mesh.indices.clear(), result_.mesh.groups.clear();
    for (const Attribute& attribute : mesh.attributes)
      hasNormals_ = hasNormals_ || (attribute.semantic == "NORMAL" && attribute.itemSize == 3);
  }

  SheetBodies run() {
    std::map<Index, std::vector<const Loop*>> sheets;  // the loops of each open component
    for (const Loop& loop : loops_)
      sheets[components_.find(loop.vertices.front().index)].push_back(&loop);
    std::map<Index, std::vector<Face>> faces;
    keepClosed(sheets, faces);
    for (const auto& [component, loops] : sheets) {
      if (rule_.kind == BodyRule::Kind::Thick)
        thicken(faces[component], loops);
      else if (!putOnBase(faces[component], loops))
        continue;
      note(faces[component]);
    }
    return std::move(result_);
  }

  // Of a double cover: it moves as a whole, and walls join the edges of a triangle's two copies.
  SheetBodies runOnCover() {
    std::vector<Face> faces(input_.triangleCount());
    for (Index f = 0; f < faces.size(); ++f) faces[built_.triangles[Face(f)]] = Face(f);
    std::map<std::pair<Index, Index>, Index> copies;  // by vertex and wedge
    const auto copyAt = [&](Halfedge h) {
      const Vertex v = built_.mesh.origin(h);
      const auto [known, isNew] = copies.try_emplace({v.index, wedge(h)});
      if (isNew)
        known->second =
            copyOf(wedge(h), built_.positions[v] + rule_.thickness / 2 * wayOf(built_, v));
      return known->second;
    };
    std::vector<Index> back;
    for (Index t = 0; t < faces.size(); ++t) {
      std::array<Index, 3> corners;
      for (int k = 0; k < 3; ++k)
        corners[std::size_t(k)] = copyAt(HalfedgeMesh::halfedge(faces[t], k));
      if (isBack(t)) std::swap(corners[1], corners[2]), back.push_back(t);
      append(corners, faces[t]);
    }
    turnOver(result_.mesh, back);
    for (const Loop& loop : loops_)
      for (const Halfedge h : loop.across) {
        const Index t = built_.triangles[HalfedgeMesh::face(h)];
        if (isBack(t)) continue;
        const Halfedge other =
            HalfedgeMesh::halfedge(faces[t + faces.size() / 2], int(2 - h.index % 3));
        addWall(h, {copyAt(h), copyAt(HalfedgeMesh::next(h)), copyAt(HalfedgeMesh::next(other)),
                    copyAt(other)});
      }
    noteBodies();
    return std::move(result_);
  }

 private:
  bool isBack(Index coverTriangle) const { return 2 * coverTriangle >= input_.triangleCount(); }

  void noteBodies() {
    std::map<Index, std::vector<Face>> bodies;
    for (Index f = 0; f < built_.mesh.faceCapacity(); ++f)
      bodies[components_.find(built_.mesh.vertices(Face(f))[0].index)].emplace_back(f);
    for (const auto& [component, faces] : bodies) note(faces);
  }

  // The triangles of closed components, and with a base those of all, as they are.
  void keepClosed(const std::map<Index, std::vector<const Loop*>>& sheets,
                  std::map<Index, std::vector<Face>>& faces) {
    std::vector<Face> inOrder;
    for (Index f = 0; f < built_.mesh.faceCapacity(); ++f) inOrder.emplace_back(f);
    std::sort(inOrder.begin(), inOrder.end(),
              [&](Face f, Face g) { return built_.triangles[f] < built_.triangles[g]; });
    for (const Face f : inOrder) {
      const Index component = components_.find(built_.mesh.vertices(f)[0].index);
      const bool isOpen = sheets.count(component) > 0;
      if (isOpen) faces[component].push_back(f);
      if (!isOpen || rule_.kind == BodyRule::Kind::Base) append(cornersOf(f), f);
    }
  }

  std::array<Index, 3> cornersOf(Face f) const {
    return {wedge(HalfedgeMesh::halfedge(f, 0)), wedge(HalfedgeMesh::halfedge(f, 1)),
            wedge(HalfedgeMesh::halfedge(f, 2))};
  }
  Index wedge(Halfedge h) const { return built_.wedges[h]; }

  void append(const std::array<Index, 3>& corners, Face like) {
    TriangleMesh& mesh = result_.mesh;
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
    if (!input_.groups.empty()) mesh.groups.push_back(input_.groups[built_.triangles[like]]);
  }

  Index copyOf(Index vertex, const Vec3& place) {
    TriangleMesh& mesh = result_.mesh;
    mesh.positions.push_back(input_.isSingle ? inSingle(place, input_.frame) : place);
    for (Attribute& attribute : mesh.attributes)
      for (int k = 0; k < attribute.itemSize; ++k)
        attribute.values.push_back(
            attribute
                .values[std::size_t{vertex} * std::size_t(attribute.itemSize) + std::size_t(k)]);
    return Index(mesh.positions.size() - 1);
  }

  Index copyFacing(Index vertex, const Vec3& place, const Vec3& normal) {
    const Index copy = copyOf(vertex, place);
    for (Attribute& attribute : result_.mesh.attributes)
      if (attribute.semantic == "NORMAL" && attribute.itemSize == 3)
        for (Eigen::Index k = 0; k < 3; ++k)
          attribute.values[3 * std::size_t{copy} + std::size_t(k)] = float(normal[k]);
    return copy;
  }

  // Both sides of a sheet: per halfedge the copies of its origin's wedge.
  void thicken(const std::vector<Face>& faces, const std::vector<const Loop*>& loops) {
    std::map<std::pair<Index, Index>, std::array<Index, 2>> copies;  // by vertex and wedge
    const auto copiesAt = [&](Halfedge h) {
      const Vertex v = built_.mesh.origin(h);
      const auto [known, isNew] = copies.try_emplace({v.index, wedge(h)});
      if (isNew) {
        const Vec3 way = rule_.thickness / 2 * wayOf(built_, v);
        known->second = {copyOf(wedge(h), built_.positions[v] + way),
                         copyOf(wedge(h), built_.positions[v] - way)};
      }
      return known->second;
    };
    std::vector<Index> back;
    for (const std::size_t side : {0U, 1U})
      for (const Face f : faces) {
        if (side == 1) back.push_back(Index(result_.mesh.triangleCount()));
        append({copiesAt(HalfedgeMesh::halfedge(f, 0))[side],
                copiesAt(HalfedgeMesh::halfedge(f, 1))[side],
                copiesAt(HalfedgeMesh::halfedge(f, 2))[side]},
               f);
      }
    turnOver(result_.mesh, back);
    for (const Loop* loop : loops)
      for (const Halfedge h : loop->across) {
        const std::array<Index, 2> a = copiesAt(h), b = copiesAt(HalfedgeMesh::next(h));
        addWall(h, {a[0], b[0], a[1], b[1]});
      }
  }

  // Along the halfedge from the front's a to its b, and from the back's a to its b; the wall faces
  // away from the sheet. Walls have normals of their own.
  void addWall(Halfedge h, std::array<Index, 4> corners) {
    const auto at = [&](std::size_t k) { return result_.mesh.positions[corners[k]]; };
    if (hasNormals_) {
      const Vec3 normal = (at(1) - at(0)).cross(at(0) - at(2)).stableNormalized();
      for (std::size_t k = 0; k < 4; ++k) corners[k] = copyFacing(corners[k], at(k), normal);
    }
    const auto [a, b, c, d] = corners;
    const Face like = HalfedgeMesh::face(h);
    if (at(1) != at(3)) append({b, a, d}, like);
    if (at(0) != at(2) && at(2) != at(3)) append({a, c, d}, like);
  }

  Upright uprightOf(const std::vector<Face>& faces) const {
    Vec3 sum = Vec3::Zero();
    for (const Face f : faces) {
      const auto [a, b, c] = built_.mesh.vertices(f);
      sum += areaVector(built_.positions[a], built_.positions[b], built_.positions[c]);
    }
    Upright up;
    sum.cwiseAbs().maxCoeff(&up.axis);
    up.sign = sum[up.axis] < 0 ? -1 : 1;
    return up;
  }

  // False if the outline meets itself, seen along the axis.
  bool putOnBase(const std::vector<Face>& faces, const std::vector<const Loop*>& loops) {
    const Upright up = uprightOf(faces);
    double lowest = kInfinity;
    for (const Face f : faces)
      for (const Vertex v : built_.mesh.vertices(f))
        lowest = std::min(lowest, up.sign * built_.positions[v][up.axis]);
    const double level = up.sign * (lowest - rule_.thickness);
    Outline outline;
    outline.axis = up.axis;
    std::map<std::array<double, 2>, Index> numbers;  // of points by their places
    std::vector<Index> wedges;                       // per point one above it
    const auto below = [&](Halfedge h) {
      Vec3 p = built_.positions[built_.mesh.origin(h)];
      p[up.axis] = level;
      if (input_.isSingle) p = inSingle(p, input_.frame);
      const FlatView view{up.axis};
      const auto [known, isNew] =
          numbers.emplace(std::array{p[view.u()], p[view.v()]}, Index(outline.points.size()));
      if (isNew) outline.points.push_back(p), wedges.push_back(wedge(h));
      return known->second;
    };
    for (const Loop* loop : loops)
      for (const Halfedge h : loop->across) {
        const Index a = below(h), b = below(HalfedgeMesh::next(h));
        if (a != b) outline.edges.push_back({a, b});
      }
    const std::optional<std::vector<Index>> base = filled(outline);
    if (!base) {
      result_.leftAt.push_back(built_.positions[built_.mesh.vertices(faces.front())[0]]);
      return false;
    }
    std::vector<Index> floor;
    for (std::size_t p = 0; p < wedges.size(); ++p)
      floor.push_back(copyFacing(wedges[p], outline.points[p], -up.sign * Vec3::Unit(up.axis)));
    for (std::size_t i = 0; i < base->size(); i += 3) {
      std::array<Index, 3> corners = {floor[(*base)[i]], floor[(*base)[i + 1]],
                                      floor[(*base)[i + 2]]};
      if (up.sign > 0) std::swap(corners[1], corners[2]);
      append(corners, faces.front());
    }
    for (const Loop* loop : loops)
      for (const Halfedge h : loop->across)
        addWall(h, {wedge(h), wedge(HalfedgeMesh::next(h)), floor[below(h)],
                    floor[below(HalfedgeMesh::next(h))]});
    return true;
  }

  void note(const std::vector<Face>& faces) {
    Box box;
    for (const Face f : faces)
      for (const Vertex v : built_.mesh.vertices(f)) box.extend(built_.positions[v]);
    result_.madeAt.push_back({(box.low + box.high) / 2, (box.high - box.low).norm()});
  }

  const TriangleMesh& input_;
  const BodyRule rule_;
  const BuiltMesh built_;
  const std::vector<Loop> loops_;
  DisjointSets components_;
  bool hasNormals_ = false;
  SheetBodies result_;
};

// Each triangle, and after all of them each once more, turned over.
TriangleMesh onBothSides(const TriangleMesh& mesh) {
  TriangleMesh cover = mesh;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    cover.indices.insert(cover.indices.end(),
                         {mesh.indices[i], mesh.indices[i + 2], mesh.indices[i + 1]});
  cover.groups.insert(cover.groups.end(), mesh.groups.begin(), mesh.groups.end());
  return cover;
}

// The double cover of a surface of one side: where two triangles of the mesh face opposite sides,
// the front of each goes on as the back of the other. It has two sides.
BuiltMesh doubleCover(const TriangleMesh& cover) {
  Welding welding(cover, Twins::Unknown);
  std::vector<Index>& twins = welding.twins;
  const std::vector<Index>& corners = welding.corners;
  const std::size_t half = corners.size() / 2;
  twins.assign(corners.size(), kNone);
  const auto back = [&](Index h) { return Index(half) + h - h % 3 + 2 - h % 3; };
  const auto join = [&](Index h, Index g) { twins[h] = g, twins[g] = h; };
  const EdgeGroups edges(welding.first.size(), std::span(corners).first(half));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() != 2) continue;
    const Index h = edges[e][0], g = edges[e][1];
    const bool agree = corners[h] != corners[g];
    join(h, agree ? g : back(g));
    join(back(h), agree ? back(g) : g);
  }
  return buildMesh(cover, std::move(welding));
}

}  // namespace

SheetBodies bodiesOfSheets(const TriangleMesh& mesh, const BodyRule& rule) {
  return BodyMaker(mesh, buildMesh(mesh), rule).run();
}

SheetBodies bodiesOfOneSided(const TriangleMesh& mesh, double thickness) {
  const TriangleMesh cover = onBothSides(mesh);
  return BodyMaker(cover, doubleCover(cover), {BodyRule::Kind::Thick, thickness}).runOnCover();
}

}  // namespace remesher
