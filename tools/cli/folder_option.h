#pragma once

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Makes an option take the name of a folder, there already or not. The name of a mesh file is
/// refused: where a folder is meant, it is a mistake.
CLI::Option* folder_name(CLI::Option* option);

}  // namespace geolloyd
