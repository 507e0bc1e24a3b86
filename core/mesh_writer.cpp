#include <charconv>
#include <limits>

#include "core/errors.h"
#include "core/file_io.h"
#include "core/mesh_readers.h"

namespace geolloyd {
namespace {

// Gathers small pieces into large writes.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path) : path_(path), file_(path) {}

  void text(std::string_view text) {
    std::memcpy(room(text.size()), text.data(), text.size());
    used_ += text.size();
  }

  // The shortest text that reads back as the same number.
  template <class Number>
  void number(Number number) {
    constexpr std::size_t longest = 32;
    char* const begin = room(longest);
    used_ += static_cast<std::size_t>(std::to_chars(begin, begin + longest, number).ptr - begin);
  }

  // Little endian.
  template <class Number>
  void raw(Number number) {
    char* const begin = room(sizeof(Number));
    std::memcpy(begin, &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) {
      std::reverse(begin, begin + sizeof(Number));
    }
    used_ += sizeof(Number);
  }

  void raw(const Vec3& position) {
    for (const double coordinate : position) {
      if (!(std::abs(coordinate) <= std::numeric_limits<float>::max())) {
        throw InvalidInput(path_.string() +
                           ": a coordinate is too large for the 32 bits of this "
                           "format; write OBJ or OFF");
      }
      raw(static_cast<float>(coordinate));
    }
  }

  void commit() {
    flush();
    file_.commit();
  }

 private:
  // Where `bytes` more may be put; few at a time.
  char* room(std::size_t bytes) {
    if (buffer_.size() - used_ < bytes) flush();
    return buffer_.data() + used_;
  }

  void flush() {
    file_.write({buffer_.data(), used_});
    used_ = 0;
  }

  const std::filesystem::path& path_;
  OutputFile file_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 18);
  std::size_t used_ = 0;
};

void write_ply(Writer& out, const Mesh& mesh) {
  out.text("ply\nformat binary_little_endian 1.0\nelement vertex ");
  out.number(mesh.vertex_count());
  out.text("\nproperty float x\nproperty float y\nproperty float z\nelement face ");
  out.number(mesh.triangle_count());
  out.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Vec3& position : mesh.positions) out.raw(position);
  for (const Triangle& triangle : mesh.triangles) {
    out.raw(std::uint8_t{3});
    for (const VertexId vertex : triangle) out.raw(vertex);
  }
}

void write_positions(Writer& out, const Mesh& mesh, std::string_view opening) {
  for (const Vec3& position : mesh.positions) {
    out.text(opening);
    out.number(position.x());
    out.text(" ");
    out.number(position.y());
    out.text(" ");
    out.number(position.z());
    out.text("\n");
  }
}

void write_triangles(Writer& out, const Mesh& mesh, std::string_view opening,
                     std::uint64_t first_vertex) {
  for (const Triangle& triangle : mesh.triangles) {
    out.text(opening);
    for (const VertexId vertex : triangle) {
      out.text(" ");
      out.number(first_vertex + vertex);
    }
    out.text("\n");
  }
}

void write_obj(Writer& out, const Mesh& mesh) {
  write_positions(out, mesh, "v ");
  write_triangles(out, mesh, "f", 1);
}

void write_off(Writer& out, const Mesh& mesh) {
  out.text("OFF\n");
  out.number(mesh.vertex_count());
  out.text(" ");
  out.number(mesh.triangle_count());
  out.text(" 0\n");
  write_positions(out, mesh, "");
  write_triangles(out, mesh, "3", 0);
}

void write_stl(Writer& out, const Mesh& mesh) {
  // Must not begin with "solid", the first word of an ascii STL.
  std::string title = "binary STL written by geolloyd";
  title.resize(80, ' ');
  out.text(title);
  out.raw(static_cast<std::uint32_t>(mesh.triangle_count()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& origin = mesh.positions[a];
    out.raw(normalized(cross(mesh.positions[b] - origin, mesh.positions[c] - origin)));
    for (const VertexId vertex : {a, b, c}) out.raw(mesh.positions[vertex]);
    out.raw(std::uint16_t{0});
  }
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  const MeshFormat format = format_of(path);
  Writer out(path);
  switch (format) {
    case MeshFormat::ply:
      write_ply(out, mesh);
      break;
    case MeshFormat::obj:
      write_obj(out, mesh);
      break;
    case MeshFormat::off:
      write_off(out, mesh);
      break;
    case MeshFormat::stl:
      write_stl(out, mesh);
      break;
  }
  out.commit();
}

}  // namespace geolloyd
