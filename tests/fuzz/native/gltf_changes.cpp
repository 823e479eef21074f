// SPDX-License-Identifier: MIT
#include "gltf_changes.h"

#include <cstring>
#include <optional>

#include "byte_changes.h"
#include "io/gltf/gltf_document.h"
#include "reading.h"
#include "tree_changes.h"

namespace remesher::fuzz {
namespace {

constexpr int kDeepest = 40;
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;

struct Container {
  Json tree;
  Bytes data;
};

std::size_t wordAt(Input bytes, std::size_t place) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + place, sizeof word);
  return word;
}

// Nothing if it is no JSON object; what lies too deep for recursion is left out.
std::optional<Json> parsed(Input text) {
  const auto isNear = [](int depth, Json::parse_event_t, Json&) { return depth < kDeepest; };
  Json tree = Json::parse(text.begin(), text.end(), isNear, false);
  if (!tree.is_object()) return {};
  return tree;
}

std::optional<Container> openGlb(Input input) {
  if (input.size() < kGlbHeader + kChunkHeader) return {};
  const std::size_t textBegin = kGlbHeader + kChunkHeader;
  const std::size_t textEnd = textBegin + wordAt(input, kGlbHeader);
  if (textEnd > input.size()) return {};
  std::optional<Json> tree = parsed(input.subspan(textBegin, textEnd - textBegin));
  if (!tree) return {};
  const std::size_t dataBegin = std::min(textEnd + kChunkHeader, input.size());
  return Container{std::move(*tree), Bytes(input.begin() + std::ptrdiff_t(dataBegin), input.end())};
}

void change(Container& container, soups::Random& random) {
  if (random.number() < 0.3 && !container.data.empty())
    container.data = changedBytes(std::move(container.data), random);
  else
    changeTree(container.tree, random);
}

}  // namespace

Bytes changedGlb(Input input, unsigned seed) {
  soups::Random random(seed);
  std::optional<Container> container = openGlb(input);
  if (!container) return changedBytes(Bytes(input.begin(), input.end()), random);
  change(*container, random);
  return io::packGlb(container->tree, container->data);
}

Bytes changedGltf(Input input, unsigned seed) {
  soups::Random random(seed);
  auto [text, data] = splitAtZero(input);
  std::optional<Json> tree = parsed(text);
  if (!tree) return changedBytes(Bytes(input.begin(), input.end()), random);
  Container container{std::move(*tree), std::move(data)};
  change(container, random);
  const std::string changed = container.tree.dump(-1, ' ', false, Json::error_handler_t::replace);
  Bytes result(changed.begin(), changed.end());
  result.push_back(0);
  result.insert(result.end(), container.data.begin(), container.data.end());
  return result;
}

}  // namespace remesher::fuzz
