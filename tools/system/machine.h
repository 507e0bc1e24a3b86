#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace geolloyd {

/// Where and by what a time was measured.
struct Machine {
  std::string processor;
  std::size_t threads = 0;  ///< that can run at once
  std::uint64_t memory_bytes = 0;
  std::string system;    ///< and architecture
  std::string compiler;  ///< this program's
};

Machine this_machine();

/// Most memory this process has held since it began or since the last forget_peak_memory(), bytes.
std::uint64_t peak_memory_bytes();

/// Gives unused memory back to the system and begins to look for the peak anew. Where the system
/// does not allow that, the old peak stays.
void forget_peak_memory();

}  // namespace geolloyd
