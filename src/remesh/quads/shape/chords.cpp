// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/chords.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "remesh/quads/mesh/quad_sides.h"
#include "remesh/quads/shape/side_places.h"

namespace remesher {

namespace {

Index oppositeSide(Index side) { return nextSide(nextSide(side)); }

struct Chord {
  std::vector<Index> sides;  // the side by which it enters each quad
  std::size_t vertices = 0;  // the number that dividing it adds
  double width = 0;          // the mean length of the sides that it crosses
};

Chord chordFrom(const QuadMesh& mesh, const QuadSides& sides, Index side) {
  Index first = side;
  for (Index back = sides.across(first); back != kNone; back = sides.across(first)) {
    first = oppositeSide(back);
    if (first == side) break;
  }
  Chord chord;
  Index at = first;
  do {
    chord.sides.push_back(at);
    chord.width += (mesh.position(sides.tip(at)) - mesh.position(sides.origin(at))).norm();
    at = sides.across(oppositeSide(at));
  } while (at != kNone && at != first);
  chord.width /= double(chord.sides.size());
  chord.vertices = chord.sides.size() + (at == kNone ? 1 : 0);
  return chord;
}

// All chords that cross no quad twice, and for each quad the chords that cross it.
struct Chords {
  std::vector<Chord> all;
  std::vector<std::vector<Index>> ofQuad;
};

Chords chordsOf(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  std::vector<char> isSeen(sides.size(), 0);
  Chords chords{{}, std::vector<std::vector<Index>>(mesh.quads.size())};
  for (Index side = 0; side < sides.size(); ++side) {
    if (isSeen[side]) continue;
    Chord chord = chordFrom(mesh, sides, side);
    for (const Index s : chord.sides) isSeen[s] = isSeen[oppositeSide(s)] = 1;
    std::vector<Index> quads;
    for (const Index s : chord.sides) quads.push_back(s / 4);
    std::sort(quads.begin(), quads.end());
    if (std::adjacent_find(quads.begin(), quads.end()) != quads.end()) continue;
    for (const Index q : quads) chords.ofQuad[q].push_back(Index(chords.all.size()));
    chords.all.push_back(std::move(chord));
  }
  return chords;
}

// One chord or two, and the vertices that they add together: one more wherever they cross.
struct Choice {
  std::size_t vertices = 0;
  double width = 0;  // of the narrower one
  Index first = kNone, second = kNone;
  bool isBetterThan(const Choice& other) const {
    return std::tie(vertices, width) > std::tie(other.vertices, other.width);
  }
};

// The choice that adds most vertices, but not more than `most`; among equals the widest.
Choice bestChoice(const Chords& chords, std::size_t most) {
  std::map<std::pair<Index, Index>, std::size_t> crossings;
  for (const std::vector<Index>& both : chords.ofQuad)
    if (both.size() == 2) ++crossings[std::minmax(both[0], both[1])];
  Choice best;
  const auto consider = [&](const Choice& choice) {
    if (choice.vertices <= most && choice.isBetterThan(best)) best = choice;
  };
  for (Index i = 0; i < chords.all.size(); ++i) {
    const Chord& one = chords.all[i];
    consider({one.vertices, one.width, i, kNone});
    if (one.vertices >= most) continue;
    for (Index k = i + 1; k < chords.all.size(); ++k) {
      const Chord& two = chords.all[k];
      if (one.vertices + two.vertices > most) continue;
      const auto met = crossings.find({i, k});
      const std::size_t shared = met == crossings.end() ? 0 : met->second;
      consider({one.vertices + two.vertices + shared, std::min(one.width, two.width), i, k});
    }
  }
  return best;
}

void divide(QuadMesh& mesh, const Chord& chord, const WorkingMesh& ground) {
  const auto add = [&](Index side) {
    mesh.vertices.push_back(middleOf(mesh, side, ground));
    return Index(mesh.vertices.size() - 1);
  };
  const std::size_t count = chord.sides.size();
  std::vector<Index> middles;
  for (const Index side : chord.sides) middles.push_back(add(side));
  middles.push_back(chord.vertices > count ? add(oppositeSide(chord.sides.back())) : middles[0]);
  for (std::size_t i = 0; i < count; ++i) {
    const Index quad = chord.sides[i] / 4, turn = chord.sides[i] % 4;
    const Index in = middles[i], out = middles[i + 1];
    Four<Index> corners{}, curves{};
    for (Index k = 0; k < 4; ++k) {
      corners[k] = mesh.quads[quad][(turn + k) % 4];
      curves[k] = mesh.curves[quad][(turn + k) % 4];
    }
    mesh.quads[quad] = {corners[0], in, out, corners[3]};
    mesh.curves[quad] = {curves[0], kNone, curves[2], curves[3]};
    mesh.quads.push_back({in, corners[1], corners[2], out});
    mesh.curves.push_back({curves[0], curves[1], curves[2], kNone});
  }
}

Index sideBetween(const QuadMesh& mesh, Index a, Index b) {
  for (Index q = 0; q < mesh.quads.size(); ++q)
    for (Index i = 0; i < 4; ++i)
      if (mesh.quads[q][i] == a && mesh.quads[q][(i + 1) % 4] == b) return sideOf(q, i);
  return kNone;
}

// The second chord is found again after the first has divided the quads where they cross.
void divideChoice(QuadMesh& mesh, const Chords& chords, const Choice& choice,
                  const WorkingMesh& ground) {
  if (choice.second == kNone) return divide(mesh, chords.all[choice.first], ground);
  const Index side = chords.all[choice.second].sides.front();
  const Index a = mesh.quads[side / 4][side % 4], b = mesh.quads[side / 4][(side + 1) % 4];
  divide(mesh, chords.all[choice.first], ground);
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  divide(mesh, chordFrom(mesh, sides, sideBetween(mesh, a, b)), ground);
}

}  // namespace

void divideChords(QuadMesh& mesh, const WorkingMesh& ground, std::size_t count) {
  while (mesh.vertices.size() < count) {
    const Chords chords = chordsOf(mesh);
    const Choice choice = bestChoice(chords, count - mesh.vertices.size());
    if (choice.first == kNone) return;
    divideChoice(mesh, chords, choice, ground);
  }
}

void divideShortestChord(QuadMesh& mesh, const WorkingMesh& ground, std::size_t least) {
  const Chords chords = chordsOf(mesh);
  const Chord* shortest = nullptr;
  for (const Chord& chord : chords.all)
    if (chord.vertices >= least && (!shortest || chord.vertices < shortest->vertices))
      shortest = &chord;
  if (shortest) divide(mesh, *shortest, ground);
}

}  // namespace remesher
