#pragma once

#include <span>

#include "core/mesh/mesh_edges.h"
#include "core/text/file_writer.h"

namespace geolloyd {

/// CSV with a line per place where something is wrong with a mesh: its kind, the two triangles, and
/// where, for viewers: the middle of what the boxes of both have in common. All are of the kind
/// self_intersection.
void write_issues(const Mesh& mesh, std::span<const TrianglePair> self_intersections,
                  FileWriter& out);

}  // namespace geolloyd
