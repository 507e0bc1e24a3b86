#include "tools/view/session/session_options.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geolloyd/errors.h"
#include "tools/view/session/json_values.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

constexpr const char* no_field = "none";

std::vector<std::string> field_names(const std::filesystem::path& field_file) {
  std::vector<std::string> names = {no_field, "curvature", "cross"};
  if (!field_file.empty()) names.push_back(field_file.string());
  return names;
}

template <class Choice>
void change(Choice& choice, const std::string& key, const Json& value,
            const std::vector<Named<Choice>>& names) {
  choice = value_of(names, name_among(key, value, names_of(names)));
}

void change(SessionOptions& options, const std::string& key, const Json& value,
            const std::filesystem::path& field_file) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  if (key == "graph") {
    change(options.graph.kind, key, value, graph_kind_names);
  } else if (key == "norm") {
    change(options.graph.norm, key, value, norm_names);
  } else if (key == "greedy") {
    change(options.greedy, key, value, greedy_choice_names);
  } else if (key == "init") {
    change(options.seeds.init, key, value, seed_init_names);
    options.seed_file.path.clear();
  } else if (key == "field") {
    const std::string name = name_among(key, value, field_names(field_file));
    options.graph.vfield = name == no_field ? "" : name;
  } else if (key == "seed_count") {
    options.seeds.count = whole_number_in(key, value, 1, no_id);
    options.seed_file.path.clear();
  } else if (key == "random_seed") {
    options.seeds.random_seed = whole_number_in(key, value, 0, most);
    options.seed_file.path.clear();
  } else {
    throw InvalidInput(
        "set: no option of that name: give any of graph, norm, field, greedy, "
        "init, seed_count, random_seed");
  }
}

}  // namespace

Json options_part(const SessionOptions& options) {
  const std::filesystem::path& field = options.graph.vfield;
  return {{"graph", name_of(graph_kind_names, options.graph.kind)},
          {"norm", name_of(norm_names, options.graph.norm)},
          {"field", field.empty() ? no_field : field.string()},
          {"greedy", name_of(greedy_choice_names, options.greedy)},
          {"init", name_of(seed_init_names, options.seeds.init)},
          {"seed_count", options.seeds.count},
          {"random_seed", options.seeds.random_seed}};
}

Json choices_part(const std::filesystem::path& field_file) {
  return {{"graph", names_of(graph_kind_names)},
          {"norm", names_of(norm_names)},
          {"field", field_names(field_file)},
          {"greedy", names_of(greedy_choice_names)},
          {"init", names_of(seed_init_names)}};
}

SessionOptions changed(const SessionOptions& options, const Json& changes,
                       const std::filesystem::path& field_file) {
  SessionOptions result = options;
  for (const auto& [key, value] : changes.items()) {
    if (key != "do") change(result, key, value, field_file);
  }
  return result;
}

}  // namespace geolloyd
