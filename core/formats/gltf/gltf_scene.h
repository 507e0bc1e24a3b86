#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/formats/gltf/gltf_document.h"

namespace geolloyd {

/// A mesh of a glTF file where a node puts it.
struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Matrix4d to_world = Eigen::Matrix4d::Identity();
};

/// Those of the default scene, or else of all nodes, in the order of a walk from the roots,
/// children in their order; all meshes as they are where there are no nodes. A mesh with a skin is
/// in its pose at rest. Throws InvalidInput where nodes are no tree.
std::vector<GltfInstance> find_gltf_instances(const GltfDocument& document);

}  // namespace geolloyd
