#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "geolloyd/types.h"
#include "tools/files/json.h"
#include "tools/words/named.h"

namespace geolloyd {

/// All that a browser can ask a session to do.
enum class Action {
  set,
  add_seed,
  remove_seed,
  move_seed,
  choose_seeds,
  greedy_step,
  microstep,
  macrostep,
  run,
  pause,
  reset,
  truth,
  dual,
  remesh,
  stop,
  save
};
extern const std::vector<Named<Action>> action_names;
/// What is being done, for people.
const char* text_of(Action action);

/// What is saved into the output folder.
enum class Saving { result, picture, page };
extern const std::vector<Named<Saving>> saving_names;

/// A command that was read, with the values that its action has.
struct SessionCommand {
  Action action = Action::pause;
  InputId id = 0;            ///< add_seed, move_seed
  RegionId region = 0;       ///< remove_seed, move_seed
  std::size_t vertices = 0;  ///< remesh
  Saving what = Saving::result;
  Json changes;  ///< set
};

/// {"do": NAME, ...}. Throws InvalidInput where that is no JSON, no such command, lacks a value or
/// has one more, or where a value has the wrong type or cannot be right on any mesh.
SessionCommand parse_command(std::string_view text);

}  // namespace geolloyd
