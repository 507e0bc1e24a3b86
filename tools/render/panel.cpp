#include "tools/render/panel.h"

#include "geolloyd/errors.h"

namespace geolloyd {

const std::vector<Named<PanelKind>> panel_kind_names = {
    {"surface", PanelKind::surface},
    {"mesh", PanelKind::mesh},
    {"regions", PanelKind::regions},
    {"trees", PanelKind::trees},
    {"ground-truth", PanelKind::ground_truth},
    {"dual", PanelKind::dual},
    {"field", PanelKind::field},
};

Panel parse_panel(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::string name = text.substr(0, sign);
  std::string known;
  for (const Named<PanelKind>& named : panel_kind_names) {
    if (name == named.name) {
      if (sign == std::string::npos) return {named.value, std::nullopt};
      return {named.value, text.substr(sign + 1)};
    }
    known += (known.empty() ? "" : ", ") + std::string(named.name);
  }
  throw InvalidInput("--panel " + text + ": give one of " + known + ", or NAME=CAPTION");
}

std::string caption_of(const Panel& panel, std::size_t panel_count) {
  if (panel.caption) return *panel.caption;
  return panel_count > 1 ? name_of(panel_kind_names, panel.kind) : "";
}

}  // namespace geolloyd
