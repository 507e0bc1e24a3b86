#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "geolloyd/runtime.h"
#include "tools/run/remesh_run.h"
#include "tools/run/result.h"
#include "tools/run/stages.h"
#include "tools/view/bundle.h"

namespace geolloyd {

/// A bundle with a mesh and, if it has any, its own colours.
Bundle bundle_of(const Input& input);

/// How many frames a timeline has at most: of a longer course every second, third ... step is
/// shown.
inline constexpr std::size_t most_frames = 48;

/// What `relax` made: regions, trees, the field, the ground truth and the remesh, as far as there
/// are any, and the frames of its course. `course`: the seeds at the start of each of the last
/// steps.
Bundle relax_contents(const FieldSource& field, const PreparedInput& start, const Result& result,
                      std::span<const std::vector<NodeId>> course, Runtime& runtime);

/// The mesh before and after `remesh`.
Bundle remesh_contents(const RemeshedInput& done);

}  // namespace geolloyd
