#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace geolloyd::fuzz {

/// Small decisions, a byte each, so that changing a byte changes one of them. After the last byte
/// all are 0.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return bytes_.empty(); }
  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }
  /// In [0, bound).
  std::size_t below(std::size_t bound) { return next() % bound; }
  bool coin() { return below(2) == 1; }
  /// One of an array.
  template <class T, std::size_t size>
  const T& of(const T (&options)[size]) {
    return options[below(size)];
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace geolloyd::fuzz
