#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "geolloyd/mesh.h"
#include "geolloyd/shapes.h"
#include "tools/python/arrays.h"
#include "tools/python/module.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

py::dict arrays_of(std::vector<Property>&& properties) {
  py::dict arrays;
  for (Property& property : properties) {
    std::visit(
        [&](auto& values) {
          using Number = typename std::decay_t<decltype(values)>::value_type;
          arrays[py::str(property.name)] = array_of<Number>(std::move(values));
        },
        property.values);
  }
  return arrays;
}

template <class Number>
bool take(const py::array& array, PropertyValues& values) {
  if (!py::isinstance<py::array_t<Number, py::array::c_style>>(array)) return false;
  const auto numbers = py::array_t<Number, py::array::c_style>(array);
  values = std::vector<Number>(numbers.data(), numbers.data() + numbers.size());
  return true;
}

std::vector<Property> properties_of(const py::dict& arrays) {
  std::vector<Property> properties;
  properties.reserve(arrays.size());
  for (const auto& [name, value] : arrays) {
    Property property;
    property.name = py::str(name).cast<std::string>();
    const auto array = py::cast<py::array>(value);
    PropertyValues& to = property.values;
    const bool is_taken = take<std::int8_t>(array, to) || take<std::uint8_t>(array, to) ||
                          take<std::int16_t>(array, to) || take<std::uint16_t>(array, to) ||
                          take<std::int32_t>(array, to) || take<std::uint32_t>(array, to) ||
                          take<float>(array, to) || take<double>(array, to);
    if (!is_taken) throw InvalidInput(property.name + ": numbers of a type that files do not have");
    properties.push_back(std::move(property));
  }
  return properties;
}

using Corners = std::vector<std::array<VertexId, 3>>;

py::object corners_of(Corners&& corners) {
  if (corners.empty()) return py::none();
  const auto rows = static_cast<py::ssize_t>(corners.size());
  return array_of<std::int32_t>(std::move(corners), {rows, 3});
}

py::tuple read_arrays(const std::filesystem::path& path, bool weld) {
  LoadedMesh loaded;
  {
    const py::gil_scoped_release working;
    ReadOptions options;
    options.properties = true;
    options.weld = weld;
    loaded = geolloyd::read(path, options);
  }
  auto [vertices, faces] = arrays_of(std::move(loaded.mesh));
  return py::make_tuple(vertices, faces, arrays_of(std::move(loaded.properties.of_vertices)),
                        arrays_of(std::move(loaded.properties.of_triangles)),
                        corners_of(std::move(loaded.properties.corner_values)));
}

void write_arrays(const std::filesystem::path& path, const NumberArray& vertices,
                  const IdArray& faces, const py::dict& of_vertices, const py::dict& of_triangles,
                  const std::optional<IdArray>& corner_values) {
  const Mesh mesh = mesh_of(vertices, faces);
  Properties properties{properties_of(of_vertices), properties_of(of_triangles), {}};
  if (corner_values) properties.corner_values = mesh_of(vertices, *corner_values).triangles;
  const py::gil_scoped_release working;
  geolloyd::write(path, mesh, properties);
}

py::tuple generate(const std::string& shape, std::size_t triangles, std::uint64_t random_seed) {
  const Shape make = choice_of("shape", shape_names, shape);
  Mesh mesh;
  {
    const py::gil_scoped_release working;
    mesh = make(triangles, random_seed);
  }
  auto [vertices, faces] = arrays_of(std::move(mesh));
  return py::make_tuple(vertices, faces);
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("has_mesh_name", &has_mesh_name, py::arg("path"));
  module.def("read", &read_arrays, py::arg("path"), py::arg("weld"));
  module.def("write", &write_arrays, py::arg("path"), py::arg("vertices"), py::arg("faces"),
             py::arg("of_vertices"), py::arg("of_triangles"), py::arg("corner_values"));
  module.def("generate", &generate, py::arg("shape"), py::arg("triangles"), py::arg("random_seed"));
}

}  // namespace geolloyd
