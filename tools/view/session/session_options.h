#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/course/run_plan.h"
#include "tools/files/json.h"

namespace geolloyd {

/// What a session tessellates with. A file of seeds is only that of the command line.
struct SessionOptions {
  GraphPlan graph;
  SeedPlan seeds;
  SeedFile seed_file;
  std::optional<GreedyMode> greedy;
};

/// As the browser has it: names of choices, and numbers.
Json options_part(const SessionOptions& options);

/// The names of all choices. A tangent field is none, one of the surface's own, or the file that
/// the command line named, if any.
Json choices_part(const std::filesystem::path& field_file);

/// The options with what `changes` names put in their place. Throws InvalidInput where it names
/// something else, or a value is none of the choices.
SessionOptions changed(const SessionOptions& options, const Json& changes,
                       const std::filesystem::path& field_file);

}  // namespace geolloyd
