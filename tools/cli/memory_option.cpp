#include "tools/cli/memory_option.h"

#include <CLI/App.hpp>

#include "tools/cli/number_option.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {

void add_memory_option(CLI::App& command) {
  byte_count(command.add_option_function<std::uint64_t>(
      "--memory-limit", limit_memory,
      "Limit of memory, such as 8G or 800M: runs that need more are\n"
      "refused (default: what the machine has left)"));
}

}  // namespace geolloyd
