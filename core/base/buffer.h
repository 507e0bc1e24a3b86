#pragma once

#include <cstddef>
#include <memory>

#include "core/base/huge_pages.h"

namespace geolloyd {

/// An array whose elements hold nothing until written. The first write to a page of memory costs as
/// much as hundreds to it later, and so is paid by the threads that share the writing. Large arrays
/// ask for huge pages (huge_pages.h).
template <class T>
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
      : elements_(std::make_unique_for_overwrite<T[]>(size)), size_(size) {
    prefer_huge_pages(elements_.get(), size * sizeof(T));
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T* data() { return elements_.get(); }
  [[nodiscard]] const T* data() const { return elements_.get(); }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size_; }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return elements_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return elements_[i]; }

 private:
  std::unique_ptr<T[]> elements_;
  std::size_t size_ = 0;
};

}  // namespace geolloyd
