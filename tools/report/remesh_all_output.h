#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "tools/files/json.h"
#include "tools/run/remesh_run.h"

namespace geolloyd {

/// A mesh of many, and the file that its remesh is to be.
struct RemeshTask {
  std::filesystem::path input;
  std::filesystem::path output;
};

/// What became of the meshes of `remesh-all`, kept in remesh-all.csv and remesh-all.json while the
/// work goes on. Several threads may add to it at once.
class RemeshRecord {
 public:
  static constexpr const char* csv_name = "remesh-all.csv";
  static constexpr const char* json_name = "remesh-all.json";

  /// `tasks` must live on.
  RemeshRecord(const std::vector<RemeshTask>& tasks, std::filesystem::path folder, Json options);

  void add(std::size_t task, const RemeshedInput& done);
  /// Why there is no remesh, in one line.
  void add_failure(std::size_t task, std::string error, double seconds);

  /// Writes both files, if `now` or if they are older than some seconds.
  void save(bool now);

  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t failed() const { return failed_; }
  /// What remesh-all.json holds.
  [[nodiscard]] Json result() const;
  /// For people: what came of it, and each failure in a line.
  [[nodiscard]] std::string summary() const;
  /// Of all meshes, in their order, a line each.
  [[nodiscard]] std::string warnings() const;

 private:
  void add_row(std::size_t task, Json row);

  const std::vector<RemeshTask>& tasks_;
  std::filesystem::path folder_;
  Json options_;
  std::vector<Json> rows_;             // null: not done
  std::vector<std::string> warnings_;  // lines
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  std::mutex mutex_;
  Stopwatch watch_;
  double next_save_ = 0;  // seconds of watch_
};

}  // namespace geolloyd
