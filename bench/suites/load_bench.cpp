// Reading the mesh from a file of each format, and from the user's own.
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "bench/suites/suites.h"
#include "bench/support/run.h"
#include "core/formats/mesh_io.h"

namespace geolloyd {
namespace {

namespace fs = std::filesystem;

/// Gone with what it holds when the object goes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "geolloyd-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool same_mesh(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

// STL has no vertices, only the corners of triangles, in float32.
bool same_corners(const Mesh& read, const Mesh& written) {
  if (read.triangle_count() != written.triangle_count()) return false;
  for (std::size_t t = 0; t < read.triangle_count(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& w = written.positions[written.triangles[t][c]];
      const Vec3& r = read.positions[read.triangles[t][c]];
      if (r != w.cast<float>().cast<double>()) return false;
    }
  }
  return true;
}

template <class IsRight>
void load_file(Run& run, const fs::path& file, IsRight&& is_right) {
  run.verify("the mesh read is not the mesh written",
             [&] { return is_right(read(file).mesh, run.inputs().mesh()); });
  run.measure([&] { return read(file); });
  run.rate("triangles/s", run.inputs().mesh().triangle_count());
  run.bytes(fs::file_size(file));
}

void load_format(Run& run, const std::string& format) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / ("mesh." + format);
  write(file, run.inputs().mesh());
  load_file(run, file, format == "stl" ? same_corners : same_mesh);
}

}  // namespace

void add_load_benchmarks(const BenchMesh& mesh) {
  for (const std::string format : {"ply", "obj", "off", "stl"}) {
    add_benchmark("load/" + format, mesh, {}, [format](Run& run) { load_format(run, format); });
  }
  if (mesh.file.empty()) return;
  add_benchmark("load/as-given", mesh, {},
                [file = mesh.file](Run& run) { load_file(run, file, same_mesh); });
}

}  // namespace geolloyd
