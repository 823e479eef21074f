// SPDX-License-Identifier: MIT
#include "textures/repaint.h"

#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "mesh/joining.h"
#include "textures/atlas_painting.h"

namespace remesher {

namespace {

// The attributes that a group has and keeps when it is painted.
std::set<std::string> keptBy(const io::Part& part, Index group) {
  std::set<std::string> kept;
  for (const Attribute& attribute : part.mesh.attributes) kept.insert(attribute.semantic);
  if (group < part.groups.size())
    for (const std::string& semantic : part.groups[group].lacks) kept.erase(semantic);
  std::erase_if(kept, isPainted);
  return kept;
}

}  // namespace

Repaint::Repaint(const io::Model& model, std::vector<io::Part> given,
                 std::vector<io::NamedImage> images)
    : surfaces_(model.parts),
      originals_(given.empty() ? model.parts : std::move(given)),
      images_(std::move(images)),
      unshaded_(model.conventions == io::Conventions::Gltf ? Unshaded::Flat : Unshaded::Smooth) {
  for (std::vector<io::Part>* parts : {&surfaces_, &originals_})
    for (io::Part& part : *parts)
      part.mesh = io::converted(std::move(part.mesh), model.conventions, io::Conventions::Gltf);
  std::map<std::string, Index> known;
  for (const io::Part& part : originals_) {
    classes_.emplace_back();
    for (Index g = 0; g < groupCount(part.mesh); ++g) {
      const std::string rest = lookOf(part, g).rest;
      classes_.back().push_back(known.emplace(rest, Index(known.size())).first->second);
    }
  }
  classCount_ = known.size();
}

std::vector<io::Part> Repaint::bareParts() const {
  std::vector<io::Part> parts = surfaces_;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    TriangleMesh& mesh = parts[p].mesh;
    std::erase_if(mesh.attributes, [](const Attribute& a) { return isPainted(a.semantic); });
    std::map<std::pair<Index, std::set<std::string>>, Index> firsts;
    std::vector<Index> firstOf;
    for (Index g = 0; g < classes_[p].size(); ++g)
      firstOf.push_back(
          firsts.emplace(std::pair(classes_[p][g], keptBy(originals_[p], g)), g).first->second);
    for (Index& group : mesh.groups) group = firstOf[group];
  }
  return parts;
}

void Repaint::paint(io::Model& model, const std::vector<std::vector<InputPlace>>& places,
                    const RemeshOptions& options, const Progress& progress) const {
  std::vector<char> areGiven;
  for (std::size_t p = 0; p < surfaces_.size(); ++p)
    areGiven.push_back(haveSameContent(surfaces_[p].mesh, originals_[p].mesh));
  std::vector<Index> own(surfaces_.size());
  std::iota(own.begin(), own.end(), Index{0});
  std::vector<double> cages;
  for (const io::Part& original : originals_)
    if (options.cage) cages.push_back(*options.cage / 100 * diagonalOf(original.mesh));
  paintAtlases(
      {originals_, images_, classes_, classes_, places, options, unshaded_, areGiven, own, cages},
      model, Index(classCount_), progress);
  for (Warning& warning : unpaintedMaps(originals_)) model.warnings.push_back(std::move(warning));
  for (Warning& warning : furtherTexcoords(originals_))
    model.warnings.push_back(std::move(warning));
  model.conventions = io::Conventions::Gltf;
}

}  // namespace remesher
