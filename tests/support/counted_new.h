#pragma once

#include <cstddef>

namespace geolloyd {

/// What operator new has given out so far, in a program that counted_new.cpp is part of. For
/// programs of one thread.
struct Allocations {
  std::size_t count = 0;
  std::size_t bytes = 0;
};

Allocations allocations();

}  // namespace geolloyd
