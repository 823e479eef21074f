// SPDX-License-Identifier: MIT
// Reads options by their names in JavaScript.
#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "choice_names.h"

namespace remesher {

template <class T>
std::vector<T> copied(const emscripten::val& array) {
  std::vector<T> result(array["length"].as<std::size_t>());
  if (!result.empty())
    emscripten::val(emscripten::typed_memory_view(result.size(), result.data()))
        .call<void>("set", array);
  return result;
}

// Reads each option that is set into the field of the same name. A value of another type ('off'
// where a number could be) leaves its field as it is.
struct OptionReader {
  emscripten::val options;

  template <class T>
  void operator()(const char* name, T& field) const {
    if (const emscripten::val value = options[name]; !value.isUndefined()) read(value, field);
  }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  static void read(const emscripten::val& value, T& field) {
    if (value.isNumber()) field = value.as<T>();
  }
  static void read(const emscripten::val& value, bool& field) { field = value.isTrue(); }
  template <class E>
  requires std::is_enum_v<E>
  static void read(const emscripten::val& value, E& field) {
    for (const auto& [name, choice] : namesOf(E()))
      if (value.as<std::string>() == name) field = choice;
  }
  template <class T>
  static void read(const emscripten::val& value, std::optional<T>& field) {
    if (std::is_enum_v<T> || value.isNumber()) read(value, field.emplace());
  }
  static void read(const emscripten::val& value, std::vector<double>& field) {
    field = copied<double>(value);
  }
  static void read(const emscripten::val& value, std::vector<Index>& field) {
    field = copied<Index>(value);
  }
  static void read(const emscripten::val& value, std::vector<float>& field) {
    field = copied<float>(value);
  }
  static void read(const emscripten::val& value, std::vector<std::pair<Index, Index>>& field) {
    const std::vector<Index> flat = copied<Index>(value);
    for (std::size_t i = 0; i + 1 < flat.size(); i += 2) field.emplace_back(flat[i], flat[i + 1]);
  }
  // A line that ends where it begins is closed, and so is every loop.
  static void read(const emscripten::val& value, std::vector<Guide>& field) {
    const auto count = value["length"].as<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
      const emscripten::val object = value[i];
      Guide guide;
      read(object["kind"], guide.kind);
      guide.name = object["name"].as<std::string>();
      const std::vector<double> flat = copied<double>(object["points"]);
      for (std::size_t k = 0; k + 2 < flat.size(); k += 3)
        guide.points.emplace_back(flat[k], flat[k + 1], flat[k + 2]);
      const bool isReturning = guide.points.front() == guide.points.back();
      guide.isClosed = isReturning || guide.kind == GuideKind::Loop;
      if (isReturning) guide.points.pop_back();
      field.push_back(std::move(guide));
    }
  }
};

}  // namespace remesher
