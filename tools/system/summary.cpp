#include "tools/system/summary.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

bool silent = false;
int standard_output = -1;  // where stdout led to, once that is silent for the sake of JSON

void fail() {
  throw IoError("standard output: cannot write: " + std::generic_category().message(errno));
}

// What all commands print goes nowhere from now on.
void lead_nowhere() {
  if (std::freopen("/dev/null", "w", stdout) == nullptr) fail();
}

}  // namespace

void silence() {
  silent = true;
  lead_nowhere();
}

bool is_silent() {
  return silent;
}

void want_json() {
  standard_output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  if (standard_output < 0) fail();
  lead_nowhere();
}

bool wants_json() {
  return standard_output >= 0;
}

void print_json(const std::string& text) {
  for (std::string_view left = text; !left.empty();) {
    const ssize_t count = ::write(standard_output, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    left.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace geolloyd
