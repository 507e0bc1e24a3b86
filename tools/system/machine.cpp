#include "tools/system/machine.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>

#include "parallel/threads/available_cores.h"
#include "tools/system/build_facts.h"

namespace geolloyd {
namespace {

utsname kernel() {
  utsname names{};
  uname(&names);
  return names;
}

// Not every architecture names its processors.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return kernel().machine;
}

std::uint64_t memory_bytes() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Machine this_machine() {
  const utsname names = kernel();
  return {processor_name(), available_cores(), memory_bytes(),
          fmt::format("{} {}", names.sysname, names.machine), compiler_name()};
}

// Not getrusage: its mark includes what the parent process held.
std::uint64_t peak_memory_bytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stoull(line.substr(6)) * 1024;  // in KiB
  }
  return 0;
}

void forget_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace geolloyd
