#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geolloyd/choices.h"
#include "geolloyd/mesh.h"
#include "geolloyd/remesh.h"
#include "geolloyd/types.h"

namespace geolloyd {

namespace py = pybind11;

// Arrays in, copied while Python waits, and arrays out, which take the memory of vectors over. What
// comes in is whole and of these types: geolloyd/_arrays.py sees to that.

using NumberArray = py::array_t<double, py::array::c_style>;
using IdArray = py::array_t<std::int64_t, py::array::c_style>;

/// From n x 3 coordinates and m x 3 vertices. Throws InvalidInput where a triangle names a vertex
/// that is not there.
Mesh mesh_of(const NumberArray& vertices, const IdArray& faces);

std::vector<Vec3> points_of(const NumberArray& points);
std::vector<double> numbers_of(const std::optional<NumberArray>& numbers);
/// Throws InvalidInput, which begins with `name`, where one is no id.
std::vector<std::uint32_t> ids_of(const char* name, const std::optional<IdArray>& ids);
/// Rows of two ids.
std::vector<std::array<VertexId, 2>> pairs_of(const char* name,
                                              const std::optional<IdArray>& pairs);
/// Rows as in a .vfield file: two magnitudes, tangent, bitangent. None: no field.
std::vector<TangentSpace> spaces_of(const std::optional<NumberArray>& rows);
NumberArray rows_of(const std::vector<TangentSpace>& spaces);

/// An array of this shape over the values of a vector, which lives on behind it. `Item` is what
/// numpy sees of the vector's values: a number of the same size, or one of a few that fill it.
template <class Item, class Value>
py::array array_of(std::vector<Value>&& values, std::vector<py::ssize_t> shape) {
  auto* const kept = new std::vector<Value>(std::move(values));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<decltype(kept)>(vector); });
  return py::array_t<Item>(std::move(shape), reinterpret_cast<const Item*>(kept->data()), owner);
}

/// One number per value.
template <class Item, class Value>
py::array array_of(std::vector<Value>&& values) {
  static_assert(sizeof(Item) == sizeof(Value));
  const auto size = static_cast<py::ssize_t>(values.size());
  return array_of<Item>(std::move(values), {size});
}

/// Ids as int32: none is -1.
inline py::array id_array(std::vector<std::uint32_t>&& ids) {
  return array_of<std::int32_t>(std::move(ids));
}

/// n x 3 float64 and m x 3 int32.
std::pair<py::array, py::array> arrays_of(Mesh&& mesh);

/// Triangles (int32) and their corners' weights (n x 3 float64).
std::pair<py::array, py::array> arrays_of(const std::vector<SurfacePoint>& places);

}  // namespace geolloyd
