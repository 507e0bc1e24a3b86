#include "tests/support/counted_new.h"

#include <cstdlib>
#include <new>

namespace geolloyd {
namespace {

constinit Allocations so_far;

void* counted(std::size_t bytes, void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  ++so_far.count;
  so_far.bytes += bytes;
  return memory;
}

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

}  // namespace

Allocations allocations() {
  return so_far;
}

}  // namespace geolloyd

// The other forms of new and delete, those of arrays among them, call these.

void* operator new(std::size_t bytes) {
  return geolloyd::counted(bytes, std::malloc(bytes == 0 ? 1 : bytes));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  const std::size_t room = geolloyd::round_up(bytes == 0 ? 1 : bytes, unit);
  return geolloyd::counted(bytes, std::aligned_alloc(unit, room));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t /*bytes*/) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
