// SPDX-License-Identifier: MIT
#include "io/named/abaqus.h"

#include <set>

#include "io/model/dropped.h"
#include "io/named/named_faces.h"
#include "io/text/text_writer.h"

namespace remesher::io {
namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// A label begins with a letter, has letters, digits and _ only, and at most 80 of them; case does
// not count. A number tells those apart that would be the same.
std::string labelFor(const std::string& name, std::set<std::string>& used) {
  constexpr std::size_t kLongest = 70;
  std::string label;
  for (const char c : name.substr(0, kLongest)) {
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    label += isLetter(c) || isDigit(c) ? upper : '_';
  }
  if (label.empty() || !isLetter(label[0])) label = "S_" + label;
  std::string distinct = label;
  for (int i = 2; !used.insert(distinct).second; ++i) distinct = label + "_" + std::to_string(i);
  return distinct;
}

std::vector<std::uint8_t> abaqusBytes(const NamedFaces& surface) {
  TextWriter out(surface.isExact ? Digits::OfDoubles : Digits::Fewest);
  out.text("*HEADING\nSurface mesh written by remesher\n*NODE\n");
  for (std::size_t node = 0; node < surface.positions.size(); ++node) {
    out.integer(node + 1);
    for (const double coordinate : surface.positions[node]) out.text(", ").coordinate(coordinate);
    out.text("\n");
  }
  std::set<std::string> used;
  std::vector<std::string> labels;
  for (const std::string& name : surface.names) labels.push_back(labelFor(name, used));
  std::size_t element = 0;
  for (const auto& run : runsOf(surface)) {
    out.text("*ELEMENT, TYPE=S").integer(run[0].count).text(", ELSET=");
    out.text(labels[run[0].set]).text("\n");
    for (const NamedFaces::Face& face : run) {
      out.integer(++element);
      for (Index corner = 0; corner < face.count; ++corner)
        out.text(", ").integer(face.corners[corner] + 1);
      out.text("\n");
    }
  }
  return out.bytes();
}

}  // namespace

WrittenFiles writeAbaqus(const Model& model, const std::string& outputName) {
  return {{{outputName, abaqusBytes(namedFacesOf(model))}},
          droppedAttributes(model, {kMaterial}, "Abaqus file")};
}

}  // namespace remesher::io
