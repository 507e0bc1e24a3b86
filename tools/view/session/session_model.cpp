#include "tools/view/session/session_model.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/bounding_box.h"
#include "core/course/remesh_course.h"
#include "core/regions/tessellation.h"
#include "geolloyd/errors.h"
#include "tools/report/report_parts.h"
#include "tools/run/dual.h"
#include "tools/run/remesh.h"
#include "tools/system/memory_limit.h"
#include "tools/view/layers.h"
#include "tools/view/session/command_lines.h"
#include "tools/view/session/saving.h"

namespace geolloyd {
namespace {

StepKind kind_of(Action action) {
  if (action == Action::greedy_step) return StepKind::greedy;
  return action == Action::microstep ? StepKind::micro : StepKind::macro;
}

ProgressCallback observer_of(const std::function<bool()>& keep_going) {
  return [&keep_going](const Progress&) { return keep_going(); };
}

Json triple(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Json facts_of(const Input& input) {
  const BoundingBox box = bounding_box(input.mesh().positions);
  return {{"name", input.file.filename().string()},
          {"vertices", input.mesh().vertex_count()},
          {"triangles", input.mesh().triangle_count()},
          {"min", triple(box.low)},
          {"max", triple(box.high)}};
}

}  // namespace

SessionModel::SessionModel(LoadedInput loaded, const SessionOptions& options,
                           std::filesystem::path output, Runtime& runtime)
    : tessellation_(std::move(loaded), options, runtime),
      output_(std::move(output)),
      field_file_(options.graph.field_file()),
      runtime_(runtime),
      colours_(colours_of(tessellation_.start().input.loaded.properties)),
      placement_(placement_of(tessellation_.start().input.mesh())),
      mesh_facts_(facts_of(tessellation_.start().input)) {
  seeds_changed();
}

void SessionModel::perform(const SessionCommand& command, const std::function<bool()>& keep_going) {
  message_ = nullptr;
  ++revision_;
  switch (command.action) {
    case Action::set:
      tessellation_.set(changed(tessellation_.options(), command.changes, field_file_));
      region_colours_.clear();
      break;
    case Action::choose_seeds:
      tessellation_.choose_seeds();
      region_colours_.clear();
      break;
    case Action::add_seed:
      tessellation_.add_seed(command.id);
      break;
    case Action::move_seed:
      tessellation_.move_seed(command.region, command.id);
      break;
    case Action::remove_seed:
      tessellation_.remove_seed(command.region);
      break;
    case Action::reset:
      tessellation_.reset();
      break;
    case Action::greedy_step:
    case Action::microstep:
    case Action::macrostep:
      tessellation_.step(kind_of(command.action), observer_of(keep_going));
      break;
    case Action::truth:
      make_truth();
      return;
    case Action::dual:
      make_dual();
      return;
    case Action::remesh:
      make_remesh(command.vertices, keep_going);
      return;
    case Action::save:
      save(command.what);
      return;
    case Action::run:
    case Action::pause:
    case Action::stop:
      return;
  }
  seeds_changed();
}

bool SessionModel::take_step(const std::function<bool()>& keep_going) {
  const bool was_taken = tessellation_.step(StepKind::any, observer_of(keep_going));
  if (was_taken) seeds_changed();
  return was_taken;
}

// Everything that was found for the seeds as they were goes.
void SessionModel::seeds_changed() {
  truth_.reset();
  dual_.reset();
  layers_.erase("truth");
  layers_.erase("dual");
  if (tessellation_.field().empty()) {
    layers_.erase("field");
  } else if (layers_.count("field") == 0) {
    touch("field");
  }
  touch("regions");
  touch("trees");
}

// A region keeps its colour while seeds move, so that one can follow it.
const std::vector<Colour>& SessionModel::region_colours() {
  const std::size_t regions = tessellation_.seeds().size();
  if (region_colours_.size() != regions) {
    region_colours_ = colours_of_regions(tessellation_.start().mesh_graph.graph,
                                         tessellation_.partition(), regions);
  }
  return region_colours_;
}

void SessionModel::make_truth() {
  const PreparedInput& start = tessellation_.start();
  truth_ = make_ground_truth(runtime_.executor(), start.input.mesh(), start.mesh_graph,
                             tessellation_.partition(), tessellation_.seeds());
  touch("truth");
}

void SessionModel::make_dual() {
  dual_ = dual_of(tessellation_, runtime_.executor());
  touch("dual");
}

// Of the field as far as it has magnitudes, which is what a remesh follows.
std::filesystem::path SessionModel::remesh_field() const {
  const GraphPlan& graph = tessellation_.options().graph;
  return graph.has_cross_field() ? std::filesystem::path() : graph.vfield;
}

void SessionModel::make_remesh(std::size_t vertices, const std::function<bool()>& keep_going) {
  const Input& input = tessellation_.start().input;
  if (!(input.facts.area > 0)) throw InvalidInput("remesh: no triangle has an area");
  SessionRemesh next;
  next.vertices = vertices;
  next.field = remesh_field();
  RemeshOptions options;
  options.vertex_count = vertices;
  if (!next.field.empty()) options.field = tessellation_.field();
  RemeshCourse course{input.mesh(), tessellation_.edges(), std::move(options), runtime_};
  course.hooks.keep_going = keep_going;
  course.hooks.budget = [&](std::uint64_t bytes) { require_memory(input.file.string(), bytes); };
  course.bytes = [&](std::size_t count, const RemeshOptions& asked) {
    return estimate_remesh_memory(input, tessellation_.edges(), count, asked, {},
                                  runtime_.executor());
  };
  std::optional<SessionRemesh> before = std::exchange(remesh_, std::move(next));
  course.options.progress = [&](const RemeshProgress& progress) {
    remesh_->progress = progress;
    remesh_->progress.place = nullptr;
    remesh_->sites.clear();
    for (std::size_t s = 0; s < progress.sites; ++s) remesh_->sites.push_back(progress.place(s));
    touch("sites");
    return true;
  };
  try {
    remesh_->made = run(std::move(course)).remesh;
  } catch (...) {
    layers_.erase("sites");
    remesh_ = std::move(before);
    throw;
  }
  layers_.erase("sites");
  touch("remesh");
}

void SessionModel::save(Saving what) {
  if (output_.empty()) {
    throw InvalidInput("save: no folder to save into: start geolloyd view with --output FOLDER");
  }
  const std::string written = save_into(output_, what, tessellation_, remesh_, runtime_);
  set_message("done", "written: " + written);
}

void SessionModel::set_message(const std::string& kind, const std::string& text) {
  ++revision_;
  message_ = {{"kind", kind}, {"text", text}};
}

Json SessionModel::remesh_part() const {
  if (!remesh_) return nullptr;
  const SessionRemesh& r = *remesh_;
  Json part = {{"vertices", r.made ? r.made->mesh.vertex_count() : r.vertices},
               {"sites", r.progress.sites},
               {"iteration", r.progress.iteration},
               {"energy_ratio", number_or_null(r.progress.energy_ratio)},
               {"fingerprint", nullptr},
               {"command_line",
                remesh_command_line(tessellation_.start().input, r.vertices, r.field, output_)}};
  if (r.made && !r.made->interrupted) part["fingerprint"] = fingerprint_text(r.made->fingerprint);
  return part;
}

Json SessionModel::state(const Json& task, bool is_running) {
  SteppedTessellation& t = tessellation_;
  const double energy = t.energy();
  Json energies = Json::array();
  for (const Step& step : t.steps()) energies.push_back(step.energy);
  if (!t.is_within_step()) energies.push_back(energy);
  const std::string phase = t.is_done() ? "done" : name_of(phase_names, t.phase());
  Json fingerprint;
  if (!is_running && task.is_null() && !t.is_within_step()) {
    fingerprint = fingerprint_text(t.result().fingerprint);
  }
  return {{"revision", revision_},
          {"mesh", mesh_facts_},
          {"options", options_part(t.options())},
          {"choices", choices_part(field_file_)},
          {"task", task},
          {"running", is_running},
          {"phase", phase},
          {"step", t.steps().size()},
          {"seeds", t.seeds().size()},
          {"moving", t.moved()},
          {"energy", energy},
          {"initial_energy", energies.empty() ? Json(energy) : energies.front()},
          {"energies", energies},
          {"layers", layers_},
          {"command_line", relax_command_line(t, output_)},
          {"fingerprint", fingerprint},
          {"remesh", remesh_part()},
          {"output", output_.empty() ? Json() : Json(output_.string())},
          {"message", message_}};
}

std::string SessionModel::bundle(std::string_view name) {
  const PreparedInput& start = tessellation_.start();
  const MeshGraph& mesh_graph = start.mesh_graph;
  Bundle bundle;
  bundle.title = start.input.file.filename().string();
  bundle.placement = placement_;
  const auto is = [&](const char* layer) { return name == layer && layers_.count(layer) != 0; };
  if (name == "mesh") {
    add_mesh(bundle, start.input.mesh(), colours_);
  } else if (is("regions")) {
    add_regions(bundle, mesh_graph, tessellation_.partition(), tessellation_.seeds(),
                region_colours());
    add_region_figures(bundle, tessellation_.summaries());
  } else if (is("trees")) {
    add_trees(bundle, mesh_graph, tessellation_.partition());
  } else if (is("field")) {
    add_field(bundle, tessellation_.field());
  } else if (is("truth")) {
    add_truth(bundle, mesh_graph, *truth_);
  } else if (is("dual")) {
    add_remesh(bundle, dual_->mesh);
  } else if (is("remesh")) {
    add_remesh(bundle, remesh_->made->mesh);
  } else if (name == "sites" && remesh_) {  // also for who asks when they have just come to rest
    bundle.add_places("sites", remesh_->sites);
  } else {
    throw InvalidInput("no such layer now: give mesh, or one that the state names");
  }
  return encode(bundle);
}

}  // namespace geolloyd
