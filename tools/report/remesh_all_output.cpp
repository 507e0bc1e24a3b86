#include "tools/report/remesh_all_output.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/files/csv.h"
#include "tools/files/file_group.h"
#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"
#include "tools/words/warnings_text.h"

namespace geolloyd {
namespace {

std::string joined(const std::vector<RemeshWarning>& warnings) {
  std::string text;
  for (const RemeshWarning& warning : warnings) {
    text += (text.empty() ? "" : "; ") + warning.text;
  }
  return text;
}

// Of a mesh that has no remesh all figures are null.
Json row_of(const RemeshTask& task, const RemeshedInput* done, double seconds) {
  Json row = {{"input", task.input.string()}, {"output", nullptr}};
  for (const char* key : {"vertices", "triangles", "remesh_vertices", "remesh_triangles",
                          "has_input_topology", "mean_quality", "valence_6_percent",
                          "mean_distance_percent", "largest_distance_percent", "fingerprint"}) {
    row[key] = nullptr;
  }
  row["seconds"] = seconds;
  row["warnings"] = nullptr;
  row["error"] = nullptr;
  if (done == nullptr) return row;
  const Remesh& remesh = done->result.made.remesh;
  const RemeshFigures& figures = done->result.figures;
  const MeshFacts& facts = done->loaded.input.facts;
  row["output"] = task.output.string();
  row["vertices"] = facts.vertices;
  row["triangles"] = facts.triangles;
  row["remesh_vertices"] = remesh.mesh.vertex_count();
  row["remesh_triangles"] = remesh.mesh.triangle_count();
  row["has_input_topology"] = remesh.has_input_topology();
  row["mean_quality"] = figures.quality.mean_quality;
  row["valence_6_percent"] = 100 * figures.quality.share_valence_6;
  if (figures.distance) {
    row["mean_distance_percent"] = 100 * figures.distance->mean / facts.bounding_diagonal;
    row["largest_distance_percent"] = 100 * figures.distance->largest / facts.bounding_diagonal;
  }
  row["fingerprint"] = fingerprint_text(remesh.fingerprint);
  if (!remesh.warnings.empty()) row["warnings"] = joined(remesh.warnings);
  return row;
}

}  // namespace

RemeshRecord::RemeshRecord(const std::vector<RemeshTask>& tasks, std::filesystem::path folder,
                           Json options)
    : tasks_(tasks),
      folder_(std::move(folder)),
      options_(std::move(options)),
      rows_(tasks.size()),
      warnings_(tasks.size()) {}

void RemeshRecord::add(std::size_t task, const RemeshedInput& done) {
  add_row(task, row_of(tasks_[task], &done, done.result.total_seconds));
  const std::lock_guard lock(mutex_);
  warnings_[task] =
      lines_of_warnings(done.result.made.remesh.warnings, tasks_[task].input.string());
}

std::string RemeshRecord::warnings() const {
  std::string lines;
  for (const std::string& of_task : warnings_) lines += of_task;
  return lines;
}

void RemeshRecord::add_failure(std::size_t task, std::string error, double seconds) {
  Json row = row_of(tasks_[task], nullptr, seconds);
  row["error"] = std::move(error);
  add_row(task, std::move(row));
}

void RemeshRecord::add_row(std::size_t task, Json row) {
  const std::lock_guard lock(mutex_);
  ++done_;
  failed_ += row["error"].is_null() ? 0 : 1;
  rows_[task] = std::move(row);
}

Json RemeshRecord::result() const {
  Json result = {{"command", "remesh-all"},
                 {"program", program_name()},
                 {"machine", machine_part()},
                 {"options", options_},
                 {"interrupted", done_ < tasks_.size()},
                 {"meshes", tasks_.size()},
                 {"done", done_ - failed_},
                 {"failed", failed_},
                 {"seconds", watch_.seconds()}};
  Json rows = Json::array();
  for (const Json& row : rows_) {
    if (!row.is_null()) rows.push_back(row);
  }
  result["rows"] = std::move(rows);
  return result;
}

// The more there is to write, the less often: a twentieth of the time at most.
void RemeshRecord::save(bool now) {
  const std::lock_guard lock(mutex_);
  const double begin = watch_.seconds();
  if (!now && begin < next_save_) return;
  const Json all = result();
  FileGroup files(folder_, std::array{csv_name, json_name});
  files[0].text(csv_text(all["rows"]));
  files[1].text(json_text(all));
  files.commit();
  const double end = watch_.seconds();
  next_save_ = end + 1 + 20 * (end - begin);
}

std::string RemeshRecord::summary() const {
  std::string text = fmt::format(
      "{}: {} remeshed, {} failed{}; {:.2f} s\n", counted(tasks_.size(), "mesh", "meshes"),
      grouped(done_ - failed_), grouped(failed_),
      done_ < tasks_.size() ? fmt::format(", {} LEFT: INTERRUPTED", grouped(tasks_.size() - done_))
                            : "",
      watch_.seconds());
  for (const Json& row : rows_) {
    if (row.is_null() || row["error"].is_null()) continue;
    text += fmt::format("  {:<12}{}\n", "failed", row["error"].get<std::string>());
  }
  return text + fmt::format("  {:<12}{} {}\n", "written", (folder_ / csv_name).string(),
                            (folder_ / json_name).string());
}

}  // namespace geolloyd
