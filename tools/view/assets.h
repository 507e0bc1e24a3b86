#pragma once

#include <string_view>

namespace geolloyd {

/// The browser's part of the viewer, as the build made it (app/build.mjs).
struct ViewerAssets {
  std::string_view script;
  std::string_view style;
  std::string_view index;  ///< of a session: asks for the script and the style
  std::string_view page;   ///< of a page: has marks for script, style, title and data
};

/// Throws InvalidInput, with the way to get it, where the program was built without.
ViewerAssets viewer_assets();

}  // namespace geolloyd
