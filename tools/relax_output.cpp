#include "tools/relax_output.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>

#include "core/errors.h"
#include "core/file_io.h"
#include "tools/palette.h"
#include "tools/report.h"

namespace geolloyd {
namespace {

constexpr std::array<const char*, 4> result_names = {"tessellation.ply", "seeds.csv", "regions.csv",
                                                     "report.json"};

/// Collects bytes and hands them to a file in large pieces.
class Buffer {
 public:
  explicit Buffer(OutputFile& file) : file_(file) { bytes_.reserve(piece + 4096); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  template <class T>
  void raw(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Format, class... Args>
  void text(const Format& format, const Args&... args) {
    fmt::format_to(std::back_inserter(bytes_), format, args...);
  }
  void end_of_record() {
    if (bytes_.size() >= piece) flush();
  }
  void flush() {
    file_.write(bytes_);
    bytes_.clear();
  }

 private:
  static constexpr std::size_t piece = 1 << 20;

  OutputFile& file_;
  std::string bytes_;
};

bool fits_float(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const Vec3& p) { return p.cast<float>().cast<double>() == p; });
}

class TessellationWriter {
 public:
  TessellationWriter(const RunRecord& run, OutputFile& file)
      : run_(run), mesh_(run.input.mesh), kind_(run.mesh_graph.kind), out_(file) {
    const auto adjacent = adjacent_regions(run.mesh_graph.graph, run.relaxation.partition);
    colour_ = colour_regions(run.regions.size(), adjacent, palette_size);
  }

  void write() {
    const bool floats = fits_float(mesh_);
    write_header(floats ? "float" : "double");
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (const double x : mesh_.positions[v])
        floats ? out_.raw(static_cast<float>(x)) : out_.raw(x);
      if (has_vertices(kind_)) write_region(v);
      out_.end_of_record();
    }
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      out_.raw(std::uint8_t{3});
      for (const VertexId v : mesh_.triangles[t]) out_.raw(v);
      if (has_triangles(kind_)) write_region(run_.mesh_graph.first_triangle_id + t);
      out_.end_of_record();
    }
    out_.flush();
  }

 private:
  void write_header(const char* real) {
    const char* region =
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int region\n";
    out_.text(
        FMT_COMPILE("ply\nformat binary_little_endian 1.0\n"
                    "comment geolloyd: region r is that of the r-th seed in seeds.csv, from 0\n"
                    "element vertex {0}\nproperty {2} x\nproperty {2} y\nproperty {2} z\n{3}"
                    "element face {1}\nproperty list uchar uint vertex_indices\n{4}end_header\n"),
        mesh_.vertex_count(), mesh_.triangle_count(), real, has_vertices(kind_) ? region : "",
        has_triangles(kind_) ? region : "");
  }

  void write_region(std::size_t input_id) {
    const NodeId node = run_.mesh_graph.node_of[input_id];
    const RegionId region = node == no_id ? no_id : region_of(run_.relaxation.partition.key[node]);
    const Colour colour = region == no_id ? no_region_colour : palette_colour(colour_[region]);
    for (const std::uint8_t channel : colour) out_.raw(channel);
    out_.raw(static_cast<std::int32_t>(region));  // no_id is -1
  }

  const RunRecord& run_;
  const Mesh& mesh_;
  GraphKind kind_;
  Buffer out_;
  std::vector<std::uint32_t> colour_;  // per region
};

const char* kind_of(const MeshGraph& mesh_graph, std::uint32_t input_id) {
  return mesh_graph.is_triangle(input_id) ? "triangle" : "vertex";
}

void write_seeds(const RunRecord& run, OutputFile& file) {
  Buffer out(file);
  out.text(FMT_COMPILE("input_id,kind,x,y,z,nodes,area,energy\n"));
  for (const RegionSummary& region : run.regions) {
    const std::uint32_t id = run.mesh_graph.input_id[region.seed];
    const Vec3& p = run.mesh_graph.position[region.seed];
    out.text(FMT_COMPILE("{},{},{},{},{},{},{},{}\n"), id, kind_of(run.mesh_graph, id), p.x(),
             p.y(), p.z(), region.node_count, region.area, region.energy);
    out.end_of_record();
  }
  out.flush();
}

void write_regions(const RunRecord& run, OutputFile& file) {
  Buffer out(file);
  out.text(FMT_COMPILE("input_id,kind,region,distance\n"));
  const std::vector<NodeId>& node_of = run.mesh_graph.node_of;
  for (std::uint32_t id = 0; id < node_of.size(); ++id) {
    const char* kind = kind_of(run.mesh_graph, id);
    if (node_of[id] == no_id) {
      out.text(FMT_COMPILE("{},{},-1,nan\n"), id, kind);
    } else {
      const Key key = run.relaxation.partition.key[node_of[id]];
      const double distance = distance_of(key) * run.mesh_graph.graph.tick_length;
      out.text(FMT_COMPILE("{},{},{},{}\n"), id, kind, region_of(key),
               static_cast<float>(distance));
    }
    out.end_of_record();
  }
  out.flush();
}

template <class Write>
void write_file(const std::filesystem::path& path, Write&& write) {
  OutputFile file(path);
  write(file);
  file.commit();
}

}  // namespace

void prepare_output(const RelaxArguments& arguments) {
  std::error_code error;
  std::filesystem::create_directories(arguments.output, error);
  if (error) throw IoError(arguments.output.string() + ": cannot make folder: " + error.message());
  const OutputFile probe(arguments.output / "report.json");
  for (const char* name : result_names) {
    for (const auto& input : {arguments.mesh, arguments.vfield}) {
      if (std::filesystem::equivalent(arguments.output / name, input, error)) {
        throw InvalidInput(input.string() +
                           ": is an input and would be overwritten: choose another --output");
      }
    }
  }
}

void write_results(const RunRecord& run) {
  const std::filesystem::path& folder = run.arguments.output;
  write_file(folder / "tessellation.ply",
             [&](OutputFile& file) { TessellationWriter(run, file).write(); });
  write_file(folder / "seeds.csv", [&](OutputFile& file) { write_seeds(run, file); });
  write_file(folder / "regions.csv", [&](OutputFile& file) { write_regions(run, file); });
}

void write_report(const RunRecord& run) {
  write_file(run.arguments.output / "report.json",
             [&](OutputFile& file) { file.write(make_report(run).dump(2) + "\n"); });
}

}  // namespace geolloyd
