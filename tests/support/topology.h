#pragma once

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"

namespace geolloyd {

inline MeshTopology topology_of(const Mesh& mesh) {
  return find_topology(mesh, find_edges(mesh));
}

}  // namespace geolloyd
