#pragma once

#include <optional>
#include <string>

#include "geolloyd/repair.h"
#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Whether and how an input is repaired before all else.
struct RepairArguments {
  bool is_wanted = false;
  bool has_hole_size = false;  ///< given, not the default
  RepairOptions options;

  /// Empty: none is wanted.
  [[nodiscard]] std::optional<RepairOptions> wanted() const {
    return is_wanted ? std::optional(options) : std::nullopt;
  }
};

/// --fill-holes.
void add_hole_option(CLI::App& command, RepairArguments& repair);
/// --repair and --fill-holes.
void add_repair_options(CLI::App& command, RepairArguments& repair);
/// Throws InvalidInput for --fill-holes without --repair, and where an option names vertices or
/// triangles, which a repair renumbers. `option` is empty if no such option is given.
void check_repair(const RepairArguments& repair, const std::string& option);

}  // namespace geolloyd
