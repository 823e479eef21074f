// SPDX-License-Identifier: MIT
#include "io/text/text_blocks.h"

#include <algorithm>
#include <cstdint>

namespace remesher::io {
namespace {

// Whether a line ends with the \n at `at` of the text, and does not go on behind a backslash.
bool isEnd(std::string_view text, std::size_t at) {
  if (text[at] != '\n') return false;
  if (at > 0 && text[at - 1] == '\r') --at;
  return at == 0 || text[at - 1] != '\\';
}

// The place behind the last line that ends at `from` or later; 0: none does. Texts without any \n
// have none.
std::size_t lastEnd(std::string_view text, std::size_t from) {
  for (std::size_t at = text.size(); at > from; --at)
    if (isEnd(text, at - 1)) return at;
  return 0;
}

}  // namespace

// Holds another block. False at the end of the file.
bool TextBlocks::extend() {
  const std::uint64_t left = bytes_.left();
  if (left == 0) return false;
  const auto count = std::size_t(std::min<std::uint64_t>(left, file_.source->blockBytes()));
  held_.append(reinterpret_cast<const char*>(bytes_.next(count)), count);
  return true;
}

std::string_view TextBlocks::next() {
  if (!file_.source) {
    const auto count = std::size_t(bytes_.left());
    return {reinterpret_cast<const char*>(bytes_.next(count)), count};
  }
  held_.erase(0, passed_);
  std::size_t looked = 0;
  passed_ = 0;
  while (passed_ == 0 && extend()) {
    passed_ = lastEnd(held_, looked);
    looked = held_.size();
  }
  if (passed_ == 0) passed_ = held_.size();
  return {held_.data(), passed_};
}

}  // namespace remesher::io
