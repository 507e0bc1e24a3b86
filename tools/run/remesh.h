#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/course/remesh_course.h"
#include "geolloyd/remesh.h"
#include "tools/files/remesh_request.h"
#include "tools/render/view.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// Reads the mesh that is asked for, repairs it if that is wanted, and finds its edges. Throws
/// InvalidInput where it has no area.
LoadedInput load_surface(const RemeshRequest& request, Executor& executor, ProgressLine& progress);

/// The options, with what the files and labels say that are named. Throws InvalidInput where one
/// does not fit the mesh.
RemeshOptions read_options(const RemeshRequest& request, const LoadedInput& loaded,
                           Executor& executor);

/// Bytes, of the whole run, with a picture if one will be drawn.
std::uint64_t estimate_remesh_memory(const Input& input, const MeshEdges& edges,
                                     std::size_t vertices, const RemeshOptions& options,
                                     const std::optional<PictureLook>& picture, Executor& executor);

/// The course of a remesh of `loaded`. Stages and iterations are shown, an interrupt (interrupt.h)
/// ends the work, and `budget` is told estimate_remesh_memory(). What is referred to must live on.
RemeshCourse remesh_course(const LoadedInput& loaded, RemeshOptions options, Runtime& runtime,
                           ProgressLine& progress, std::function<void(std::uint64_t)> budget,
                           const std::optional<PictureLook>& picture = std::nullopt);

}  // namespace geolloyd
