#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_edges.h"
#include "core/regions/tessellation.h"
#include "geolloyd/errors.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/commands/commands.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/files/output_folder.h"
#include "tools/render/labels.h"
#include "tools/render/painters.h"
#include "tools/render/panel.h"
#include "tools/render/picture.h"
#include "tools/render/sheet.h"
#include "tools/run/dual.h"
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"
#include "tools/system/memory_limit.h"
#include "tools/view/layers.h"
#include "tools/view/page.h"
#include "tools/view/page_contents.h"

namespace geolloyd {
namespace {

struct RenderArguments {
  RunRequest start;
  ThreadArguments threads;
  EngineArguments engine;  // its frontier
  DualRequest dual;
  PictureLook picture;
  std::filesystem::path view_of;  // another mesh, for its camera; empty: none
  std::filesystem::path output;
  std::vector<std::string> panels;
  bool has_own_colours = true;
};

bool is_page(const std::filesystem::path& output) {
  return output.extension() == ".html";
}

bool have_captions(const std::vector<Panel>& panels) {
  return std::any_of(panels.begin(), panels.end(),
                     [&](const Panel& panel) { return !caption_of(panel, panels.size()).empty(); });
}

bool shows_colours(const std::vector<Panel>& panels) {
  return std::any_of(panels.begin(), panels.end(), [](const Panel& panel) {
    return panel.kind == PanelKind::surface || panel.kind == PanelKind::mesh;
  });
}

class Renderer {
 public:
  Renderer(const RenderArguments& arguments, const std::vector<Panel>& panels,
           const Console& console)
      : arguments_(arguments),
        panels_(panels),
        scheduler_(make_scheduler(arguments.threads)),
        threads_(scheduler_, arguments.engine.frontier),
        progress_(console) {}

  void render() {
    const PictureLook& look = arguments_.picture;
    if (any(needs_partition)) {
      find_partition();
    } else {
      read_mesh_alone();
    }
    own_colours_ = colours_of(start_.input.loaded.properties);
    start_.input.loaded.properties = {};
    progress_.stage("drawing " + arguments_.output.string());
    const Mesh other = mesh_of_view();
    const Mesh& mesh = start_.input.mesh();
    const Picture picture(mesh, arguments_.view_of.empty() ? mesh : other, look.view, look.size,
                          panels_.size(), have_captions(panels_), scheduler_);
    std::vector<PanelImage> images;
    for (const Panel& panel : panels_) {
      images.push_back({draw(panel.kind, picture.scene()), caption_of(panel, panels_.size())});
    }
    picture.write(arguments_.output, images);
  }

  /// What the panels name, with the regions and all that belongs to them.
  void write_page() {
    const auto shows = [&](PanelKind wanted) {
      return any([&](PanelKind kind) { return kind == wanted; });
    };
    if (any(needs_partition)) {
      find_partition();
    } else {
      read_mesh_alone();
    }
    Bundle bundle = bundle_of(start_.input);
    if (any(needs_partition)) {
      add_regions(bundle, start_.mesh_graph, found_.partition, start_.seeds);
      add_region_figures(bundle, summarise_regions(start_.mesh_graph.graph, found_.partition,
                                                   start_.seeds, found_.engine->region_scores()));
      add_trees(bundle, start_.mesh_graph, found_.partition);
    }
    if (shows(PanelKind::field)) add_field(bundle, asked_field());
    if (shows(PanelKind::ground_truth)) {
      add_truth(bundle, start_.mesh_graph,
                make_ground_truth(scheduler_, start_.input.mesh(), start_.mesh_graph,
                                  found_.partition, start_.seeds));
    }
    if (shows(PanelKind::dual)) add_remesh(bundle, dual().mesh);
    progress_.stage("writing " + arguments_.output.string());
    const std::string summary = geolloyd::write_page(arguments_.output, std::move(bundle));
    progress_.clear();
    fmt::print("{}", summary);
  }

 private:
  template <class Predicate>
  [[nodiscard]] bool any(Predicate&& predicate) const {
    return std::any_of(panels_.begin(), panels_.end(),
                       [&](const Panel& panel) { return predicate(panel.kind); });
  }

  void read_mesh_alone() {
    progress_.stage("reading " + arguments_.start.mesh.string());
    start_.input = load_input(arguments_.start.mesh, scheduler_,
                              {arguments_.start.has_properties, arguments_.start.reading})
                       .input;
    const Mesh& mesh = start_.input.mesh();
    const PictureLook& look = arguments_.picture;
    WorkSize size = size_of(start_.input.loaded);
    size.samples = count_samples(mesh, look.view, look.size, scheduler_);
    size.has_field = !arguments_.start.graph.vfield.empty();
    size.has_cross_field = arguments_.start.graph.has_cross_field();
    progress_.announce_memory(arguments_.start.mesh.string(), bytes_to_draw(size));
  }

  [[nodiscard]] Mesh mesh_of_view() {
    if (arguments_.view_of.empty()) return {};
    progress_.stage("reading " + arguments_.view_of.string());
    return read(arguments_.view_of).mesh;
  }

  void find_partition() {
    RunWork work;
    work.picture = arguments_.picture;
    work.has_dual = any([](PanelKind kind) { return kind == PanelKind::dual; });
    work.has_ground_truth = any([](PanelKind kind) { return kind == PanelKind::ground_truth; }) ||
                            arguments_.dual.vertices == DualVertices::centroids;
    start_ = prepare(arguments_.start, work, threads_, progress_);
    const Graph& graph = start_.mesh_graph.graph;
    found_ = partition_seeds(graph, start_.seeds, threads_);
    colours_ = colours_of_regions(graph, found_.partition, start_.seeds.size());
  }

  Pixels draw(PanelKind kind, const Scene& scene) {
    if (kind != PanelKind::dual) return to_pixels(scene, paint(kind, scene), scheduler_);
    const MadeDual made = dual();
    const Scene other = make_scene(made.mesh, scene.camera, Shading::flat, scheduler_);
    const QuadPairs pairs = made.quads.value_or(QuadPairs{});
    return to_pixels(other, paint_mesh(other, scheduler_, {}, pairs.is_inner), scheduler_);
  }

  MadeDual dual() {
    return make_dual(start_, start_.seeds, found_.partition, *found_.engine, arguments_.dual,
                     scheduler_);
  }

  Canvas paint(PanelKind kind, const Scene& scene) {
    const PartitionView view{start_.mesh_graph, found_.partition, start_.seeds, colours_};
    switch (kind) {
      case PanelKind::surface:
        return paint_surface(scene, scheduler_, own_colours_);
      case PanelKind::mesh:
        return paint_mesh(scene, scheduler_, own_colours_);
      case PanelKind::regions:
        return paint_regions(view, scene, scheduler_);
      case PanelKind::trees:
        return paint_trees(view, scene, scheduler_);
      case PanelKind::ground_truth: {
        const GroundTruth truth = make_ground_truth(
            scheduler_, start_.input.mesh(), start_.mesh_graph, found_.partition, start_.seeds);
        return paint_ground_truth(view, truth.region, truth.surface_centroid, scene, scheduler_);
      }
      case PanelKind::field:
        return paint_field(asked_field(), scene, scheduler_);
      case PanelKind::dual:
        break;  // has a scene of its own
    }
    return {};
  }

  std::vector<TangentSpace> asked_field() {
    const Mesh& mesh = start_.input.mesh();
    return find_field(arguments_.start.graph, mesh, find_edges(mesh, scheduler_), scheduler_);
  }

  const RenderArguments& arguments_;
  const std::vector<Panel>& panels_;
  Scheduler scheduler_;
  Threads threads_;  // the same
  ProgressLine progress_;
  PreparedInput start_;  // the input alone where no panel needs more
  EnginePartition found_;
  std::vector<Colour> colours_;  // of regions
  SurfaceColours own_colours_;
};

// What can be found wrong without the mesh is, before the work.
std::vector<Panel> check(const RenderArguments& a) {
  std::vector<Panel> panels;
  for (const std::string& text : a.panels) panels.push_back(parse_panel(text));
  const bool has_seeds = a.start.seeds.count > 0 || !a.start.seed_file.path.empty();
  if (panels.empty()) {
    panels.push_back({has_seeds ? PanelKind::regions : PanelKind::surface, std::nullopt});
  }
  for (const Panel& panel : panels) {
    if (panel.kind == PanelKind::field && a.start.graph.vfield.empty()) {
      throw InvalidInput("--panel field: which field? Give --vfield FILE, or --vfield curvature");
    }
    if (needs_partition(panel.kind)) check_seeds(a.start.seeds, a.start.seed_file);
    if (panel.caption && !Sheet::can_show(*panel.caption)) {
      throw InvalidInput("--panel: the caption '" + *panel.caption + "' is not in UTF-8");
    }
  }
  if (is_page(a.output)) {
    if (!a.view_of.empty()) {
      throw InvalidInput("--view-of: a page has a camera that its user turns: leave it out");
    }
    check_viewer();
  } else {
    arrange(panels.size(), have_captions(panels), a.picture.size, 1);
  }
  std::vector<std::filesystem::path> inputs = a.start.files();
  inputs.push_back(a.view_of);
  check_target(a.output, inputs);
  return panels;
}

}  // namespace

void add_render_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "render", "Draw a mesh, regions of seeds, shortest paths, a tangent field or a dual");
  const auto a = std::make_shared<RenderArguments>();
  add_mesh_argument(*command, a->start.mesh);
  command
      ->add_option("-o,--output", a->output,
                   "PNG file; or NAME.html, a page for a browser with all\n"
                   "that the panels name")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--panel", a->panels,
                   "Content of a panel: surface|mesh|regions|trees|ground-truth|dual|\n"
                   "field. Several panels stand side by side. NAME=CAPTION puts text\n"
                   "below a panel")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_flag("!--drop", a->has_own_colours,
                    "Draw surface and mesh without the mesh's own colours");
  add_picture_options(*command, a->picture);
  command
      ->add_option("--view-of", a->view_of,
                   "Another mesh, by whose camera this one is seen: that before the\n"
                   "remesh, for two pictures that can be compared")
      ->type_name("MESH")
      ->group("Pictures");
  add_seed_options(*command, a->start.seeds, a->start.seed_file);
  add_graph_options(*command, a->start.graph);
  add_dual_options(*command, a->dual.manifold, a->dual.vertices, a->dual.quads);
  add_frontier_option(*command, a->engine);
  add_thread_options(*command, a->threads);
  add_reading_options(*command, a->start.reading);
  command->footer(
      "surface, mesh and field need no seeds. Seeds are not relaxed. The background is\n"
      "transparent; with captions it is white.");
  command->callback([a, &console] {
    const std::vector<Panel> panels = check(*a);
    a->start.has_properties = a->has_own_colours && shows_colours(panels);
    Renderer renderer(*a, panels, console);
    if (is_page(a->output)) {
      renderer.write_page();
    } else {
      renderer.render();
    }
  });
}

}  // namespace geolloyd
