#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace geolloyd {

/// A bundle as its reader sees it: the header, and the bytes of arrays.
class BundleReader {
 public:
  explicit BundleReader(std::string bytes) : bytes_(std::move(bytes)) {
    const std::uint32_t header_size = number<std::uint32_t>(4);
    if (number<std::uint32_t>(0) != 0x424c4c47 || header_size % 8 != 0) {
      throw std::runtime_error("no bundle");
    }
    header_ = nlohmann::json::parse(bytes_.substr(8, header_size));
    data_ = 8 + header_size;
  }

  [[nodiscard]] const nlohmann::json& header() const { return header_; }
  [[nodiscard]] const nlohmann::json& entry(const std::string& name) const {
    return header_.at("arrays").at(name);
  }

  /// All numbers of an array, whatever their type; none is all ones.
  [[nodiscard]] std::vector<double> array(const std::string& name) const {
    const nlohmann::json& e = entry(name);
    const std::size_t offset = e.at("offset");
    if (offset % 8 != 0) throw std::runtime_error(name + " begins anywhere");
    const std::size_t size =
        e.at("count").get<std::size_t>() * e.at("components").get<std::size_t>();
    const std::string type = e.at("type");
    std::vector<double> values;
    values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) values.push_back(value(type, data_ + offset, i));
    return values;
  }

 private:
  template <class Number>
  [[nodiscard]] Number number(std::size_t at) const {
    Number value{};
    if (at + sizeof(Number) > bytes_.size()) throw std::runtime_error("cut off");
    std::memcpy(&value, bytes_.data() + at, sizeof(Number));
    return value;
  }

  [[nodiscard]] double value(std::string_view type, std::size_t begin, std::size_t i) const {
    if (type == "f32") return static_cast<double>(number<float>(begin + 4 * i));
    if (type == "u32") return number<std::uint32_t>(begin + 4 * i);
    if (type == "u16") return number<std::uint16_t>(begin + 2 * i);
    if (type == "u8") return number<std::uint8_t>(begin + i);
    throw std::runtime_error("no such type");
  }

  std::string bytes_;
  nlohmann::json header_;
  std::size_t data_ = 0;
};

}  // namespace geolloyd
