// SPDX-License-Identifier: MIT
#include "io/ply/ply_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/legible.h"

namespace remesher::io {
namespace {

// The destination of a field's values: an attribute, or the positions.
struct Column {
  const PlyField* field;
  Attribute* attribute;  // null: the positions, or nowhere
};

// Allocates all attributes and assigns each field to one.
std::vector<Column> layOut(PlyVertices& vertices, Index count) {
  std::vector<Attribute>& attributes = vertices.mesh.attributes;
  vertices.mesh.positions.resize(count);
  for (const PlyField& field : vertices.fields) {
    const bool isKnown = findAttribute(vertices.mesh, field.semantic) != nullptr;
    if (field.semantic.empty() || field.semantic == "POSITION" || isKnown) continue;
    const int width = widthOf(vertices.fields, field.semantic);
    attributes.push_back({field.semantic, width, std::vector<float>(std::size_t{count} * width)});
  }
  std::vector<Column> columns;
  for (const PlyField& field : vertices.fields) {
    const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& a) {
      return a.semantic == field.semantic;
    });
    columns.push_back({&field, found == attributes.end() ? nullptr : &*found});
  }
  return columns;
}

double nextCoordinate(PlyBody& body, const PlyField& field, Index vertex) {
  const double value = body.next(field.property.type, field.property.name);
  if (std::isfinite(value)) return value;
  body.fail(ErrorCode::NonFinite,
            "the " + legible(field.property.name) + " of vertex " + std::to_string(vertex) +
                " is not finite.",
            "Repair the file: every coordinate must be a finite number.");
}

// Float colours may range to 1 or to 255: only the values show it.
void settleColors(PlyVertices& vertices) {
  for (Attribute& attribute : vertices.mesh.attributes) {
    const bool countsFarther = std::any_of(attribute.values.begin(), attribute.values.end(),
                                           [](float channel) { return channel > 1; });
    if (attribute.semantic != "COLOR_0" || !countsFarther) continue;
    for (PlyField& field : vertices.fields) {
      if (field.semantic != "COLOR_0" || field.one != 1) continue;
      field.one = 255;
      for (std::size_t i = field.component; i < attribute.values.size(); i += attribute.itemSize)
        attribute.values[i] /= 255;
    }
  }
}

}  // namespace

PlyVertices readVertices(PlyBody& body, const PlyElement& element) {
  body.requireRows(element);
  PlyVertices vertices{fieldsOf(element), {}, 0};
  if (widthOf(vertices.fields, "POSITION") != 3)
    body.fail(ErrorCode::ParseError, "the vertices have no x, y and z.", "Is it a PLY of a mesh?");
  const std::vector<Column> columns = layOut(vertices, element.count);
  vertices.mesh.isSingle =
      std::all_of(vertices.fields.begin(), vertices.fields.end(), [](const PlyField& field) {
        return field.semantic != "POSITION" || field.property.type == PlyType::Float32;
      });
  for (Index vertex = 0; vertex < element.count; ++vertex) {
    for (const auto& [field, attribute] : columns) {
      if (field->semantic.empty()) {
        body.skip(field->property);
      } else if (attribute == nullptr) {
        vertices.mesh.positions[vertex][field->component] = nextCoordinate(body, *field, vertex);
      } else {
        const double value = body.next(field->property.type, field->property.name);
        const auto single = static_cast<float>(value / field->one);
        if (!std::isfinite(single)) ++vertices.notFinite;
        attribute->values[std::size_t{vertex} * attribute->itemSize + field->component] =
            std::isfinite(single) ? single : 0.0F;
      }
    }
  }
  settleColors(vertices);
  return vertices;
}

}  // namespace remesher::io
