#pragma once

#include <filesystem>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "tools/files/output_folder.h"
#include "tools/render/picture.h"
#include "tools/run/stages.h"

namespace geolloyd {

/// Makes the folder that --frames names. Throws Error where it cannot be written or holds frames of
/// another run: these are not ours to remove, and must not be taken for frames of this one. (A run
/// that is resumed goes on among its own.)
[[nodiscard]] MadeFolders prepare_frames(const std::filesystem::path& folder, bool is_resumed);

/// Draws the regions at the start of each step into a file: 000-greedy.png, 001-greedy.png ...,
/// 012-precise.png. A region has one colour in all of them.
class Frames {
 public:
  /// `run` must live on.
  Frames(std::filesystem::path folder, const PictureLook& look, const PreparedInput& run,
         Runtime& runtime);

  void draw(const StepStart& step) const;

 private:
  std::filesystem::path folder_;
  const MeshGraph& mesh_graph_;
  Executor& executor_;
  Picture picture_;
  std::vector<Colour> colours_;
};

}  // namespace geolloyd
