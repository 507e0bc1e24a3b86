#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/regions/graph_dual.h"
#include "tools/files/output_folder.h"
#include "tools/view/session/session_command.h"
#include "tools/view/session/stepped_tessellation.h"

namespace geolloyd {

struct SessionRemesh;

/// Makes the folder, locks it, and makes sure that all that is ever saved can be written there and
/// would replace no file of `inputs`. Throws Error. Nothing where no folder is named.
[[nodiscard]] MadeFolders prepare_saving(const std::filesystem::path& folder,
                                         std::span<const std::filesystem::path> inputs);

/// The dual of the seeds as they are.
GraphDual dual_of(SteppedTessellation& tessellation, Executor& executor);

/// Writes the files of `relax`, first-seeds.csv and, if there is one, the surface remesh; or
/// picture.png; or page.html. Returns what was written, for people. Throws Error.
std::string save_into(const std::filesystem::path& folder, Saving what,
                      SteppedTessellation& tessellation, const std::optional<SessionRemesh>& remesh,
                      Runtime& runtime);

}  // namespace geolloyd
