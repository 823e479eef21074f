// SPDX-License-Identifier: MIT
// Growth keeps this true: the held faces are a disk and every vertex is met at most once by its
// rim. Hence a new face f that shares
//   one side   keeps the disk unless its opposite vertex is already held: Figure 2, a hole or a
//              pinched vertex would appear;
//   two sides  always keeps it: the two meet at a rim vertex, which becomes an inner one;
//   no side    is not connected, and three sides close the surface: both refused.
#include "original/patches/disk_patch.h"

#include <algorithm>

namespace remesher {

DiskGrower::DiskGrower(const HalfedgeMesh& mesh, std::span<const char> barriers)
    : mesh_(mesh),
      barriers_(barriers),
      faceStamp_(mesh.faceCapacity(), 0),
      vertexStamp_(mesh.vertexCapacity(), 0),
      faceNumber_(mesh.faceCapacity(), 0),
      vertexNumber_(mesh.vertexCapacity(), 0) {}

void DiskGrower::renewStamp() {
  if (++stamp_ != 0) return;
  // The stamps have wrapped around: no stamp of the first round may remain.
  std::fill(faceStamp_.begin(), faceStamp_.end(), 0);
  std::fill(vertexStamp_.begin(), vertexStamp_.end(), 0);
  stamp_ = 1;
}

void DiskGrower::clear() {
  faces_.clear();
  renewStamp();
}

Face DiskGrower::neighbor(Halfedge side) const {
  if (!barriers_.empty() && barriers_[side.index]) return Face();
  const Halfedge t = mesh_.twin(side);
  return t ? HalfedgeMesh::face(t) : Face();
}

bool DiskGrower::staysDisk(Face f) const {
  int shared = 0;
  Halfedge lastShared;
  for (int i = 0; i < 3; ++i) {
    const Halfedge side = HalfedgeMesh::halfedge(f, i);
    const Halfedge t = mesh_.twin(side);
    if (!t || !holds(HalfedgeMesh::face(t))) continue;
    // If the face across a barrier is held, both sides of the barrier would lie on the rim.
    if (!neighbor(side)) return false;
    ++shared;
    lastShared = side;
  }
  if (shared != 1) return shared == 2;
  return vertexStamp_[mesh_.opposite(lastShared).index] != stamp_;
}

bool DiskGrower::add(Face f) {
  if (holds(f) || faces_.size() == kMaxFaces) return false;
  if (!faces_.empty() && !staysDisk(f)) return false;
  faceStamp_[f.index] = stamp_;
  for (const Vertex v : mesh_.vertices(f)) vertexStamp_[v.index] = stamp_;
  faces_.push_back(f);
  return true;
}

bool DiskGrower::isEar(Face f) const {
  int shared = 0, free = 0;
  for (int i = 0; i < 3; ++i) {
    const Face g = neighbor(HalfedgeMesh::halfedge(f, i));
    if (!g) continue;
    ++(holds(g) ? shared : free);
  }
  return shared == 1 && free > 0;
}

void DiskGrower::removeEar(Face f) {
  faceStamp_[f.index] = 0;
  for (int i = 0; i < 3; ++i) {
    const Halfedge side = HalfedgeMesh::halfedge(f, i);
    const Face g = neighbor(side);
    if (!g || !holds(g)) continue;
    vertexStamp_[mesh_.opposite(side).index] = 0;  // no other held face had the tip
    earCandidates_.push_back(g);                   // g may have become an ear itself
  }
}

void DiskGrower::trimEars(std::span<const Face> kept) {
  constexpr Index kSpared = 1, kTrimmable = 0;
  for (const Face f : faces_) faceNumber_[f.index] = kTrimmable;
  for (const Face f : kept) faceNumber_[f.index] = kSpared;
  earCandidates_ = faces_;
  while (!earCandidates_.empty()) {
    const Face f = earCandidates_.back();
    earCandidates_.pop_back();
    if (holds(f) && faceNumber_[f.index] == kTrimmable && isEar(f)) removeEar(f);
  }
  std::erase_if(faces_, [&](Face f) { return !holds(f); });
}

void DiskGrower::numberVertices() {
  patch_.vertices.clear();
  renewStamp();  // vertices get their stamp anew as they are numbered
  for (const Face f : faces_) {
    faceStamp_[f.index] = stamp_;
    for (const Vertex v : mesh_.vertices(f)) {
      if (vertexStamp_[v.index] == stamp_) continue;
      vertexStamp_[v.index] = stamp_;
      vertexNumber_[v.index] = Index(patch_.vertices.size());
      patch_.vertices.push_back(v);
    }
  }
}

void DiskGrower::linkFaces() {
  for (std::size_t i = 0; i < faces_.size(); ++i) faceNumber_[faces_[i].index] = Index(i);
  patch_.faces.resize(faces_.size());
  for (std::size_t n = 0; n < faces_.size(); ++n) {
    LocalFace& local = patch_.faces[n];
    local.face = faces_[n].index;
    for (int i = 0; i < 3; ++i) {
      const Halfedge side = HalfedgeMesh::halfedge(faces_[n], i);
      const Face g = neighbor(side);
      local.corners[i] = LocalIndex(vertexNumber_[mesh_.origin(side).index]);
      local.across[i] = g && holds(g) ? LocalIndex(faceNumber_[g.index]) : kNoLocal;
    }
  }
}

// Follows the rim from corner to corner and applies Euler's formula: a connected surface with one
// simple rim loop and V − E + F = 1 is a disk.
bool DiskGrower::traceRim() {
  nextOnRim_.assign(patch_.vertices.size(), kNoLocal);
  std::size_t length = 0;
  LocalIndex start = kNoLocal;
  for (const LocalFace& f : patch_.faces) {
    for (int i = 0; i < 3; ++i) {
      if (f.across[i] != kNoLocal) continue;
      if (nextOnRim_[f.corners[i]] != kNoLocal) return false;
      nextOnRim_[f.corners[i]] = f.corners[(i + 1) % 3];
      start = f.corners[i];
      ++length;
    }
  }
  patch_.rim.clear();
  for (LocalIndex v = start; v != kNoLocal && patch_.rim.size() < length; v = nextOnRim_[v]) {
    if (v == start && !patch_.rim.empty()) break;
    patch_.rim.push_back(v);
  }
  const std::size_t edges = (3 * patch_.faces.size() + length) / 2;
  return length >= 3 && patch_.rim.size() == length &&
         patch_.vertices.size() + patch_.faces.size() == edges + 1;
}

const DiskPatch* DiskGrower::cut() {
  if (faces_.empty()) return nullptr;
  numberVertices();
  linkFaces();
  return traceRim() ? &patch_ : nullptr;
}

}  // namespace remesher
