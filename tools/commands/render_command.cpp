#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "core/base/errors.h"
#include "core/formats/tangent_field_file.h"
#include "tools/commands/commands.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/files/output_folder.h"
#include "tools/render/labels.h"
#include "tools/render/painters.h"
#include "tools/render/panel.h"
#include "tools/render/picture.h"
#include "tools/render/sheet.h"
#include "tools/run/remesh.h"
#include "tools/run/stages.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

struct RenderArguments {
  RelaxArguments relax;
  std::filesystem::path output;
  std::vector<std::string> panels;
};

bool have_captions(const std::vector<Panel>& panels) {
  return std::any_of(panels.begin(), panels.end(),
                     [&](const Panel& panel) { return !caption_of(panel, panels.size()).empty(); });
}

class Renderer {
 public:
  Renderer(const RenderArguments& arguments, const std::vector<Panel>& panels)
      : output_(arguments.output), panels_(panels), scheduler_(make_scheduler(arguments.relax)) {
    run_.arguments = arguments.relax;
    run_.arguments.picture = arguments.output;
    run_.arguments.ground_truth =
        any([](PanelKind kind) { return kind == PanelKind::ground_truth; });
  }

  void render() {
    if (any(needs_partition)) {
      find_partition();
    } else {
      progress_.stage("reading " + run_.arguments.mesh.string());
      load_mesh(run_, scheduler_);
      const Mesh& mesh = run_.input.mesh;
      announce_memory(run_.arguments.mesh.string(),
                      memory_to_draw(mesh.vertex_count(), mesh.triangle_count(),
                                     count_samples(mesh, parse_view(run_.arguments.view),
                                                   parse_size(run_.arguments.size), scheduler_)));
    }
    progress_.stage("drawing " + output_.string());
    const Picture picture(run_.input.mesh, parse_view(run_.arguments.view),
                          parse_size(run_.arguments.size), panels_.size(), have_captions(panels_),
                          scheduler_);
    std::vector<PanelImage> images;
    for (const Panel& panel : panels_) {
      images.push_back({draw(panel.kind, picture.scene()), caption_of(panel, panels_.size())});
    }
    picture.write(output_, images);
  }

 private:
  template <class Predicate>
  [[nodiscard]] bool any(Predicate&& predicate) const {
    return std::any_of(panels_.begin(), panels_.end(),
                       [&](const Panel& panel) { return predicate(panel.kind); });
  }

  void find_partition() {
    run_.relaxation.seeds = prepare(run_, scheduler_, progress_);
    engine_ = partition_seeds(run_, scheduler_);
    colours_ = colours_of_regions(run_.mesh_graph.graph, run_.relaxation.partition,
                                  run_.relaxation.seeds.size());
  }

  Pixels draw(PanelKind kind, const Scene& scene) {
    if (kind != PanelKind::remesh) return to_pixels(scene, paint(kind, scene), scheduler_);
    engine_->partition(run_.relaxation.seeds);
    const Remesh remesh =
        make_remesh({run_.input.mesh, run_.mesh_graph, run_.relaxation.seeds, *engine_},
                    remesh_options(run_.arguments), scheduler_);
    const Scene other = make_scene(remesh.mesh, scene.camera, Shading::flat, scheduler_);
    return to_pixels(other, paint_mesh(other, scheduler_), scheduler_);
  }

  Canvas paint(PanelKind kind, const Scene& scene) {
    const PartitionView view{run_.mesh_graph, run_.relaxation.partition, run_.relaxation.seeds,
                             colours_};
    switch (kind) {
      case PanelKind::surface:
        return paint_surface(scene, scheduler_);
      case PanelKind::mesh:
        return paint_mesh(scene, scheduler_);
      case PanelKind::regions:
        return paint_regions(view, scene, scheduler_);
      case PanelKind::trees:
        return paint_trees(view, scene, scheduler_);
      case PanelKind::ground_truth: {
        const GroundTruth truth =
            make_ground_truth(scheduler_, run_.input.mesh, run_.mesh_graph,
                              run_.relaxation.partition, run_.relaxation.seeds);
        return paint_ground_truth(view, truth.region, truth.surface_centroid, scene, scheduler_);
      }
      case PanelKind::field:
        return paint_field(
            read_tangent_field(run_.arguments.vfield, run_.input.mesh.vertex_count()), scene,
            scheduler_);
      case PanelKind::remesh:
        break;  // has a scene of its own
    }
    return {};
  }

  const std::filesystem::path& output_;
  const std::vector<Panel>& panels_;
  Scheduler scheduler_;
  ProgressLine progress_;
  RunRecord run_;
  std::unique_ptr<Engine> engine_;
  std::vector<Colour> colours_;
};

// What can be found wrong without the mesh is, before the work.
std::vector<Panel> check(const RenderArguments& a) {
  std::vector<Panel> panels;
  for (const std::string& text : a.panels) panels.push_back(parse_panel(text));
  const bool has_seeds = a.relax.seeds > 0 || !a.relax.seeds_file.empty();
  if (panels.empty()) {
    panels.push_back({has_seeds ? PanelKind::regions : PanelKind::surface, std::nullopt});
  }
  for (const Panel& panel : panels) {
    if (panel.kind == PanelKind::field && a.relax.vfield.empty()) {
      throw InvalidInput("--panel field: which field? Give --vfield FILE");
    }
    if (needs_partition(panel.kind)) check_arguments(a.relax);
    if (panel.caption && !Sheet::can_show(*panel.caption)) {
      throw InvalidInput("--panel: the caption '" + *panel.caption + "' is not in UTF-8");
    }
  }
  parse_view(a.relax.view);
  arrange(panels.size(), have_captions(panels), parse_size(a.relax.size), 1);
  const std::vector<std::filesystem::path> others = {a.relax.mesh, a.relax.vfield,
                                                     a.relax.seeds_file};
  check_target(a.output, others);
  return panels;
}

}  // namespace

void add_render_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "render", "Draw a mesh, the regions of seeds, and what they are made of, as they are");
  const auto a = std::make_shared<RenderArguments>();
  add_mesh_argument(*command, a->relax);
  command->add_option("-o,--output", a->output, "PNG file")->type_name("FILE")->required();
  command
      ->add_option("--panel", a->panels,
                   "What to show, surface|mesh|regions|trees|ground-truth|remesh|\n"
                   "field; several panels stand side by side. NAME=CAPTION puts text\n"
                   "below one")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_picture_options(*command, a->relax);
  add_seed_options(*command, a->relax);
  add_graph_options(*command, a->relax);
  add_remesh_options(*command, a->relax);
  add_thread_options(*command, a->relax);
  command->footer(
      "surface, mesh and field need no seeds. The ground is white where there are captions,\n"
      "transparent otherwise.");
  command->callback([a] {
    const std::vector<Panel> panels = check(*a);
    Renderer(*a, panels).render();
  });
}

}  // namespace geolloyd
