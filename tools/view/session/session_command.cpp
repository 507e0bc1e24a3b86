#include "tools/view/session/session_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geolloyd/errors.h"
#include "tools/view/session/json_values.h"

namespace geolloyd {

const std::vector<Named<Action>> action_names = {
    {"set", Action::set},
    {"add_seed", Action::add_seed},
    {"remove_seed", Action::remove_seed},
    {"move_seed", Action::move_seed},
    {"choose_seeds", Action::choose_seeds},
    {"greedy_step", Action::greedy_step},
    {"microstep", Action::microstep},
    {"macrostep", Action::macrostep},
    {"run", Action::run},
    {"pause", Action::pause},
    {"reset", Action::reset},
    {"truth", Action::truth},
    {"dual", Action::dual},
    {"remesh", Action::remesh},
    {"stop", Action::stop},
    {"save", Action::save},
};

const std::vector<Named<Saving>> saving_names = {
    {"result", Saving::result},
    {"picture", Saving::picture},
    {"page", Saving::page},
};

namespace {

constexpr std::uint64_t most_id = no_id - 1;
constexpr std::uint64_t fewest_remesh_vertices = 4;

Json parse_object(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    throw InvalidInput(R"(command: give a JSON object, as {"do": "run"})");
  }
  return json;
}

// The keys that each action takes besides "do"; set looks at its own.
std::vector<std::string> keys_of(Action action) {
  switch (action) {
    case Action::add_seed:
      return {"id"};
    case Action::remove_seed:
      return {"region"};
    case Action::move_seed:
      return {"id", "region"};
    case Action::remesh:
      return {"vertices"};
    case Action::save:
      return {"what"};
    default:
      return {};
  }
}

void check_keys(const std::string& name, const Json& json, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    if (!json.contains(key)) throw InvalidInput(fmt::format("{}: give its {}", name, key));
  }
  if (json.size() != keys.size() + 1) {
    throw InvalidInput(fmt::format("{}: has a value that no such command takes", name));
  }
}

void read_value(SessionCommand& command, const std::string& key, const Json& value) {
  if (key == "id") command.id = static_cast<InputId>(whole_number_in(key, value, 0, most_id));
  if (key == "region") {
    command.region = static_cast<RegionId>(whole_number_in(key, value, 0, most_id));
  }
  if (key == "vertices") {
    command.vertices = whole_number_in(key, value, fewest_remesh_vertices, most_id);
  }
  if (key == "what") {
    command.what = value_of(saving_names, name_among(key, value, names_of(saving_names)));
  }
}

}  // namespace

const char* text_of(Action action) {
  switch (action) {
    case Action::set:
      return "building the graph and choosing seeds";
    case Action::choose_seeds:
      return "choosing seeds";
    case Action::truth:
      return "finding the ground truth";
    case Action::dual:
      return "making the dual";
    case Action::remesh:
      return "moving the sites of a remesh";
    case Action::save:
      return "saving";
    default:
      return "moving seeds";
  }
}

SessionCommand parse_command(std::string_view text) {
  Json json = parse_object(text);
  const auto name = json.find("do");
  if (name == json.end()) throw InvalidInput("command: give what to \"do\"");
  SessionCommand command;
  const std::string action = name_among("do", *name, names_of(action_names));
  command.action = value_of(action_names, action);
  if (command.action == Action::set) {
    command.changes = std::move(json);
    return command;
  }
  const std::vector<std::string> keys = keys_of(command.action);
  check_keys(action, json, keys);
  for (const std::string& key : keys) read_value(command, key, json[key]);
  return command;
}

}  // namespace geolloyd
