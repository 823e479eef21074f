// SPDX-License-Identifier: MIT
// Two rounds of growth by distance from seeds. In the first round cells fill up one after another
// and leave fragments between them. In the second round all large enough cells grow at once from
// their middles, which distributes the fragments and evens the cells. Faces outside every cone are
// then filled up one cell after another again.
#include "original/patches/face_cells.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "geometry/triangle.h"

namespace remesher {

namespace {

// The normals of a cell lie within acos(0.3) = 72° of its seed's normal: a cell that wraps a finger
// like a sock would have a useless, squeezed image in the disk.
constexpr float kCellCone = 0.3f;

// Cells of the first round below this share of the wanted size are fragments.
constexpr std::size_t kFragmentShare = 4;

struct Candidate {
  Face face;
  Index cell;
};

// A queue, nearest first to within 6 %: one bucket per eighth of an octave of the squared distance,
// read from the float's bits (std::bit_cast is not everywhere). Much faster than a heap.
class NearestFirst {
 public:
  void push(float squaredDistance, const Candidate& candidate) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &squaredDistance, sizeof bits);
    // A candidate nearer than the current bucket joins the current bucket.
    const std::size_t bucket = std::min<std::size_t>(bits >> 20, buckets_.size() - 1);
    buckets_[std::max(bucket, current_)].push_back(candidate);
    ++count_;
  }

  bool isEmpty() const { return count_ == 0; }

  Candidate pop() {
    for (; next_ == buckets_[current_].size(); ++current_, next_ = 0) buckets_[current_].clear();
    --count_;
    return buckets_[current_][next_++];
  }

  // Call when the queue is empty, before filling it anew.
  void rewind() {
    buckets_[current_].clear();
    current_ = next_ = 0;
  }

 private:
  // One bucket for each value of the first 11 bits of a float without its sign.
  std::vector<std::vector<Candidate>> buckets_ = std::vector<std::vector<Candidate>>(2048);
  std::size_t current_ = 0, next_ = 0, count_ = 0;
};

}  // namespace

FaceData<FaceFrame> faceFrames(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  FaceData<FaceFrame> frames(mesh.faceCapacity());
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const Face f(i);
    if (!mesh.isAlive(f)) continue;
    const auto [a, b, c] = mesh.vertices(f);
    const Vec3 &p = positions[a], &q = positions[b], &r = positions[c];
    frames[f] = {((p + q + r) / 3).cast<float>(), unitNormal(p, q, r).cast<float>()};
  }
  return frames;
}

class CellGrowth {
 public:
  CellGrowth(const HalfedgeMesh& mesh, const FaceData<FaceFrame>& frames,
             std::span<const char> barriers, std::size_t size)
      : mesh_(mesh), frames_(frames), barriers_(barriers), size_(size) {}

  FaceCells run() {
    clear();
    fillUp();
    const std::vector<Seed> middles = middlesOfLargeCells();
    clear();
    growTogether(middles);
    fillUp();
    return pack();
  }

 private:
  struct Seed {
    Face face;
    Eigen::Vector3f normal;
  };
  void clear() {
    cell_.assign(mesh_.faceCapacity(), kNone);
    offered_.assign(mesh_.faceCapacity(), kNone);
    seeds_.clear();
    taken_.clear();
  }

  // A face's distance does not depend on the side from which it is reached: one offer per cell is
  // enough.
  void push(Face f, Index cell) {
    if (offered_[f] == cell) return;
    offered_[f] = cell;
    const Seed& seed = seeds_[cell];
    const FaceFrame &frame = frames_[f], &seedFrame = frames_[seed.face];
    const bool flat = frame.normal.isZero(0) || seed.normal.isZero(0) ||
                      frame.normal.dot(seed.normal) > kCellCone;
    if (!flat && f != seed.face) return;
    queue_.push((frame.centroid - seedFrame.centroid).squaredNorm(), {f, cell});
  }

  void take(Face f, Index cell) {
    cell_[f] = cell;
    taken_.push_back(f);
    for (int i = 0; i < 3; ++i) {
      const Halfedge side = HalfedgeMesh::halfedge(f, i);
      const Halfedge t = mesh_.twin(side);
      if (!t || (!barriers_.empty() && barriers_[side.index])) continue;
      if (cell_[HalfedgeMesh::face(t)] == kNone) push(HalfedgeMesh::face(t), cell);
    }
  }

  // Fills one cell from one seed; the faces left at its rim become the next seeds.
  void fill(Face seed) {
    const Index cell = Index(seeds_.size());
    seeds_.push_back({seed, frames_[seed].normal});
    push(seed, cell);
    std::size_t count = 0;
    while (!queue_.isEmpty()) {
      const Face f = queue_.pop().face;
      if (cell_[f] != kNone) continue;
      if (count == size_) {
        frontier_.push_back(f);
      } else {
        take(f, cell);
        ++count;
      }
    }
    queue_.rewind();
  }

  void fillUp() {
    frontier_.clear();
    std::size_t head = 0;
    for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
      const Face f(i);
      if (!mesh_.isAlive(f) || cell_[f] != kNone) continue;
      fill(f);
      for (; head < frontier_.size(); ++head)
        if (cell_[frontier_[head]] == kNone) fill(frontier_[head]);
    }
  }

  std::vector<Seed> middlesOfLargeCells() const {
    std::vector<Seed> middles;
    for (std::size_t first = 0, last; first < taken_.size(); first = last) {
      const Index cell = cell_[taken_[first]];
      Eigen::Vector3f centre = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
      for (last = first; last < taken_.size() && cell_[taken_[last]] == cell; ++last) {
        centre += frames_[taken_[last]].centroid;
        normal += frames_[taken_[last]].normal;
      }
      if (last - first < size_ / kFragmentShare) continue;
      centre /= float(last - first);
      const auto nearer = [&](Face f, Face g) {
        return (frames_[f].centroid - centre).squaredNorm() <
               (frames_[g].centroid - centre).squaredNorm();
      };
      const auto begin = taken_.begin();
      const Face middle =
          *std::min_element(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(last), nearer);
      middles.push_back({middle, normal.normalized()});
    }
    return middles;
  }

  void growTogether(const std::vector<Seed>& middles) {
    seeds_ = middles;
    for (Index cell = 0; cell < seeds_.size(); ++cell) push(seeds_[cell].face, cell);
    while (!queue_.isEmpty()) {
      const Candidate nearest = queue_.pop();
      if (cell_[nearest.face] == kNone) take(nearest.face, nearest.cell);
    }
    queue_.rewind();
  }

  // Faces grouped by cell, those of a cell in the order they were taken.
  FaceCells pack() {
    FaceCells cells;
    cells.firstFace_.assign(seeds_.size() + 1, 0);
    for (const Face f : taken_) ++cells.firstFace_[cell_[f] + 1];
    for (std::size_t c = 0; c < seeds_.size(); ++c) cells.firstFace_[c + 1] += cells.firstFace_[c];
    std::vector<Index> next(cells.firstFace_.begin(), cells.firstFace_.end() - 1);
    cells.faces_.resize(taken_.size());
    for (const Face f : taken_) cells.faces_[next[cell_[f]]++] = f;
    cells.cell_ = std::move(cell_);
    return cells;
  }

  const HalfedgeMesh& mesh_;
  const FaceData<FaceFrame>& frames_;
  std::span<const char> barriers_;
  const std::size_t size_;
  FaceData<Index> cell_;
  FaceData<Index> offered_;  // the last cell that reached the face, taken or not
  std::vector<Seed> seeds_;
  std::vector<Face> taken_;  // in order; while filling up, cell after cell
  NearestFirst queue_;
  std::vector<Face> frontier_;
};

FaceCells partitionFaces(const HalfedgeMesh& mesh, const FaceData<FaceFrame>& frames,
                         std::span<const char> barriers, std::size_t size) {
  return CellGrowth(mesh, frames, barriers, size).run();
}

}  // namespace remesher
