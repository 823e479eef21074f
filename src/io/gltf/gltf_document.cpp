// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_document.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/legible.h"
#include "io/gltf/gltf_references.h"
#include "io/gltf/tree/gltf_extensions.h"
#include "io/model/byte_reader.h"
#include "io/model/resources.h"

namespace remesher::io {
namespace {

constexpr std::string_view kGlbMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN\0"
constexpr std::size_t kGlbHeader = 12;
constexpr std::size_t kChunkHeader = 8;

constexpr std::uint64_t kRangeBlock = 65536;  // bytes that are copied at once

// Real files nest about ten deep; the limit keeps recursive JSON writers from overflowing the
// stack.
constexpr int kDeepestNesting = 256;

struct Chunks {
  Bytes json;
  std::optional<GltfBuffer> binary;
};

void appendLittleEndian(Bytes& bytes, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

Chunks splitGlb(const GltfDocument& document) {
  ByteReader reader(document.original);
  const auto truncated = [&](const std::string& what) {
    document.fail(ErrorCode::ParseError, what, "Was it copied completely?");
  };
  const auto word = [&] { return littleEndianAt<std::uint32_t>(reader.next(4)); };
  if (reader.size() < kGlbHeader + kChunkHeader) truncated("the file ends within its header.");
  word();  // the magic
  if (const std::uint32_t version = word(); version != 2)
    document.fail(ErrorCode::Unsupported,
                  "the file is glTF " + std::to_string(version) + ", not 2.",
                  "Convert it to glTF 2.0 first.");
  const std::uint64_t length = word();
  if (length > reader.size())
    truncated("the file has " + std::to_string(reader.size()) + " bytes, its header promises " +
              std::to_string(length) + ".");
  Chunks chunks;
  while (reader.at() + kChunkHeader <= length) {
    const bool isFirst = reader.at() == kGlbHeader;
    const std::uint32_t size = word();
    const std::uint32_t type = word();
    const std::uint64_t begin = reader.at();
    if (size > length - begin) truncated("a chunk reaches beyond the end of the file.");
    if (isFirst && type != kJsonChunk)
      document.fail(ErrorCode::ParseError, "the first chunk of the file is not JSON.");
    if (isFirst)
      appendRange(chunks.json, {&document.original}, begin, size);
    else if (type == kBinaryChunk && !chunks.binary)
      chunks.binary = {&document.original, begin, size};
    reader.goTo(begin + size);
  }
  return chunks;
}

// Strings are skipped, so that brackets in names and base64 do not count.
bool nestsTooDeep(std::span<const std::uint8_t> text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i)
        if (text[i] == '\\') ++i;
    } else if (text[i] == '{' || text[i] == '[') {
      if (++depth > kDeepestNesting) return true;
    } else if (text[i] == '}' || text[i] == ']') {
      --depth;
    }
  }
  return false;
}

Json parseTree(const GltfDocument& document, std::span<const std::uint8_t> text) {
  if (nestsTooDeep(text))
    document.fail(ErrorCode::ParseError, "the JSON nests deeper than any glTF file does.");
  Json tree;
  try {
    // Parses the same text type as tinygltf: another type would compile a second parser.
    const auto* const first = reinterpret_cast<const char*>(text.data());
    tree = Json::parse(first, first + text.size());
  } catch (const Json::parse_error& error) {
    document.fail(ErrorCode::ParseError,
                  "the JSON is broken at byte " + std::to_string(error.byte) + ".",
                  "Is this a glTF file, and was it copied completely?");
  }
  if (!tree.is_object() || !tree.contains("asset"))
    document.fail(ErrorCode::ParseError, "the JSON is not a glTF document: it has no \"asset\".");
  const Json version = tree["asset"].is_object() ? tree["asset"].value("version", Json()) : Json();
  if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2"))
    document.fail(ErrorCode::Unsupported, "the document is not of glTF version 2.",
                  "Convert it to glTF 2.0 first.");
  return tree;
}

// Compression that the bindings decode before the core sees the file. A fallback beside compressed
// data is refused too, because the writer could not keep both consistent.
void refuseCompression(const GltfDocument& document) {
  constexpr std::array kCompressions = {"EXT_meshopt_compression", "KHR_meshopt_compression",
                                        "KHR_draco_mesh_compression"};
  const Json used = document.tree.value("extensionsUsed", Json::array());
  for (const char* compression : kCompressions)
    if (std::find(used.begin(), used.end(), compression) != used.end())
      document.fail(ErrorCode::Unsupported,
                    std::string("the file is compressed with ") + compression + ".",
                    "Decompress it first.");
}

// tinygltf gets only the part of the tree that describes geometry, and no bytes.
tinygltf::Model typedView(const GltfDocument& document) {
  Json geometry;
  for (const char* member :
       {"asset", "accessors", "bufferViews", "meshes", "nodes", "scenes", "scene", "skins"})
    if (document.tree.contains(member)) geometry[member] = document.tree[member];
  const std::string text = geometry.dump(-1, ' ', false, Json::error_handler_t::replace);
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const bool isLoaded =
      loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                 static_cast<unsigned int>(text.size()), "", tinygltf::NO_REQUIRE);
  if (!isLoaded) {
    std::string reason = error.substr(0, error.find('\n'));
    if (!reason.ends_with('.')) reason += '.';
    document.fail(ErrorCode::ParseError, "the glTF document is invalid: " + legible(reason));
  }
  return model;
}

std::vector<std::size_t> jointCounts(const tinygltf::Model& model) {
  std::vector<std::size_t> counts(model.meshes.size(), std::numeric_limits<std::size_t>::max());
  for (const tinygltf::Node& node : model.nodes) {
    const auto [mesh, skin] = std::pair(node.mesh, node.skin);
    if (mesh < 0 || skin < 0 || static_cast<std::size_t>(mesh) >= counts.size() ||
        static_cast<std::size_t>(skin) >= model.skins.size())
      continue;
    counts[mesh] = std::min(counts[mesh], model.skins[skin].joints.size());
  }
  return counts;
}

// A text may be called .glb.
bool beginsAsJson(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kBeforeText = "\xEF\xBB\xBF \t\r\n";
  const auto first = std::find_if(bytes.begin(), bytes.end(), [&](std::uint8_t byte) {
    return kBeforeText.find(static_cast<char>(byte)) == kBeforeText.npos;
  });
  return first != bytes.end() && *first == '{';
}

bool isNamedGlb(std::string_view name) {
  constexpr std::string_view kEnd = ".glb";
  return name.size() >= kEnd.size() &&
         std::equal(kEnd.begin(), kEnd.end(), name.end() - std::ptrdiff_t(kEnd.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

GltfBuffer findBuffer(GltfDocument& document, const Json& buffer,
                      const std::optional<GltfBuffer>& chunk, const Resources& resources) {
  const std::string where = "buffer " + std::to_string(document.buffers.size());
  GltfBuffer found;
  if (!buffer.is_object() || !buffer.contains("uri")) {
    if (!document.buffers.empty() || !chunk)
      document.fail(ErrorCode::ParseError, where + " has neither a URI nor the binary chunk.");
    found = *chunk;
  } else {
    const std::string uri = buffer["uri"].is_string() ? buffer["uri"].get<std::string>() : "";
    if (isDataUri(uri)) {
      std::optional<Bytes> decoded = decodeDataUri(uri);
      if (!decoded) document.fail(ErrorCode::ParseError, where + " has a malformed data URI.");
      found.file = &document.decoded.emplace_back(File{{}, std::move(*decoded)});
    } else {
      found.file = resources.find(uri);
      found.name = percentDecoded(uri);
      if (found.file == nullptr)
        document.fail(ErrorCode::MissingResource,
                      "it needs " + legible(uri) + ", which was not given.",
                      "Keep " + legible(uri) + " beside the file, or give both together.");
    }
    found.size = fileSize(*found.file);
  }
  const Json& length = buffer.is_object() ? buffer.value("byteLength", Json()) : Json();
  if (!length.is_number_unsigned())
    document.fail(ErrorCode::ParseError, where + " has no byteLength.");
  if (length.get<std::uint64_t>() > found.size)
    document.fail(ErrorCode::ParseError,
                  where + " has " + std::to_string(found.size) + " bytes, but promises " +
                      std::to_string(length.get<std::uint64_t>()) + ".",
                  "Was it copied completely?");
  found.size = length.get<std::uint64_t>();
  return found;
}

// Checks the tree's own numbers, because these are copied on writing. tinygltf's view drops the
// upper half of long numbers and reads numbers with a fraction as 0.
bool isInside(const Json& view, const std::vector<GltfBuffer>& buffers) {
  const auto member = [&](const char* key) { return view.value(key, Json(0U)); };
  for (const char* key : {"buffer", "byteOffset", "byteLength", "byteStride"})
    if (!isWholeNumber(member(key))) return false;
  const auto buffer = member("buffer").get<std::uint64_t>();
  if (buffer >= buffers.size()) return false;
  const std::uint64_t size = buffers[static_cast<std::size_t>(buffer)].size;
  const auto offset = member("byteOffset").get<std::uint64_t>();
  return offset <= size && member("byteLength").get<std::uint64_t>() <= size - offset;
}

void checkBufferViews(const GltfDocument& document) {
  const Json views = document.tree.value("bufferViews", Json::array());
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!isInside(views[i], document.buffers))
      document.fail(ErrorCode::ParseError,
                    "buffer view " + std::to_string(i) + " reaches beyond its buffer.",
                    "Was the file copied completely?");
}

void findBuffers(GltfDocument& document, const std::optional<GltfBuffer>& chunk) {
  if (!document.tree.contains("buffers") || !document.tree["buffers"].is_array()) return;
  Json& list = document.tree["buffers"];
  document.isEmbedded = !document.isBinary && !list.empty();
  const Resources resources(document.resources);
  for (Json& buffer : list) {
    document.buffers.push_back(findBuffer(document, buffer, chunk, resources));
    document.bufferBytes += document.buffers.back().size;
    document.isEmbedded =
        document.isEmbedded && buffer.contains("uri") && document.buffers.back().name.empty();
    buffer.erase("uri");
  }
}

}  // namespace

// Apparent damage may come from an extension that is not known here.
void GltfDocument::fail(ErrorCode code, const std::string& what, std::string hint) const {
  const std::string unknown = requiredUnknown(tree);
  const bool looksDamaged = code == ErrorCode::ParseError || code == ErrorCode::IndexOutOfRange;
  if (looksDamaged && !unknown.empty())
    throw Error(ErrorCode::Unsupported,
                legible(original.name) + ": it requires " + legible(unknown) +
                    ", which is not known here: " + what,
                "Export it without " + legible(unknown) + ".");
  throw Error(code, legible(original.name) + ": " + what, std::move(hint));
}

std::shared_ptr<GltfDocument> openGltf(const File& file, const std::vector<File>& resources) {
  const auto document = std::make_shared<GltfDocument>();
  document->original = file;
  document->resources = resources;
  document->isBinary = asText(beginOf(file, kGlbMagic.size())) == kGlbMagic;
  if (!document->isBinary && isNamedGlb(file.name) && !beginsAsJson(file.bytes))
    document->fail(ErrorCode::ParseError, "the file does not begin as a binary glTF file does.",
                   "Is it of another format, or a .gltf?");
  const Chunks chunks = document->isBinary ? splitGlb(*document) : Chunks{};
  document->tree = parseTree(*document, document->isBinary ? chunks.json : file.bytes);
  refuseCompression(*document);
  requireReferences(*document);
  document->typed = typedView(*document);
  document->jointCounts = jointCounts(document->typed);
  findBuffers(*document, chunks.binary);
  checkBufferViews(*document);
  return document;
}

void appendRange(Bytes& bytes, const GltfBuffer& buffer, std::uint64_t begin, std::uint64_t count) {
  ByteReader reader(*buffer.file);
  reader.goTo(buffer.begin + begin);
  while (count > 0) {
    const auto some = static_cast<std::size_t>(std::min<std::uint64_t>(count, kRangeBlock));
    const std::uint8_t* const first = reader.next(some);
    bytes.insert(bytes.end(), first, first + some);
    count -= some;
  }
}

Bytes packGlb(const Json& tree, const Bytes& data) {
  std::string text = tree.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t dataSize = (data.size() + 3) / 4 * 4;
  const std::size_t total =
      kGlbHeader + kChunkHeader + text.size() + (data.empty() ? 0 : kChunkHeader + dataSize);
  Bytes bytes(kGlbMagic.begin(), kGlbMagic.end());
  bytes.reserve(total);
  for (const std::size_t word : {std::size_t{2}, total, text.size(), std::size_t{kJsonChunk}})
    appendLittleEndian(bytes, word);
  bytes.insert(bytes.end(), text.begin(), text.end());
  if (!data.empty()) {
    appendLittleEndian(bytes, dataSize);
    appendLittleEndian(bytes, kBinaryChunk);
    bytes.insert(bytes.end(), data.data(), data.data() + data.size());
  }
  bytes.resize(total, 0);
  return bytes;
}

}  // namespace remesher::io
