#include "core/formats/gltf/gltf_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/formats/gltf/base64.h"
#include "core/formats/mesh_readers.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

using nlohmann::json;

constexpr std::string_view magic = "glTF";
constexpr std::uint64_t largest_number = std::uint64_t{1} << 53;

// "%20" is a blank in an address. Nothing where what stands behind % is no number.
std::optional<std::string> decoded(std::string_view address) {
  std::string text;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] != '%') {
      text += address[i];
      continue;
    }
    const std::string digits = lower_case(address.substr(i + 1, 2));
    constexpr std::string_view hexadecimal = "0123456789abcdef";
    if (digits.size() < 2) return std::nullopt;
    const std::size_t high = hexadecimal.find(digits[0]);
    const std::size_t low = hexadecimal.find(digits[1]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    text += static_cast<char>(16 * high + low);
    i += 2;
  }
  return text;
}

// Those that change nothing about triangles.
bool is_harmless(std::string_view extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_") ||
         extension.starts_with("EXT_texture_") || extension == "KHR_mesh_quantization" ||
         extension == "KHR_lights_punctual";
}

}  // namespace

std::string part_name(const char* array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

GltfDocument::GltfDocument(std::string_view bytes, std::string_view name,
                           const std::filesystem::path* folder)
    : name_(name), folder_(folder), is_binary_(bytes.starts_with(magic)), size_(bytes.size()) {
  if (is_binary_) {
    read_chunks(bytes);
  } else {
    parse(bytes, 0);
  }
  check_version();
}

// "glTF", the version and the size; then chunks: the size, the kind, and as many bytes.
void GltfDocument::read_chunks(std::string_view bytes) {
  constexpr std::size_t header = 12;
  constexpr std::size_t chunk_header = 8;
  if (bytes.size() < header + chunk_header) {
    fail_at_byte(name_, bytes.size(), "the file ends inside the header of a binary glTF");
  }
  const auto version = geolloyd::load<std::uint32_t>(bytes.data() + 4);
  if (version != 2) {
    fail_at_byte(name_, 4, "glTF of version " + std::to_string(version) + "; 2 is understood");
  }
  const auto size = geolloyd::load<std::uint32_t>(bytes.data() + 8);
  if (size > bytes.size()) {
    fail_at_byte(name_, bytes.size(),
                 "the file ends here, but its header promises " + std::to_string(size) + " bytes");
  }
  constexpr std::uint32_t json_kind = 0x4e4f534a;
  constexpr std::uint32_t binary_kind = 0x004e4942;
  bool has_json = false;
  std::size_t offset = header;
  while (size - offset >= chunk_header && offset < size) {
    const auto length = geolloyd::load<std::uint32_t>(bytes.data() + offset);
    const auto kind = geolloyd::load<std::uint32_t>(bytes.data() + offset + 4);
    if (length > size - offset - chunk_header) {
      fail_at_byte(name_, offset, "the file ends inside the chunk that begins here");
    }
    const std::string_view chunk = bytes.substr(offset + chunk_header, length);
    if (!has_json && kind != json_kind) fail_at_byte(name_, offset, "the first chunk is no JSON");
    if (!has_json) parse(chunk, offset + chunk_header);
    if (has_json && kind == binary_kind && !chunk_) chunk_ = chunk;
    has_json = true;
    offset += chunk_header + length;
  }
}

void GltfDocument::parse(std::string_view text, std::size_t offset) {
  try {
    root_ = json::parse(text);
  } catch (const json::parse_error& error) {
    fail_at_byte(name_, offset + (error.byte > 0 ? error.byte - 1 : 0), "the JSON is malformed");
  } catch (const json::exception&) {
    fail_at_byte(name_, offset, "the JSON has a number that is too large");
  }
  if (!root_.is_object()) fail_at_byte(name_, offset, "the JSON is no object");
}

void GltfDocument::check_version() const {
  const auto asset = root_.find("asset");
  const bool has_version = asset != root_.end() && asset->is_object() &&
                           asset->contains("version") && (*asset)["version"].is_string();
  if (!has_version) fail("asset", "no version; is the file a glTF?");
  const auto& version = (*asset)["version"].get_ref<const std::string&>();
  if (!version.starts_with("2.")) {
    fail("asset", "glTF of version " + in_quotes(version) + "; 2.0 is understood");
  }
  const auto required = root_.find("extensionsRequired");
  if (required == root_.end() || !required->is_array()) return;
  for (const json& extension : *required) {
    if (!extension.is_string()) continue;
    const auto& text = extension.get_ref<const std::string&>();
    if (is_harmless(text)) continue;
    fail("extensionsRequired", in_quotes(text) + " is not understood; save the mesh without it");
  }
}

std::size_t GltfDocument::count(const char* array) const {
  const auto found = root_.find(array);
  return found == root_.end() || !found->is_array() ? 0 : found->size();
}

const json& GltfDocument::at(const char* array, std::size_t index) const {
  if (index >= count(array)) fail(part_name(array, index), "is named, but there is none");
  const json& object = root_[array][index];
  if (!object.is_object()) fail(part_name(array, index), "is no object");
  return object;
}

std::uint64_t GltfDocument::number(const json& object, const char* key, const std::string& what,
                                   std::optional<std::uint64_t> otherwise) const {
  const auto found = object.find(key);
  if (found == object.end() && otherwise) return *otherwise;
  if (found != object.end() && found->is_number_unsigned()) {
    const auto value = found->get<std::uint64_t>();
    if (value <= largest_number) return value;
  }
  // Some write 3.0.
  if (found != object.end() && found->is_number_float()) {
    const auto value = found->get<double>();
    const bool fits = value >= 0 && value <= static_cast<double>(largest_number);
    if (fits && value == std::floor(value)) return static_cast<std::uint64_t>(value);
  }
  fail(what, "expected a whole number as " + in_quotes(key));
}

std::string_view GltfDocument::view(std::size_t index) {
  const std::string what = part_name("bufferViews", index);
  const json& object = at("bufferViews", index);
  const std::string_view bytes = buffer(number(object, "buffer", what));
  const std::uint64_t offset = number(object, "byteOffset", what, 0);
  const std::uint64_t length = number(object, "byteLength", what);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    fail(what, "ends at byte " + std::to_string(offset + length) + " of a buffer of " +
                   std::to_string(bytes.size()));
  }
  return bytes.substr(offset, length);
}

std::string_view GltfDocument::buffer(std::size_t index) {
  const std::string what = part_name("buffers", index);
  const json& object = at("buffers", index);
  const std::uint64_t length = number(object, "byteLength", what);
  const auto address = object.find("uri");
  std::string_view bytes;
  if (address != object.end()) {
    if (!address->is_string()) fail(what, "expected text as 'uri'");
    bytes = load(index, address->get_ref<const std::string&>(), what);
  } else if (index == 0 && chunk_) {
    bytes = *chunk_;
  } else {
    fail(what, "has no data");
  }
  if (length > bytes.size()) {
    fail(what, std::to_string(length) + " bytes are promised, but there are " +
                   std::to_string(bytes.size()));
  }
  return bytes.substr(0, length);
}

std::string_view GltfDocument::load(std::size_t index, const std::string& address,
                                    const std::string& what) {
  if (!address.starts_with("data:")) return read_beside(address, what);
  if (const auto known = data_.find(index); known != data_.end()) return known->second;
  constexpr std::string_view mark = ";base64,";
  const std::size_t begin = address.find(mark);
  if (begin == std::string::npos) fail(what, "expected base64 data");
  auto bytes = from_base64(std::string_view(address).substr(begin + mark.size()));
  if (!bytes) fail(what, "the base64 data is malformed");
  return data_.emplace(index, std::move(*bytes)).first->second;
}

// A plain name alone: a mesh should not make anybody read what lies elsewhere.
std::string_view GltfDocument::read_beside(const std::string& address, const std::string& what) {
  if (const auto known = files_.find(address); known != files_.end()) return known->second;
  const auto file = decoded(address);
  const bool is_plain = file && !file->empty() && file->front() != '.' &&
                        file->find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
  if (!is_plain) {
    fail(what, in_quotes(address) + " is no name of a file beside this one; others are not read");
  }
  if (folder_ == nullptr) {
    fail(what, "the data is in " + in_quotes(address) +
                   ", but nobody knows where that is; give "
                   "the name of the glTF file");
  }
  const auto bytes = files_.emplace(address, read_file(*folder_ / *file)).first;
  size_ += bytes->second.size();
  return bytes->second;
}

void GltfDocument::fail(const std::string& what, const std::string& message) const {
  throw InvalidInput(std::string(name_) + ": " + what + ": " + message);
}

}  // namespace geolloyd
