#include "tools/run/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string>
#include <system_error>

#include "core/voronoi/energy.h"
#include "geolloyd/errors.h"
#include "tools/files/output_folder.h"
#include "tools/render/painters.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

std::string frame_name(std::uint32_t number, Phase phase) {
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

void prepare_frames(const RelaxArguments& arguments) {
  const std::string first = frame_name(0, Phase::greedy);
  const std::array<const char*, 1> names = {first.c_str()};
  const std::vector<std::filesystem::path> others;
  prepare_folder(arguments.frames, names, others);
  if (arguments.resume) return;
  std::error_code error;
  const std::filesystem::directory_iterator entries(arguments.frames, error);
  if (error) throw IoError(arguments.frames.string() + ": cannot read: " + error.message());
  for (const auto& entry : entries) {
    if (!is_frame_name(entry.path().filename().string())) continue;
    throw InvalidInput(entry.path().string() +
                       ": is a frame of another run: remove them all, or give another folder");
  }
}

FramesEngine::FramesEngine(Engine& engine, const RelaxArguments& arguments, const Start& start,
                           Executor& executor, std::span<const Step> steps)
    : engine_(engine),
      folder_(arguments.frames),
      mesh_graph_(start.mesh_graph),
      executor_(executor),
      picture_(start.input.mesh(), arguments.picture.view, arguments.picture.size, 1, true,
               executor),
      frames_(static_cast<std::uint32_t>(steps.size())),
      greedy_frames_(static_cast<std::uint32_t>(
          std::count_if(steps.begin(), steps.end(),
                        [](const Step& step) { return step.phase == Phase::greedy; }))) {
  engine_.partition(start.seeds);
  colours_ = colours_of_regions(mesh_graph_.graph, engine_.current(), start.seeds.size());
}

std::vector<NodeId> FramesEngine::greedy_candidates(std::span<const NodeId> seeds, bool extended) {
  draw(seeds, Phase::greedy);
  ++greedy_frames_;
  return engine_.greedy_candidates(seeds, extended);
}

std::vector<Microstep> FramesEngine::macrostep(std::vector<NodeId>& seeds,
                                               const MacrostepOptions& options,
                                               const KeepGoing& keep_going) {
  draw(seeds, Phase::precise);
  return engine_.macrostep(seeds, options, keep_going);
}

void FramesEngine::draw(std::span<const NodeId> seeds, Phase phase) {
  const std::span<const Score> scores = region_scores();
  const double energy =
      to_energy(mesh_graph_.graph, std::accumulate(scores.begin(), scores.end(), Score{0}));
  const std::uint32_t step = frames_ - (phase == Phase::precise ? greedy_frames_ : 0);
  const std::string caption =
      fmt::format("{} step {}, energy {:.5g}", name_of(phase_names, phase), step + 1, energy);
  const Canvas canvas =
      paint_regions({mesh_graph_, current(), seeds, colours_}, picture_.scene(), executor_);
  const std::array<PanelImage, 1> panels = {
      {{to_pixels(picture_.scene(), canvas, executor_), caption}}};
  picture_.write(folder_ / frame_name(frames_, phase), panels);
  ++frames_;
}

}  // namespace geolloyd
