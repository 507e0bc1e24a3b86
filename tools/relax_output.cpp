#include "tools/relax_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "core/errors.h"
#include "core/file_writer.h"
#include "tools/palette.h"
#include "tools/report.h"

namespace geolloyd {
namespace {

constexpr std::array<const char*, 4> result_names = {"tessellation.ply", "seeds.csv", "regions.csv",
                                                     "report.json"};

// Told by its bits: compilers may take a cast to float and back for nothing.
bool is_float(double x) {
  constexpr std::uint64_t beyond_float = (std::uint64_t{1} << 29) - 1;
  const double size = std::abs(x);
  return x == 0 ||
         ((std::bit_cast<std::uint64_t>(x) & beyond_float) == 0 &&
          size >= std::numeric_limits<float>::min() && size <= std::numeric_limits<float>::max());
}

bool fits_float(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& p) {
    return is_float(p.x()) && is_float(p.y()) && is_float(p.z());
  });
}

class TessellationWriter {
 public:
  TessellationWriter(const RunRecord& run, FileWriter& out)
      : run_(run), mesh_(run.input.mesh), kind_(run.mesh_graph.kind), out_(out) {
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
    }
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      out_.raw(std::uint8_t{3});
      for (const VertexId v : mesh_.triangles[t]) out_.raw(v);
      if (has_triangles(kind_)) write_region(run_.mesh_graph.first_triangle_id + t);
    }
  }

 private:
  void write_header(const char* real) {
    const char* region =
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int region\n";
    out_.text(
        fmt::format("ply\nformat binary_little_endian 1.0\n"
                    "comment geolloyd: region r is that of the r-th seed in seeds.csv, from 0\n"
                    "element vertex {0}\nproperty {2} x\nproperty {2} y\nproperty {2} z\n{3}"
                    "element face {1}\nproperty list uchar uint vertex_indices\n{4}end_header\n",
                    mesh_.vertex_count(), mesh_.triangle_count(), real,
                    has_vertices(kind_) ? region : "", has_triangles(kind_) ? region : ""));
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
  FileWriter& out_;
  std::vector<std::uint32_t> colour_;  // per region
};

void write_tessellation(const RunRecord& run, FileWriter& out) {
  TessellationWriter(run, out).write();
}

std::string_view kind_of(const MeshGraph& mesh_graph, std::uint32_t input_id) {
  return mesh_graph.is_triangle(input_id) ? "triangle" : "vertex";
}

template <class First, class... Rest>
void write_row(FileWriter& out, const First& first, const Rest&... rest) {
  if constexpr (std::is_arithmetic_v<First>) {
    out.number(first);
  } else {
    out.text(first);
  }
  out.text(sizeof...(rest) == 0 ? "\n" : ",");
  if constexpr (sizeof...(rest) > 0) write_row(out, rest...);
}

void write_seeds(const RunRecord& run, FileWriter& out) {
  out.text("input_id,kind,x,y,z,nodes,area,energy\n");
  for (const RegionSummary& region : run.regions) {
    const std::uint32_t id = run.mesh_graph.input_id[region.seed];
    const Vec3& p = run.mesh_graph.position[region.seed];
    write_row(out, id, kind_of(run.mesh_graph, id), p.x(), p.y(), p.z(), region.node_count,
              region.area, region.energy);
  }
}

void write_regions(const RunRecord& run, FileWriter& out) {
  out.text("input_id,kind,region,distance\n");
  const std::vector<NodeId>& node_of = run.mesh_graph.node_of;
  for (std::uint32_t id = 0; id < node_of.size(); ++id) {
    const std::string_view kind = kind_of(run.mesh_graph, id);
    if (node_of[id] == no_id) {
      write_row(out, id, kind, "-1", "nan");
    } else {
      const Key key = run.relaxation.partition.key[node_of[id]];
      const double distance = distance_of(key) * run.mesh_graph.graph.tick_length;
      write_row(out, id, kind, region_of(key), static_cast<float>(distance));
    }
  }
}

template <class Write>
void write_file(const RunRecord& run, const char* name, Write&& write) {
  FileWriter out(run.arguments.output / name);
  write(run, out);
  out.commit();
}

}  // namespace

void prepare_output(const RelaxArguments& arguments) {
  std::error_code error;
  std::filesystem::create_directories(arguments.output, error);
  if (error) throw IoError(arguments.output.string() + ": cannot make folder: " + error.message());

  std::vector<std::filesystem::path> results;
  for (const char* name : result_names) results.push_back(arguments.output / name);
  if (!arguments.picture.empty()) results.push_back(arguments.picture);
  for (const std::filesystem::path& result : results) {
    const OutputFile probe(result);
    for (const auto& input : {arguments.mesh, arguments.vfield}) {
      if (std::filesystem::equivalent(result, input, error)) {
        throw InvalidInput(input.string() +
                           ": is an input and would be overwritten: write somewhere else");
      }
    }
  }
}

void write_results(const RunRecord& run) {
  write_file(run, "tessellation.ply", write_tessellation);
  write_file(run, "seeds.csv", write_seeds);
  write_file(run, "regions.csv", write_regions);
}

void write_report(const RunRecord& run) {
  write_file(run, "report.json", [](const RunRecord& record, FileWriter& out) {
    out.text(make_report(record).dump(2) + "\n");
  });
}

}  // namespace geolloyd
