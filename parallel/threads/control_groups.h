#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geolloyd {

/// A control group of this process. Containers and service managers limit processes by them.
struct ControlGroup {
  std::filesystem::path folder;  ///< of the files that say what the limits are
  int version;                   ///< 1 or 2, on which the names of the files depend
};

/// The groups that may limit what `controller` shares out ("cpu", "memory"), each before the one
/// that it is in. A container may see its own group as the root. `root` is for tests.
std::vector<ControlGroup> control_groups(const std::string& controller,
                                         const std::filesystem::path& root = "/");

}  // namespace geolloyd
