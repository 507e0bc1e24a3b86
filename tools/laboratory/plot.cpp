#include "tools/laboratory/plot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

// Beside the installed program, or else where this one was built from.
std::filesystem::path script() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      program.parent_path().parent_path() / "share" / "geolloyd" / "plot.py";
  return std::filesystem::exists(installed, error) ? installed
                                                   : std::filesystem::path(GEOLLOYD_PLOT_SCRIPT);
}

}  // namespace

void draw_plot(const std::filesystem::path& result_file) {
  std::fflush(stdout);
  std::string python = "python3";
  std::string program = script().string();
  std::string argument = result_file.string();
  const std::array<char*, 4> arguments = {python.data(), program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = [&] {
    const LiftedMemoryLimit lifted;  // it is ours
    return posix_spawnp(&child, python.c_str(), nullptr, nullptr, arguments.data(), environ);
  }();
  if (error != 0) {
    std::fprintf(stderr, "no picture: python3: %s\n", std::strerror(error));
    return;
  }
  waitpid(child, nullptr, 0);
}

}  // namespace geolloyd
