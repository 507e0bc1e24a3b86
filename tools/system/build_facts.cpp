#include "tools/system/build_facts.h"

#include <fmt/format.h>
#include <string_view>

namespace geolloyd {
namespace {

#if defined(__clang__)
constexpr const char* compiler = "Clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

constexpr std::string_view commit = GEOLLOYD_COMMIT;

}  // namespace

std::string program_name() {
  constexpr std::string_view name = "geolloyd " GEOLLOYD_VERSION;
  return commit.empty() ? std::string(name) : fmt::format("{} ({})", name, commit);
}

std::string compiler_name() {
  return compiler;
}

std::string build_facts_text() {
  return fmt::format(
      "{}\n"
      "  compiler   {}\n"
      "  flags      {}: {}\n"
      "  libraries  {}",
      program_name(), compiler, GEOLLOYD_BUILD_TYPE, GEOLLOYD_BUILD_FLAGS, GEOLLOYD_LIBRARIES);
}

}  // namespace geolloyd
