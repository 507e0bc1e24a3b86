#include "core/formats/gltf/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

using nlohmann::json;

// Of a component type, as OpenGL counts them; 0 where there is none.
std::size_t size_of_type(std::uint64_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

template <class Integer>
double share(Integer value) {
  return std::max(
      static_cast<double>(value) / static_cast<double>(std::numeric_limits<Integer>::max()), -1.0);
}

double read_number(const char* bytes, std::uint64_t type, bool is_share) {
  const auto integer = [&](auto value) {
    return is_share ? share(value) : static_cast<double>(value);
  };
  switch (type) {
    case 5120:
      return integer(load<std::int8_t>(bytes));
    case 5121:
      return integer(load<std::uint8_t>(bytes));
    case 5122:
      return integer(load<std::int16_t>(bytes));
    case 5123:
      return integer(load<std::uint16_t>(bytes));
    case 5125:
      return integer(load<std::uint32_t>(bytes));
    default:
      return load<float>(bytes);
  }
}

std::uint32_t read_index(const char* bytes, std::uint64_t type) {
  if (type == 5121) return load<std::uint8_t>(bytes);
  if (type == 5123) return load<std::uint16_t>(bytes);
  return load<std::uint32_t>(bytes);
}

bool is_index_type(std::uint64_t type) {
  return type == 5121 || type == 5123 || type == 5125;
}

}  // namespace

GltfAccessor::GltfAccessor(GltfDocument& document, std::size_t index)
    : document_(document), what_(part_name("accessors", index)) {
  const json& object = document.at("accessors", index);
  type_ = document.number(object, "componentType", what_);
  const std::size_t size = size_of_type(type_);
  if (size == 0) document.fail(what_, "no such componentType: " + std::to_string(type_));
  static constexpr std::array<const char*, 4> widths = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto type = object.find("type");
  const auto found = std::find_if(widths.begin(), widths.end(), [&](const char* width) {
    return type != object.end() && *type == width;
  });
  if (found == widths.end()) document.fail(what_, "expected SCALAR, VEC2, VEC3 or VEC4 as 'type'");
  width_ = static_cast<std::size_t>(found - widths.begin()) + 1;
  const std::uint64_t count = document.number(object, "count", what_);
  const auto normalized = object.find("normalized");
  is_normalized_ = normalized != object.end() && *normalized == true;
  count_ = static_cast<std::size_t>(count);
  if (object.contains("bufferView")) rows_ = find_rows(object, count, size * width_, what_);
  const auto sparse = object.find("sparse");
  if (sparse != object.end()) read_sparse(*sparse);
  // Every row takes a byte somewhere, be it in a list of triangles. The buffers of this accessor
  // are read by now, so they count.
  if (count > document.size()) {
    document.fail(what_, std::to_string(count) + " rows are promised by a file of " +
                             std::to_string(document.size()) + " bytes");
  }
}

GltfAccessor::Rows GltfAccessor::find_rows(const json& object, std::uint64_t count,
                                           std::size_t row_size, const std::string& what) const {
  const std::size_t index = document_.number(object, "bufferView", what);
  const std::string_view view = document_.view(index);
  const std::string view_name = part_name("bufferViews", index);
  const std::uint64_t stride =
      document_.number(document_.at("bufferViews", index), "byteStride", view_name, row_size);
  if (stride < row_size) {
    document_.fail(view_name, "byteStride " + std::to_string(stride) + " is less than the " +
                                  std::to_string(row_size) + " bytes of a row");
  }
  const std::uint64_t offset = document_.number(object, "byteOffset", what, 0);
  const std::uint64_t room = view.size() - std::min<std::uint64_t>(offset, view.size());
  const std::uint64_t fitting = room < row_size ? 0 : (room - row_size) / stride + 1;
  if (count > fitting) {
    document_.fail(what, std::to_string(count) + " rows are promised, but " +
                             std::to_string(fitting) + " fit into " + view_name);
  }
  return {count == 0 ? view.substr(0, 0) : view.substr(offset), static_cast<std::size_t>(stride)};
}

void GltfAccessor::read_sparse(const json& sparse) {
  const std::string what = what_ + ".sparse";
  const bool is_complete = sparse.is_object() && sparse.contains("indices") &&
                           sparse["indices"].is_object() && sparse.contains("values") &&
                           sparse["values"].is_object();
  if (!is_complete) document_.fail(what, "expected 'indices' and 'values'");
  const std::uint64_t count = document_.number(sparse, "count", what);
  const json& indices = sparse["indices"];
  const std::uint64_t type = document_.number(indices, "componentType", what);
  if (!is_index_type(type)) document_.fail(what, "indices have no unsigned type");
  const Rows rows = find_rows(indices, count, size_of_type(type), what);
  replacements_ = find_rows(sparse["values"], count, size_of_type(type_) * width_, what);
  replaced_.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint32_t row = read_index(rows.bytes.data() + i * rows.stride, type);
    const bool ascends = replaced_.empty() || row > replaced_.back();
    if (row >= count_ || !ascends) document_.fail(what, "indices do not ascend within the rows");
    replaced_.push_back(row);
  }
}

template <class Visit>
void GltfAccessor::for_each_row(Visit&& visit) const {
  std::size_t next = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const bool is_replaced = next < replaced_.size() && replaced_[next] == i;
    const Rows& rows = is_replaced ? replacements_ : rows_;
    const std::size_t at = is_replaced ? next++ : i;
    visit(rows.bytes.empty() ? nullptr : rows.bytes.data() + at * rows.stride);
  }
}

std::vector<double> GltfAccessor::values() const {
  std::vector<double> values;
  values.reserve(count_ * width_);
  const std::size_t size = size_of_type(type_);
  for_each_row([&](const char* row) {
    for (std::size_t i = 0; i < width_; ++i) {
      values.push_back(row == nullptr ? 0 : read_number(row + i * size, type_, is_normalized_));
    }
  });
  return values;
}

std::vector<std::uint32_t> GltfAccessor::indices() const {
  if (width_ != 1 || !is_index_type(type_)) {
    document_.fail(what_, "indices have to be unsigned integers");
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(count_);
  for_each_row(
      [&](const char* row) { indices.push_back(row == nullptr ? 0 : read_index(row, type_)); });
  return indices;
}

}  // namespace geolloyd
