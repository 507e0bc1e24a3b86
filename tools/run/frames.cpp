#include "tools/run/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <system_error>
#include <utility>

#include "geolloyd/errors.h"
#include "tools/render/painters.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

std::string frame_name(std::size_t number, Phase phase) {
  return fmt::format("{:03}-{}.png", number, name_of(phase_names, phase));
}

bool is_frame_name(const std::string& name) {
  const std::size_t sign = name.find('-');
  if (sign == 0 || sign == std::string::npos) return false;
  const bool has_number =
      std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(sign),
                  [](unsigned char c) { return std::isdigit(c) != 0; });
  const std::string rest = name.substr(sign);
  return has_number && (rest == "-greedy.png" || rest == "-precise.png");
}

}  // namespace

MadeFolders prepare_frames(const std::filesystem::path& folder, bool is_resumed) {
  const std::string first = frame_name(0, Phase::greedy);
  const std::array<const char*, 1> names = {first.c_str()};
  const std::vector<std::filesystem::path> others;
  MadeFolders made = prepare_folder(folder, names, others);
  if (is_resumed) return made;
  std::error_code error;
  const std::filesystem::directory_iterator entries(folder, error);
  if (error) throw IoError(folder.string() + ": cannot read: " + error.message());
  for (const auto& entry : entries) {
    if (!is_frame_name(entry.path().filename().string())) continue;
    throw InvalidInput(entry.path().string() +
                       ": is a frame of another run: remove them all, or give another folder");
  }
  return made;
}

Frames::Frames(std::filesystem::path folder, const PictureLook& look, const PreparedInput& run,
               Runtime& runtime)
    : folder_(std::move(folder)),
      mesh_graph_(run.mesh_graph),
      executor_(runtime.executor()),
      picture_(run.input.mesh(), look.view, look.size, 1, true, executor_),
      colours_(colours_of_regions(mesh_graph_.graph,
                                  partition_seeds(mesh_graph_.graph, run.seeds, runtime).partition,
                                  run.seeds.size())) {}

void Frames::draw(const StepStart& step) const {
  const std::string phase = name_of(phase_names, step.phase);
  const std::string caption =
      fmt::format("{} step {}, energy {:.5g}", phase, step.number, step.energy);
  const Canvas canvas = paint_regions({mesh_graph_, step.partition, step.seeds, colours_},
                                      picture_.scene(), executor_);
  const std::array<PanelImage, 1> panels = {
      {{to_pixels(picture_.scene(), canvas, executor_), caption}}};
  picture_.write(folder_ / frame_name(step.steps_before, step.phase), panels);
}

}  // namespace geolloyd
