// SPDX-License-Identifier: MIT
#include "from_js.h"

#include <emscripten/emscripten.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "option_fields.h"
#include "option_reader.h"

namespace remesher {

using emscripten::typed_memory_view;
using emscripten::val;

void (*readWholeOptions)(const val& object, RemeshOptions& options) = nullptr;

namespace {

template <class Visit>
void forEach(const val& array, Visit visit) {
  const auto length = array["length"].as<unsigned>();
  for (unsigned i = 0; i < length; ++i) visit(array[i]);
}

val viewOf(std::span<std::uint8_t> bytes) {
  return val(typed_memory_view(bytes.size(), bytes.data()));
}

// An array that stays where it is, in JavaScript.
class ArraySource : public ByteSource {
 public:
  explicit ArraySource(const val& bytes) : bytes_(bytes), size_(bytes["length"].as<double>()) {}

  std::uint64_t size() const override { return std::uint64_t(size_); }
  bool read(std::uint64_t at, std::span<std::uint8_t> into) const override {
    const double begin = double(at);
    viewOf(into).call<void>("set",
                            bytes_.call<val>("subarray", begin, begin + double(into.size())));
    return true;
  }

 private:
  val bytes_;
  double size_;
};

// A file that is open. blocks: { size, read: (at, array) => whether the array could be filled }
class OpenSource : public ByteSource {
 public:
  explicit OpenSource(const val& blocks) : blocks_(blocks) {}

  std::uint64_t size() const override { return std::uint64_t(blocks_["size"].as<double>()); }
  bool read(std::uint64_t at, std::span<std::uint8_t> into) const override {
    return blocks_.call<bool>("read", double(at), viewOf(into));
  }

 private:
  val blocks_;
};

// The files of a request stay outside of WebAssembly's memory, which the mesh needs.
File fileFrom(const val& object) {
  File file{object["name"].as<std::string>(), {}};
  if (const val blocks = object["blocks"]; !blocks.isUndefined())
    file.source = std::make_shared<OpenSource>(blocks);
  else
    file.source = std::make_shared<ArraySource>(object["bytes"]);
  return file;
}

}  // namespace

TriangleMesh meshFrom(const val& object) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  TriangleMesh mesh;
  const val positions = object["positions"];
  mesh.positions.resize(positions["length"].as<std::size_t>() / 3);
  if (!mesh.positions.empty())
    val(typed_memory_view(3 * mesh.positions.size(), mesh.positions.front().data()))
        .call<void>("set", positions);
  mesh.isSingle = positions["BYTES_PER_ELEMENT"].as<std::size_t>() == sizeof(float);
  mesh.indices = copied<Index>(object["indices"]);
  if (const val groups = object["groups"]; !groups.isUndefined())
    mesh.groups = copied<Index>(groups);
  forEach(object["attributes"], [&](const val& attribute) {
    mesh.attributes.push_back({attribute["semantic"].as<std::string>(),
                               attribute["itemSize"].as<int>(), copied<float>(attribute["array"])});
  });
  return mesh;
}

std::vector<PlacedMesh> sceneFrom(const val& list) {
  std::vector<PlacedMesh> scene;
  forEach(list, [&](const val& object) {
    PlacedMesh placed{meshFrom(object["mesh"]), {}};
    forEach(object["places"], [&](const val& matrix) {
      const std::vector<double> columns = copied<double>(matrix);
      placed.places.emplace_back(Eigen::Map<const Eigen::Matrix4d>(columns.data()));
    });
    if (const val finer = object["finer"]; !finer.isUndefined())
      for (const Index number : copied<Index>(finer)) placed.finer.push_back(number);
    scene.push_back(std::move(placed));
  });
  return scene;
}

FileBundle bundleFrom(const val& object) {
  FileBundle bundle{fileFrom(object), {}, {}};
  forEach(object["resources"],
          [&](const val& resource) { bundle.resources.push_back(fileFrom(resource)); });
  if (const val pictures = object["pictures"]; !pictures.isUndefined())
    forEach(pictures, [&](val p) {
      bundle.pictures.push_back({p["name"].as<std::string>(), "", p["width"].as<Index>(),
                                 p["height"].as<Index>(), copied<std::uint8_t>(p["texels"])});
      p.set("texels", val::undefined());  // a quarter of a gigabyte, of an image of 8k
    });
  return bundle;
}

RemeshOptions optionsFrom(const val& object) {
  RemeshOptions options;
  forEachOption(options, OptionReader{object});
  if (readWholeOptions) readWholeOptions(object, options);
  options.detectFeatures = !object["featureAngle"].isString();
  options.dropFloaters = object["dropBelow"].isString();
  options.lodsBy = object["lodsBy"].isString() ? LodsBy::Pixels : LodsBy::Shares;
  if (const val lengths = object["lengths"]; !lengths.isUndefined())
    forEachLength(options.lengths, OptionReader{lengths});
  return options;
}

// The callback is called at most every 50 ms, and at the start of every phase: a call takes longer
// than many a step.
Progress progressFrom(const val& callback) {
  if (callback.isUndefined()) return Progress();
  return Progress([callback, last = -1e9, phase = std::string()](std::string_view now,
                                                                 double fraction) mutable {
    const double time = emscripten_get_now();
    if (now == phase && time - last < 50) return true;
    last = time;
    phase = now;
    return !callback(phase, fraction).isFalse();
  });
}

}  // namespace remesher
