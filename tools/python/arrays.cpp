#include "tools/python/arrays.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(VertexId));

std::size_t rows(const py::array& array) {
  return static_cast<std::size_t>(array.shape(0));
}

std::uint32_t id_of(const char* name, std::size_t index, std::int64_t id) {
  if (id >= 0 && id < std::int64_t{no_id}) return static_cast<std::uint32_t>(id);
  throw InvalidInput(std::string(name) + "[" + std::to_string(index) + "]: " + std::to_string(id) +
                     ": ids count from 0");
}

}  // namespace

Mesh mesh_of(const NumberArray& vertices, const IdArray& faces) {
  Mesh mesh;
  mesh.positions = points_of(vertices);
  mesh.triangles.resize(rows(faces));
  const std::int64_t* id = faces.data();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (VertexId& corner : mesh.triangles[t]) {
      const bool is_there = *id >= 0 && static_cast<std::uint64_t>(*id) < mesh.vertex_count();
      if (!is_there) {
        throw InvalidInput("mesh: triangle " + std::to_string(t) + ": names vertex " +
                           std::to_string(*id) + ", but the mesh has " +
                           std::to_string(mesh.vertex_count()));
      }
      corner = static_cast<VertexId>(*id++);
    }
  }
  return mesh;
}

std::vector<Vec3> points_of(const NumberArray& points) {
  std::vector<Vec3> result(rows(points));
  if (!result.empty()) {
    std::memcpy(static_cast<void*>(result.data()), points.data(), result.size() * sizeof(Vec3));
  }
  return result;
}

std::vector<double> numbers_of(const std::optional<NumberArray>& numbers) {
  if (!numbers) return {};
  return {numbers->data(), numbers->data() + numbers->size()};
}

std::vector<std::uint32_t> ids_of(const char* name, const std::optional<IdArray>& ids) {
  std::vector<std::uint32_t> result;
  if (!ids) return result;
  result.reserve(rows(*ids));
  for (std::size_t i = 0; i < rows(*ids); ++i) result.push_back(id_of(name, i, ids->data()[i]));
  return result;
}

std::vector<std::array<VertexId, 2>> pairs_of(const char* name,
                                              const std::optional<IdArray>& pairs) {
  std::vector<std::array<VertexId, 2>> result;
  if (!pairs) return result;
  result.reserve(rows(*pairs));
  for (std::size_t i = 0; i < rows(*pairs); ++i) {
    const std::int64_t* const pair = pairs->data() + 2 * i;
    result.push_back({id_of(name, i, pair[0]), id_of(name, i, pair[1])});
  }
  return result;
}

std::vector<TangentSpace> spaces_of(const std::optional<NumberArray>& rows_given) {
  std::vector<TangentSpace> spaces;
  if (!rows_given) return spaces;
  spaces.reserve(rows(*rows_given));
  for (std::size_t v = 0; v < rows(*rows_given); ++v) {
    const double* const row = rows_given->data() + 8 * v;
    spaces.push_back(
        {{row[2], row[3], row[4]}, {row[5], row[6], row[7]}, std::abs(row[0]), std::abs(row[1])});
  }
  return spaces;
}

NumberArray rows_of(const std::vector<TangentSpace>& spaces) {
  NumberArray result({static_cast<py::ssize_t>(spaces.size()), py::ssize_t{8}});
  double* out = result.mutable_data();
  for (const TangentSpace& space : spaces) {
    *out++ = space.tangent_magnitude;
    *out++ = space.bitangent_magnitude;
    for (const double x : space.tangent) *out++ = x;
    for (const double x : space.bitangent) *out++ = x;
  }
  return result;
}

std::pair<py::array, py::array> arrays_of(Mesh&& mesh) {
  const auto vertices = static_cast<py::ssize_t>(mesh.vertex_count());
  const auto triangles = static_cast<py::ssize_t>(mesh.triangle_count());
  return {array_of<double>(std::move(mesh.positions), {vertices, 3}),
          array_of<std::int32_t>(std::move(mesh.triangles), {triangles, 3})};
}

std::pair<py::array, py::array> arrays_of(const std::vector<SurfacePoint>& places) {
  const auto size = static_cast<py::ssize_t>(places.size());
  std::vector<TriangleId> triangles;
  std::vector<std::array<double, 3>> barycentric;
  triangles.reserve(places.size());
  barycentric.reserve(places.size());
  for (const SurfacePoint& place : places) {
    triangles.push_back(place.triangle);
    barycentric.push_back(place.barycentric);
  }
  return {id_array(std::move(triangles)), array_of<double>(std::move(barycentric), {size, 3})};
}

}  // namespace geolloyd
