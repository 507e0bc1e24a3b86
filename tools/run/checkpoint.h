#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "tools/files/flat_map.h"

namespace geolloyd {

/// Where a relaxation stands between two steps, and how many seconds it took to come there.
struct Checkpoint {
  RelaxationState state;
  double seconds = 0;
};

/// The checkpoint of the run whose results go to `folder`.
std::filesystem::path checkpoint_path(const std::filesystem::path& folder);

/// The file from which a relaxation goes on that was interrupted or killed. Holds a checksum, and
/// says of which graph, first seeds and options it is.
class CheckpointFile {
 public:
  /// Of the relaxation of `graph`, which must live on, from `first_seeds`. Of the options, those
  /// that have a say in the course are the checkpoint's own; limits may change.
  CheckpointFile(std::filesystem::path path, const Graph& graph, std::vector<NodeId> first_seeds,
                 const RelaxationOptions& options);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Replaces it as a whole. Throws IoError.
  void write(const Checkpoint& checkpoint);
  /// Throws InvalidInput where it is damaged, of another version, or of another relaxation.
  Checkpoint read();

 private:
  std::uint64_t graph_digest();
  FlatMap describe_course();
  void check_course(const FlatMap& content);

  std::filesystem::path path_;
  const Graph& graph_;
  std::vector<NodeId> first_seeds_;
  RelaxationOptions options_;
  std::optional<std::uint64_t> graph_digest_;  // once it is needed
};

}  // namespace geolloyd
