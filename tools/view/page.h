#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "tools/view/bundle.h"

namespace geolloyd {

/// Larger pages take long to send and to open.
inline constexpr std::size_t most_page_bytes = 20'000'000;

/// Throws InvalidInput where the program was built without its viewer.
void check_viewer();

/// Text for people in an HTML page, in attributes too.
std::string html_text(const std::string& text);

/// Writes a page that holds the viewer and the bundle: it needs no server and no network. Where it
/// would be larger than `most_bytes`, places get 16 bits, and if that is not enough, the mesh is
/// simplified; notes in the page say so. Returns them, with the size, for the summary. Throws
/// Error.
std::string write_page(const std::filesystem::path& page, Bundle bundle,
                       std::size_t most_bytes = most_page_bytes);

}  // namespace geolloyd
