#include "tools/system/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void fail() {
  throw IoError("standard output: cannot write: " + std::generic_category().message(errno));
}

// What all commands print goes nowhere from now on.
void lead_nowhere() {
  if (std::freopen("/dev/null", "w", stdout) == nullptr) fail();
}

}  // namespace

void Console::keep_standard_output() {
  if (standard_output_ >= 0) return;
  standard_output_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  if (standard_output_ < 0) fail();
}

void Console::silence() {
  keep_standard_output();
  is_silent_ = true;
  lead_nowhere();
}

void Console::want_json() {
  keep_standard_output();
  wants_json_ = true;
  lead_nowhere();
}

int Console::lend_standard_output() {
  if (wants_json_) {
    throw InvalidInput("standard output: takes the mesh or --json, not both: name a file");
  }
  keep_standard_output();
  if (::write(standard_output_, "", 0) < 0) fail();
  if (!is_silent_ && ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) fail();
  std::signal(SIGPIPE, SIG_IGN);
  return standard_output_;
}

void Console::print_json(const std::string& text) const {
  for (std::string_view left = text; !left.empty();) {
    const ssize_t count = ::write(standard_output_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    left.remove_prefix(static_cast<std::size_t>(count));
  }
}

void tell_warnings(const std::string& lines, bool is_strict, const Console& console) {
  if (console.wants_json() || (console.is_silent() && !is_strict)) return;
  std::fflush(stdout);
  std::fputs(lines.c_str(), stderr);
}

}  // namespace geolloyd
