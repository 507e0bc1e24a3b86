#pragma once

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/repair.h"

namespace geolloyd {

/// `mesh` and options are valid.
RepairedMesh make_repaired_mesh(const Mesh& mesh, const RepairOptions& options,
                                Executor& executor = sequential());

}  // namespace geolloyd
