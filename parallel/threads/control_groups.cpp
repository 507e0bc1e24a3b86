#include "parallel/threads/control_groups.h"

#include <fstream>

namespace geolloyd {
namespace {

void add_groups(const std::filesystem::path& mount, std::filesystem::path group, int version,
                std::vector<ControlGroup>& groups) {
  for (group = group.relative_path();; group = group.parent_path()) {
    groups.push_back({mount / group, version});
    if (group.empty()) return;
  }
}

}  // namespace

// Lines like "4:cpu,cpuacct:/path" and, of version 2, "0::/path".
std::vector<ControlGroup> control_groups(const std::string& controller,
                                         const std::filesystem::path& root) {
  std::ifstream in(root / "proc/self/cgroup");
  std::vector<ControlGroup> groups;
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    std::string controllers = line.substr(first, second - first + 1);
    controllers.front() = controllers.back() = ',';
    const std::filesystem::path group = line.substr(second + 1);
    const std::filesystem::path mounts = root / "sys/fs/cgroup";
    if (controllers == ",,") add_groups(mounts, group, 2, groups);
    if (controllers.find("," + controller + ",") != std::string::npos) {
      add_groups(mounts / controller, group, 1, groups);
    }
  }
  return groups;
}

}  // namespace geolloyd
