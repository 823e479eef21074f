// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_packing.h"

#include <algorithm>
#include <utility>

#include "io/gltf/gltf_references.h"

namespace remesher::io {
namespace {

int asIndex(const Json& number) { return number.is_number_integer() ? number.get<int>() : -1; }

// Removes the elements of tree[list] that are in `candidates` and that `forEach` does not visit.
// Returns the removed elements; renumbers the numbers that `forEach` visits.
std::vector<Json> removeUnused(Json& tree, const char* list, const std::set<int>& candidates,
                               void (*forEach)(Json&, const NumberVisitor&)) {
  std::set<int> unused = candidates;
  forEach(tree, [&](Json& number) { unused.erase(asIndex(number)); });
  if (unused.empty() || !tree.contains(list)) return {};
  std::vector<Json> removed;
  Json kept = Json::array();
  std::vector<std::size_t> newNumbers;
  for (std::size_t i = 0; i < tree[list].size(); ++i) {
    newNumbers.push_back(kept.size());
    if (unused.count(static_cast<int>(i)) == 1)
      removed.push_back(std::move(tree[list][i]));
    else
      kept.push_back(std::move(tree[list][i]));
  }
  forEach(tree, [&](Json& number) {
    const int index = asIndex(number);
    if (index >= 0 && static_cast<std::size_t>(index) < newNumbers.size())
      number = newNumbers[index];
  });
  if (kept.empty())
    tree.erase(list);
  else
    tree[list] = std::move(kept);
  return removed;
}

void dropAbandoned(Json& tree, const Abandoned& abandoned) {
  std::vector<Json> accessors =
      removeUnused(tree, "accessors", abandoned.accessors, forEachAccessorNumber);
  std::set<int> bufferViews = abandoned.bufferViews;
  for (Json& accessor : accessors)
    forEachBufferViewNumberOf(accessor, [&](Json& number) { bufferViews.insert(asIndex(number)); });
  removeUnused(tree, "bufferViews", bufferViews, forEachBufferViewNumber);
}

// Bytes of an old buffer that some buffer view shows, with their new place.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t target = 0;
};

std::size_t sizeMember(const Json& object, const char* key) {
  return object.contains(key) ? object[key].get<std::size_t>() : 0;
}

// Per buffer the ranges that buffer views show.
std::vector<std::vector<Range>> shownRanges(const Json& bufferViews, std::size_t buffers) {
  std::vector<std::vector<Range>> ranges(buffers);
  for (const Json& view : bufferViews) {
    const std::size_t begin = sizeMember(view, "byteOffset");
    ranges.at(sizeMember(view, "buffer"))
        .push_back({begin, begin + sizeMember(view, "byteLength"), 0});
  }
  return ranges;
}

// The ranges in order, those that touch as one.
std::vector<Range> mergedRanges(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const Range& a, const Range& b) { return a.begin < b.begin; });
  std::vector<Range> merged;
  for (const Range& range : ranges) {
    if (!merged.empty() && range.begin <= merged.back().end)
      merged.back().end = std::max(merged.back().end, range.end);
    else
      merged.push_back(range);
  }
  return merged;
}

constexpr std::size_t kAlignment = 8;

// Appends the ranges to `data`, with their alignment kept.
void copyRanges(std::vector<Range>& ranges, const GltfBuffer& buffer, Bytes& data) {
  for (Range& range : ranges) {
    while (data.size() % kAlignment != range.begin % kAlignment) data.push_back(0);
    range.target = data.size();
    appendRange(data, buffer, range.begin, range.end - range.begin);
  }
}

std::size_t movedOffset(const std::vector<Range>& ranges, std::size_t offset) {
  const auto after = std::upper_bound(
      ranges.begin(), ranges.end(), offset,
      [](std::size_t position, const Range& range) { return position < range.begin; });
  const Range& range = *std::prev(after);
  return range.target + (offset - range.begin);
}

Bytes mergeBuffers(Json& tree, const std::vector<GltfBuffer>& buffers, bool keepsHidden) {
  Bytes data;
  if (!tree.contains("bufferViews")) return data;
  Json& bufferViews = tree["bufferViews"];
  std::vector<std::vector<Range>> ranges = shownRanges(bufferViews, buffers.size());
  std::size_t total = 0;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    ranges[i] = keepsHidden ? std::vector<Range>{{0, std::size_t(buffers[i].size), 0}}
                            : mergedRanges(std::move(ranges[i]));
    for (const Range& range : ranges[i]) total += range.end - range.begin + kAlignment;
  }
  data.reserve(total);
  for (std::size_t i = 0; i < buffers.size(); ++i) copyRanges(ranges[i], buffers[i], data);
  for (Json& view : bufferViews) {
    const std::size_t offset =
        movedOffset(ranges[sizeMember(view, "buffer")], sizeMember(view, "byteOffset"));
    view["buffer"] = 0;
    view["byteOffset"] = offset;
  }
  return data;
}

}  // namespace

PackedGltf packGltf(Json tree, const std::vector<GltfBuffer>& buffers, const Abandoned& abandoned) {
  const bool keepsAll = mayHideReferences(tree, Named::Data);
  if (!keepsAll) dropAbandoned(tree, abandoned);
  Bytes data = mergeBuffers(tree, buffers, keepsAll);
  if (data.empty()) {
    tree.erase("buffers");
  } else {
    Json buffer = Json::object();
    if (tree.contains("buffers") && !tree["buffers"].empty()) buffer = tree["buffers"][0];
    buffer["byteLength"] = data.size();
    tree["buffers"] = Json::array({buffer});
  }
  return {std::move(tree), std::move(data)};
}

}  // namespace remesher::io
