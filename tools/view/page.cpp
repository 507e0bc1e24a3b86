#include "tools/view/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/gltf/base64.h"
#include "core/text/file_writer.h"
#include "tools/view/assets.h"
#include "tools/view/simplify.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

std::size_t base64_size(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

std::size_t entries_of(const Bundle& bundle, std::string_view name) {
  for (const BundleArray& array : bundle.arrays) {
    if (array.name != name) continue;
    return std::visit([](const auto& values) { return values.size(); }, array.values) /
           array.components;
  }
  return 0;
}

void add_note(Bundle& bundle, const std::string& note) {
  bundle.info["notes"].push_back(note);
}

void quantise_places(Bundle& bundle) {
  for (BundleArray& array : bundle.arrays) {
    if (array.components % 3 == 0) quantise(array);
  }
  add_note(bundle, "To keep the page small, places are rounded to 1/65534 of the mesh's size.");
}

// What the mesh's vertices and triangles take, and all that belongs to them.
std::size_t mesh_bytes(const Bundle& bundle) {
  std::size_t bytes = 0;
  for (const BundleArray& array : bundle.arrays) {
    if (array.per.empty() || array.name == "parent") continue;
    bytes +=
        std::visit([](const auto& values) { return std::span(values).size_bytes(); }, array.values);
  }
  return bytes;
}

// Of the same bundle with `positions` in 16 bits.
std::string shrink(Bundle& bundle, std::size_t most_bytes) {
  const Bundle whole = bundle;
  quantise_places(bundle);
  std::string bytes = encode(bundle);
  const std::size_t triangles = entries_of(bundle, "triangles");
  for (double share = 0.97; base64_size(bytes.size()) > most_bytes; share *= 0.8) {
    const std::size_t others = bytes.size() - std::min(bytes.size(), mesh_bytes(bundle));
    const std::size_t room = most_bytes / 4 * 3 - std::min(others, most_bytes / 4 * 3);
    const double ratio = static_cast<double>(room) / static_cast<double>(mesh_bytes(bundle));
    const auto vertices = static_cast<std::size_t>(
        share * ratio * static_cast<double>(entries_of(bundle, "positions")));
    bundle = whole;
    simplify(bundle, std::max<std::size_t>(vertices, 1));
    quantise_places(bundle);
    add_note(bundle, fmt::format("The mesh is simplified from {} to {} triangles.{}",
                                 grouped(triangles), grouped(entries_of(bundle, "triangles")),
                                 entries_of(bundle, "region") > 0
                                     ? " Regions and figures are those of the whole mesh; trees "
                                       "are left out."
                                     : ""));
    bytes = encode(bundle);
    if (vertices <= 1) break;
  }
  return bytes;
}

// The frame, with its marks replaced.
void write_frame(FileWriter& out, std::string_view frame, const std::string& title,
                 const std::string& data, const ViewerAssets& assets) {
  const std::array<std::pair<std::string_view, std::string_view>, 4> marks = {
      {{"@TITLE@", title},
       {"@STYLE@", assets.style},
       {"@BUNDLE@", data},
       {"@SCRIPT@", assets.script}}};
  while (!frame.empty()) {
    std::size_t at = frame.size();
    std::size_t length = 0;
    std::string_view replacement;
    for (const auto& [mark, text] : marks) {
      const std::size_t found = frame.find(mark);
      if (found >= at) continue;
      at = found;
      length = mark.size();
      replacement = text;
    }
    out.text(frame.substr(0, at));
    out.text(replacement);
    frame.remove_prefix(at + length);
  }
}

}  // namespace

void check_viewer() {
  static_cast<void>(viewer_assets());
}

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    const std::string_view special = "&<>\"'";
    constexpr std::array<const char*, 5> entities = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    const std::size_t found = special.find(c);
    if (found == std::string_view::npos) {
      safe += c;
    } else {
      safe += entities[found];
    }
  }
  return safe;
}

std::string write_page(const std::filesystem::path& page, Bundle bundle, std::size_t most_bytes) {
  const ViewerAssets assets = viewer_assets();
  const std::size_t frame_bytes = assets.page.size() + assets.style.size() + assets.script.size();
  const std::size_t room = most_bytes - std::min(most_bytes, frame_bytes + 2 * bundle.title.size());
  std::string bytes = encode(bundle);
  if (base64_size(bytes.size()) > room) bytes = shrink(bundle, room);
  FileWriter out(page);
  const std::string data = to_base64(bytes);
  write_frame(out, assets.page, html_text(bundle.title), data, assets);
  out.commit();
  std::string text = fmt::format("  {:<12}{}, {:.1f} MB\n", "page", page.string(),
                                 static_cast<double>(data.size() + frame_bytes) * 1e-6);
  for (const auto& note : bundle.info.value("notes", Json::array())) {
    text += fmt::format("  {:<12}{}\n", "", note.get<std::string>());
  }
  return text;
}

}  // namespace geolloyd
