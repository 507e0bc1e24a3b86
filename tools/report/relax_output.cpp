#include "tools/report/relax_output.h"

#include <array>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/errors.h"
#include "core/base/loops.h"
#include "tools/files/output_folder.h"
#include "tools/files/rows.h"
#include "tools/render/painters.h"
#include "tools/render/picture.h"
#include "tools/report/report.h"
#include "tools/run/checkpoint.h"
#include "tools/run/frames.h"

namespace geolloyd {
namespace {

constexpr std::array<const char*, 5> relax_names = {"tessellation.ply", "seeds.csv", "regions.csv",
                                                    "remesh.ply", "report.json"};
enum ResultFile { tessellation_place, seeds_place, regions_place, remesh_place, report_place };

void write_seeds_csv(const RunRecord& run, FileWriter& out) {
  out.text("input_id,kind,x,y,z,nodes,area,energy\n");
  for (const RegionSummary& region : run.regions) {
    const std::uint32_t id = run.mesh_graph.input_id[region.seed];
    const Vec3& p = run.mesh_graph.position[region.seed];
    write_row(out, id, kind_of(run.mesh_graph, id), p.x(), p.y(), p.z(), region.node_count,
              region.area, region.energy);
  }
}

void write_regions_csv(const RunRecord& run, FileWriter& out) {
  out.text("input_id,kind,region,distance\n");
  const std::vector<NodeId>& node_of = run.mesh_graph.node_of;
  for (std::uint32_t id = 0; id < node_of.size(); ++id) {
    const std::string_view kind = kind_of(run.mesh_graph, id);
    if (node_of[id] == no_id) {
      write_row(out, id, kind, "-1", "nan");
    } else {
      const Key key = run.relaxation.partition.key[node_of[id]];
      const double distance = distance_of(key) * run.mesh_graph.graph.tick_length;
      write_row(out, id, kind, region_of(key), static_cast<float>(distance));
    }
  }
}

}  // namespace

void prepare_output(const RelaxArguments& arguments) {
  std::vector<std::filesystem::path> others = {arguments.mesh, arguments.vfield,
                                               arguments.seeds_file};
  prepare_folder(arguments.output, relax_names, others);
  check_target(checkpoint_path(arguments.output), others);
  if (!arguments.frames.empty()) prepare_frames(arguments);
  if (arguments.picture.empty()) return;
  for (const char* name : relax_names) others.push_back(arguments.output / name);
  others.push_back(checkpoint_path(arguments.output));
  check_target(arguments.picture, others);
  std::error_code error;
  if (!arguments.frames.empty() &&
      std::filesystem::equivalent(std::filesystem::absolute(arguments.picture, error).parent_path(),
                                  arguments.frames, error)) {
    throw InvalidInput(arguments.picture.string() +
                       ": is in the folder of the frames: give another place");
  }
}

FileGroup open_results(const RelaxArguments& arguments) {
  return {arguments.output, relax_names};
}

void write_results(const RunRecord& run, FileGroup& files, Scheduler& scheduler) {
  const std::span<const Label> labels = run.labels;
  const std::size_t vertices = has_vertices(run.mesh_graph.kind) ? run.facts.vertices : 0;
  parallel_invoke(
      scheduler,
      [&] {
        write_labelled_ply(files[tessellation_place], run.input.mesh, labels.first(vertices),
                           labels.subspan(vertices));
      },
      [&] { write_regions_csv(run, files[regions_place]); },
      [&] { write_mesh(files[remesh_place], run.remesh.mesh); },
      [&] { write_seeds_csv(run, files[seeds_place]); });
}

void write_picture(const RunRecord& run, Scheduler& scheduler) {
  const RelaxArguments& a = run.arguments;
  const Picture picture(run.input.mesh, parse_view(a.view), parse_size(a.size), 1, false,
                        scheduler);
  const std::vector<Colour> colours = colours_of_regions(
      run.mesh_graph.graph, run.relaxation.partition, run.relaxation.seeds.size());
  const Canvas canvas =
      paint_regions({run.mesh_graph, run.relaxation.partition, run.relaxation.seeds, colours},
                    picture.scene(), scheduler);
  const std::array<PanelImage, 1> panels = {{{to_pixels(picture.scene(), canvas, scheduler), ""}}};
  picture.write(a.picture, panels);
}

void write_report(const RunRecord& run, FileGroup& files) {
  files[report_place].text(report_text(run));
  files.commit();
}

}  // namespace geolloyd
