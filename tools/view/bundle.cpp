#include "tools/view/bundle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "core/base/bounding_box.h"

namespace geolloyd {
namespace {

constexpr std::uint32_t bundle_magic = 0x424c4c47;
constexpr std::size_t alignment = 8;
constexpr double quantised_one = 32767;  // 0 stands for -1, 65534 for 1
constexpr std::array<const char*, 4> type_names = {"f32", "u32", "u16", "u8"};

std::size_t padded(std::size_t bytes) {
  return (bytes + alignment - 1) / alignment * alignment;
}

template <class Number>
void append(std::string& bytes, std::span<const Number> values) {
  const std::size_t begin = bytes.size();
  bytes.resize(begin + values.size_bytes());
  if (values.empty()) return;
  std::memcpy(bytes.data() + begin, values.data(), values.size_bytes());
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = begin; i < bytes.size(); i += sizeof(Number)) {
      std::reverse(bytes.data() + i, bytes.data() + i + sizeof(Number));
    }
  }
}

std::size_t bytes_of(const BundleArray& array) {
  return std::visit([](const auto& values) { return std::span(values).size_bytes(); },
                    array.values);
}

Json entry_of(const BundleArray& array, std::size_t offset) {
  const std::size_t size =
      std::visit([](const auto& values) { return values.size(); }, array.values);
  Json entry = {{"type", type_names[array.values.index()]},
                {"components", array.components},
                {"count", size / array.components},
                {"offset", offset}};
  if (!array.per.empty()) entry["per"] = array.per;
  if (array.is_quantised) {
    entry["origin"] = Json::array({-1, -1, -1});
    entry["step"] = Json::array({1 / quantised_one, 1 / quantised_one, 1 / quantised_one});
  }
  return entry;
}

std::string header_of(const Bundle& bundle) {
  Json arrays = Json::object();
  std::size_t offset = 0;
  for (const BundleArray& array : bundle.arrays) {
    arrays[array.name] = entry_of(array, offset);
    offset += padded(bytes_of(array));
  }
  const Vec3& origin = bundle.placement.origin;
  const Json header = {{"version", 1},
                       {"title", bundle.title},
                       {"origin", Json::array({origin.x(), origin.y(), origin.z()})},
                       {"scale", bundle.placement.scale},
                       {"arrays", arrays},
                       {"info", bundle.info},
                       {"frames", bundle.frames}};
  std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize(padded(text.size()), ' ');
  return text;
}

}  // namespace

Placement placement_of(const Mesh& mesh) {
  const BoundingBox box = bounding_box(3 * mesh.triangle_count(), [&](std::size_t corner) {
    return mesh.positions[mesh.triangles[corner / 3][corner % 3]];
  });
  const double radius = norm(box.extent()) / 2;
  return {box.middle(), radius > 0 ? radius : 1};
}

void Bundle::add_places(std::string name, std::span<const Vec3> places, std::string per) {
  std::vector<float> values;
  values.reserve(3 * places.size());
  for (const Vec3& place : places) {
    const Vec3 p = placement(place);
    for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(p[c]));
  }
  arrays.push_back({std::move(name), std::move(values), 3, std::move(per), false});
}

void Bundle::add_ids(std::string name, std::vector<std::uint32_t> ids, std::size_t count,
                     std::string per) {
  if (count >= std::numeric_limits<std::uint16_t>::max()) {
    arrays.push_back({std::move(name), std::move(ids), 1, std::move(per), false});
    return;
  }
  std::vector<std::uint16_t> values(ids.size());
  std::transform(ids.begin(), ids.end(), values.begin(),
                 [](std::uint32_t id) { return static_cast<std::uint16_t>(id); });
  arrays.push_back({std::move(name), std::move(values), 1, std::move(per), false});
}

void quantise(BundleArray& array) {
  const auto* const floats = std::get_if<std::vector<float>>(&array.values);
  if (floats == nullptr) return;
  std::vector<std::uint16_t> values(floats->size());
  std::transform(floats->begin(), floats->end(), values.begin(), [](float place) {
    const double steps = std::round((std::clamp(double{place}, -1.0, 1.0) + 1) * quantised_one);
    return static_cast<std::uint16_t>(steps);
  });
  array.values = std::move(values);
  array.is_quantised = true;
}

std::string encode(const Bundle& bundle) {
  const std::string header = header_of(bundle);
  std::size_t bytes = 2 * sizeof(std::uint32_t) + header.size();
  for (const BundleArray& array : bundle.arrays) bytes += padded(bytes_of(array));
  std::string text;
  text.reserve(bytes);
  const std::array<std::uint32_t, 2> begin = {bundle_magic,
                                              static_cast<std::uint32_t>(header.size())};
  append(text, std::span<const std::uint32_t>(begin));
  text += header;
  for (const BundleArray& array : bundle.arrays) {
    std::visit([&](const auto& values) { append(text, std::span(values)); }, array.values);
    text.resize(padded(text.size()));
  }
  return text;
}

}  // namespace geolloyd
