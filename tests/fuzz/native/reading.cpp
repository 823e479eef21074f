// SPDX-License-Identifier: MIT
#include "reading.h"

#include <algorithm>
#include <functional>

#include "io/formats.h"
#include "laws.h"

namespace remesher::fuzz {
namespace {

// Whether `action` came to its end; otherwise it said why not.
bool succeeds(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Error& error) {
    requireSentence(error);
    return false;
  }
}

// What was written is no file of its format unless it can be read again.
void requireReadable(const io::Model& model, const std::string& outputName) {
  io::WrittenFiles written;
  if (!succeeds([&] { written = io::write(model, outputName); })) return;
  File file = std::move(written.files.front());
  written.files.erase(written.files.begin());
  require(succeeds([&] { io::read(file, written.files); }), "what is written can be read");
}

}  // namespace

void readAndWrite(const FileBundle& bundle, const std::string& other) {
  io::Model model;
  if (!succeeds([&] { model = io::read(bundle.file, bundle.resources); })) return;
  bool isWhole = !model.parts.empty();
  for (const io::Part& part : model.parts) {
    // Whatever comes after reading refuses these by name.
    const bool isSound = succeeds([&] { requireValid(part.mesh); });
    if (isSound) requireWhole(part.mesh);
    isWhole = isWhole && isSound;
  }
  succeeds([&] { inspectFile(bundle); });
  if (!isWhole) return;
  requireReadable(model, bundle.file.name);
  requireReadable(model, other);
}

std::pair<Bytes, Bytes> splitAtZero(Input input) {
  const auto zero = std::find(input.begin(), input.end(), std::uint8_t{0});
  const auto rest = zero == input.end() ? zero : zero + 1;
  return {Bytes(input.begin(), zero), Bytes(rest, input.end())};
}

}  // namespace remesher::fuzz
