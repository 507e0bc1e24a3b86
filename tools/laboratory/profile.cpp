#include "tools/laboratory/profile.h"

#include <nlohmann/json.hpp>

#include "tools/words/names.h"

namespace geolloyd {

PhaseProfile profile_of(const Relaxation& relaxation, Phase phase) {
  PhaseProfile profile;
  for (const Step& step : relaxation.steps) {
    if (step.phase != phase) continue;
    ++profile.steps;
    profile.microsteps += step.microsteps.size();
    profile.node_visits += step.node_visits;
    profile.seconds += step.seconds;
  }
  return profile;
}

std::uint32_t active_regions(const Step& step) {
  return step.phase == Phase::greedy ? step.seeds_moved : step.microsteps.front().seeds_moved;
}

Json phase_rows(const Relaxation& relaxation) {
  Json rows = Json::array();
  for (const auto& [name, phase] : phase_names) {
    const PhaseProfile profile = profile_of(relaxation, phase);
    if (profile.steps == 0) continue;
    rows.push_back({{"phase", name},
                    {"steps", profile.steps},
                    {"microsteps", profile.microsteps},
                    {"seconds", total(profile.seconds)},
                    {"node_visits", profile.node_visits},
                    {"search_share", profile.search_share()},
                    {"kernel_seconds", kernel_seconds_part(profile.seconds)}});
  }
  return rows;
}

Json step_rows(const Relaxation& relaxation) {
  Json rows = Json::array();
  std::size_t greedy_steps = 0;
  for (const Step& step : relaxation.steps) {
    if (step.phase == Phase::greedy) ++greedy_steps;
    rows.push_back(
        {{"phase", name_of(phase_names, step.phase)},
         {"step", step.phase == Phase::greedy ? greedy_steps : rows.size() + 1 - greedy_steps},
         {"active_regions", active_regions(step)},
         {"seeds_moved", step.seeds_moved},
         {"microsteps", step.microsteps.size()},
         {"node_visits", step.node_visits},
         {"energy", step.energy},
         {"seconds", total(step.seconds)},
         {"kernel_seconds", kernel_seconds_part(step.seconds)}});
  }
  return rows;
}

}  // namespace geolloyd
