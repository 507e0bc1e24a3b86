#include "core/formats/gltf/gltf_scene.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>

#include "core/mesh/mesh.h"

namespace geolloyd {
namespace {

using nlohmann::json;

// As many numbers as the key of a node has to have, or false where it is not there.
template <std::size_t size>
bool read_numbers(const GltfDocument& document, const json& node, const char* key,
                  const std::string& what, std::array<double, size>& numbers) {
  const auto found = node.find(key);
  if (found == node.end()) return false;
  const bool fits = found->is_array() && found->size() == size;
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_number = fits && (*found)[i].is_number();
    if (is_number) numbers[i] = (*found)[i].get<double>();
    if (is_number && is_usable(numbers[i])) continue;
    document.fail(what, "expected " + std::to_string(size) + " numbers as '" + key + "'");
  }
  return true;
}

// Of the node within its parent.
Eigen::Matrix4d transform_of(const GltfDocument& document, const json& node,
                             const std::string& what) {
  std::array<double, 16> matrix{};
  if (read_numbers(document, node, "matrix", what, matrix)) {
    return Eigen::Map<const Eigen::Matrix4d>(matrix.data());
  }
  std::array<double, 3> translation{};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};
  (void)read_numbers(document, node, "translation", what, translation);
  (void)read_numbers(document, node, "rotation", what, rotation);
  (void)read_numbers(document, node, "scale", what, scale);
  Eigen::Quaterniond quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
  const double length = quaternion.norm();
  if (!(length > 0)) document.fail(what, "the rotation is no quaternion");
  quaternion.coeffs() /= length;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() =
      quaternion.toRotationMatrix() * Eigen::Vector3d(scale.data()).asDiagonal();
  transform.topRightCorner<3, 1>() = Eigen::Vector3d(translation.data());
  return transform;
}

class Walk {
 public:
  explicit Walk(const GltfDocument& document)
      : document_(document), is_known_(document.count("nodes"), 0) {}

  std::vector<GltfInstance> run() {
    if (document_.count("nodes") == 0) return all_meshes();
    for (const std::size_t root : roots()) visit_tree(root);
    return std::move(instances_);
  }

 private:
  struct Place {
    std::size_t node;
    Eigen::Matrix4d parent;
  };

  [[nodiscard]] std::vector<GltfInstance> all_meshes() const {
    std::vector<GltfInstance> instances(document_.count("meshes"));
    for (std::size_t i = 0; i < instances.size(); ++i) instances[i].mesh = i;
    return instances;
  }

  // Ids that an object lists under a key.
  [[nodiscard]] std::vector<std::size_t> list(const json& object, const char* key,
                                              const std::string& what) const {
    std::vector<std::size_t> ids;
    const auto found = object.find(key);
    if (found == object.end()) return ids;
    for (const json& id : *found) {
      if (!id.is_number_unsigned())
        document_.fail(what, std::string("expected ids as '") + key + "'");
      ids.push_back(id.get<std::size_t>());
    }
    return ids;
  }

  [[nodiscard]] std::vector<std::size_t> roots() const {
    if (document_.count("scenes") > 0) {
      const std::size_t scene = document_.number(document_.root(), "scene", "scene", 0);
      return list(document_.at("scenes", scene), "nodes", part_name("scenes", scene));
    }
    std::vector<std::uint8_t> is_child(is_known_.size(), 0);
    for (std::size_t node = 0; node < is_child.size(); ++node) {
      const std::string what = part_name("nodes", node);
      for (const std::size_t child : list(document_.at("nodes", node), "children", what)) {
        if (child < is_child.size()) is_child[child] = 1;
      }
    }
    std::vector<std::size_t> roots;
    for (std::size_t node = 0; node < is_child.size(); ++node) {
      if (is_child[node] == 0) roots.push_back(node);
    }
    return roots;
  }

  // Without recursion: trees may be as deep as the file is long.
  void visit_tree(std::size_t root) {
    std::vector<Place> open{{root, Eigen::Matrix4d::Identity()}};
    while (!open.empty()) {
      const Place place = open.back();
      open.pop_back();
      const std::string what = part_name("nodes", place.node);
      const json& node = document_.at("nodes", place.node);
      if (is_known_[place.node] != 0) document_.fail(what, "is met twice: nodes are no tree");
      is_known_[place.node] = 1;
      const Eigen::Matrix4d to_world = place.parent * transform_of(document_, node, what);
      if (node.contains("mesh")) {
        const std::size_t mesh = document_.number(node, "mesh", what);
        const bool is_posed = node.contains("skin");
        instances_.push_back({mesh, is_posed ? Eigen::Matrix4d::Identity() : to_world});
      }
      std::vector<std::size_t> children = list(node, "children", what);
      for (; !children.empty(); children.pop_back()) open.push_back({children.back(), to_world});
    }
  }

  const GltfDocument& document_;
  std::vector<std::uint8_t> is_known_;
  std::vector<GltfInstance> instances_;
};

}  // namespace

std::vector<GltfInstance> find_gltf_instances(const GltfDocument& document) {
  return Walk(document).run();
}

}  // namespace geolloyd
