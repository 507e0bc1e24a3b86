#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/words/named.h"

namespace geolloyd {

/// What a panel shows (painters.h).
enum class PanelKind { surface, mesh, regions, trees, ground_truth, dual, field };
extern const std::vector<Named<PanelKind>> panel_kind_names;

inline bool needs_partition(PanelKind kind) {
  return kind == PanelKind::regions || kind == PanelKind::trees ||
         kind == PanelKind::ground_truth || kind == PanelKind::dual;
}

/// A part of a picture, as it is asked for.
struct Panel {
  PanelKind kind = PanelKind::surface;
  std::optional<std::string> caption;
};

/// "NAME" or "NAME=CAPTION". Throws InvalidInput.
Panel parse_panel(const std::string& text);

/// What stands under a panel: its caption or, where there are others beside it, its name.
std::string caption_of(const Panel& panel, std::size_t panel_count);

}  // namespace geolloyd
