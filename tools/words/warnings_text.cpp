#include "tools/words/warnings_text.h"

#include <algorithm>

namespace geolloyd {

std::string lines_of_warnings(std::span<const RemeshWarning> warnings, const std::string& about) {
  std::string lines;
  for (const RemeshWarning& warning : warnings) {
    std::string line = "geolloyd: warning: " + (about.empty() ? "" : about + ": ") + warning.text;
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, '?');
    lines += line + "\n";
  }
  return lines;
}

}  // namespace geolloyd
