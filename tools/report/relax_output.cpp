#include "tools/report/relax_output.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/loops.h"
#include "geolloyd/errors.h"
#include "tools/files/csv.h"
#include "tools/render/labels.h"
#include "tools/render/painters.h"
#include "tools/render/picture.h"
#include "tools/report/report_parts.h"
#include "tools/report/vtp_output.h"
#include "tools/run/checkpoint.h"
#include "tools/run/frames.h"

namespace geolloyd {
namespace {

constexpr std::array<const char*, 5> relax_names = {"tessellation.ply", "seeds.csv", "regions.csv",
                                                    "dual.ply", "report.json"};

std::filesystem::path path_of(const RelaxTargets& targets, RelaxOutput output) {
  return targets.folder / relax_names[static_cast<std::size_t>(output)];
}

// In their order, wherever they were named.
std::vector<std::filesystem::path> wanted_files(const RelaxTargets& targets) {
  std::vector<std::filesystem::path> paths;
  for (const RelaxOutput output : values_of(relax_output_names)) {
    if (targets.writes(output)) paths.push_back(path_of(targets, output));
  }
  return paths;
}

void write_seeds_csv(const MeshGraph& mesh_graph, std::span<const RegionSummary> regions,
                     FileWriter& out) {
  out.text("input_id,kind,x,y,z,nodes,area,energy\n");
  for (const RegionSummary& region : regions) {
    const std::uint32_t id = mesh_graph.input_id[region.seed];
    const Vec3& p = mesh_graph.position[region.seed];
    write_row(out, id, kind_of(mesh_graph, id), p.x(), p.y(), p.z(), region.node_count, region.area,
              region.energy);
  }
}

void write_regions_csv(const MeshGraph& mesh_graph, const Partition& partition, FileWriter& out) {
  out.text("input_id,kind,region,distance\n");
  const std::vector<NodeId>& node_of = mesh_graph.node_of;
  for (std::uint32_t id = 0; id < node_of.size(); ++id) {
    const std::string_view kind = kind_of(mesh_graph, id);
    if (node_of[id] == no_id) {
      write_row(out, id, kind, "-1", "nan");
    } else {
      const Key key = partition.key[node_of[id]];
      const double distance = distance_of(key) * mesh_graph.graph.tick_length;
      write_row(out, id, kind, region_of(key), static_cast<float>(distance));
    }
  }
}

void write_dual(const Result& result, FileWriter& out) {
  const Mesh& mesh = result.dual->mesh;
  if (result.dual->quads) {
    write_faces_ply(out, mesh, result.dual->quads->faces, result.dual->properties);
  } else {
    write(out, mesh, result.dual->properties);
  }
}

}  // namespace

MadeFolders prepare_output(const RelaxTargets& targets, std::vector<std::filesystem::path> inputs,
                           bool is_resumed) {
  std::vector<std::filesystem::path> others = std::move(inputs);
  MadeFolders made = prepare_folder(targets.folder, relax_names, others);
  check_target(checkpoint_path(targets.folder), others);
  if (!targets.frames.empty()) made.add(prepare_frames(targets.frames, is_resumed));
  for (const char* name : relax_names) others.push_back(targets.folder / name);
  others.push_back(checkpoint_path(targets.folder));
  if (!targets.page_file.empty()) {
    check_target(targets.page_file, others);
    others.push_back(targets.page_file);
  }
  if (!targets.vtp_file.empty()) {
    check_vtp_target(targets.vtp_file, others);
    others.push_back(targets.vtp_file);
  }
  if (targets.picture_file.empty()) return made;
  check_target(targets.picture_file, others);
  std::error_code error;
  if (!targets.frames.empty() &&
      std::filesystem::equivalent(
          std::filesystem::absolute(targets.picture_file, error).parent_path(), targets.frames,
          error)) {
    throw InvalidInput(targets.picture_file.string() +
                       ": is in the folder of the frames: give another place");
  }
  return made;
}

std::vector<std::string> names_of_results(const RelaxTargets& targets) {
  std::vector<std::string> names;
  for (const std::filesystem::path& path : wanted_files(targets)) {
    names.push_back(path.filename().string());
  }
  return names;
}

ResultFiles::ResultFiles(const RelaxTargets& targets)
    : targets_(targets), files_(wanted_files(targets)) {}

FileWriter* ResultFiles::find(RelaxOutput output) {
  if (!targets_.writes(output)) return nullptr;
  std::size_t place = 0;
  for (const RelaxOutput other : values_of(relax_output_names)) {
    if (other < output && targets_.writes(other)) ++place;
  }
  return &files_[place];
}

// The last one first: without report.json the others are no whole result.
std::vector<std::string> ResultFiles::commit() {
  files_.finish();
  std::vector<std::string> removed;
  std::vector<RelaxOutput> outputs = values_of(relax_output_names);
  std::reverse(outputs.begin(), outputs.end());
  for (const RelaxOutput output : outputs) {
    const std::filesystem::path path = path_of(targets_, output);
    std::error_code error;
    if (targets_.writes(output) || !std::filesystem::exists(path, error)) continue;
    remove_file(path);
    removed.insert(removed.begin(), path.filename().string());
  }
  files_.commit();
  return removed;
}

void write_results(const PreparedInput& start, const Result& result, ResultFiles& files,
                   Executor& executor) {
  const MeshGraph& mesh_graph = start.mesh_graph;
  const Partition& partition = result.relaxation.partition;
  const auto write_if_wanted = [&](RelaxOutput output, auto&& write) {
    if (FileWriter* const file = files.find(output)) write(*file);
  };
  parallel_invoke(
      executor,
      [&] {
        write_if_wanted(RelaxOutput::tessellation, [&](FileWriter& file) {
          const std::vector<Label> label =
              label_input_ids(mesh_graph, partition, result.regions.size());
          const std::span<const Label> labels = label;
          const std::size_t vertices =
              has_vertices(mesh_graph.kind) ? start.input.facts.vertices : 0;
          write_labelled_ply(file, start.input.mesh(), labels.first(vertices),
                             labels.subspan(vertices), start.input.loaded.properties);
        });
      },
      [&] {
        write_if_wanted(RelaxOutput::regions,
                        [&](FileWriter& file) { write_regions_csv(mesh_graph, partition, file); });
      },
      [&] {
        write_if_wanted(RelaxOutput::dual, [&](FileWriter& file) { write_dual(result, file); });
      },
      [&] {
        write_if_wanted(RelaxOutput::seeds, [&](FileWriter& file) {
          write_seeds_csv(mesh_graph, result.regions, file);
        });
      });
}

void write_picture(const std::filesystem::path& path, const PictureLook& look,
                   const PreparedInput& start, const Relaxation& relaxation, Executor& executor) {
  const Picture picture(start.input.mesh(), look.view, look.size, 1, false, executor);
  const std::vector<Colour> colours =
      colours_of_regions(start.mesh_graph.graph, relaxation.partition, relaxation.seeds.size());
  const Canvas canvas =
      paint_regions({start.mesh_graph, relaxation.partition, relaxation.seeds, colours},
                    picture.scene(), executor);
  const std::array<PanelImage, 1> panels = {{{to_pixels(picture.scene(), canvas, executor), ""}}};
  picture.write(path, panels);
}

}  // namespace geolloyd
