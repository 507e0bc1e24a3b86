#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tests/support/temporary_folder.h"

// What tests of mesh formats share.

namespace geolloyd {

using Triangles = std::vector<Triangle>;

/// Coordinates that 32 bits hold, vertices in the order in which the triangles name them, so that
/// every format gives the same mesh back.
inline Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0.5}, {0, -1.25, 0}, {0, 0, 3}},
          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

/// The bytes of a number.
template <class Number>
std::string raw(Number number, std::endian order) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// `bytes` with the first `from` in it replaced.
inline std::string with(std::string bytes, std::string_view from, std::string_view to) {
  const std::size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return bytes.replace(at, from.size(), to);
}

/// Files of bytes, read, and refused as they should be.
class MeshFiles : public testing::Test {
 protected:
  [[nodiscard]] LoadedMesh load(const std::string& name, std::string_view bytes) const {
    return read(folder_.write(name, bytes));
  }

  [[nodiscard]] Mesh round_trip(const std::string& name, const Mesh& mesh) const {
    write(folder_.path() / name, mesh);
    return read(folder_.path() / name).mesh;
  }

  [[nodiscard]] std::string written(const std::string& name) const {
    write(folder_.path() / name, tetrahedron());
    return read_file(folder_.path() / name);
  }

  /// The message of the InvalidInput, from the file's name on; empty where there is none.
  [[nodiscard]] std::string complaint(const std::string& name, std::string_view bytes) const {
    try {
      (void)load(name, bytes);
      return {};
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      const std::string prefix = (folder_.path() / "").string();
      EXPECT_TRUE(message.starts_with(prefix)) << message;
      EXPECT_EQ(message.find_first_of("\n\r"), std::string::npos) << message;
      return message.substr(std::min(prefix.size(), message.size()));
    }
  }

  /// Either refuses the file or makes a sound mesh of it; true where it does the latter.
  [[nodiscard]] bool is_accepted(const std::string& name, std::string_view bytes) const {
    try {
      const Mesh mesh = load(name, bytes).mesh;
      EXPECT_FALSE(mesh.triangles.empty());
      for (const Vec3& p : mesh.positions) {
        EXPECT_LE(p.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), largest_coordinate);
      }
      for (const Triangle& t : mesh.triangles) {
        EXPECT_LT(*std::max_element(t.begin(), t.end()), mesh.vertex_count());
      }
      return true;
    } catch (const InvalidInput&) {
      return false;
    }
  }

  void expect_tetrahedron(const std::string& name, std::string_view bytes) const {
    const Mesh mesh = load(name, bytes).mesh;
    EXPECT_EQ(mesh.positions, tetrahedron().positions);
    EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace geolloyd
