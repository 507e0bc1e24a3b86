// What relax and remesh do with colours, normals, labels and other properties of their input.
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/properties/properties.h"
#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tools/files/label_groups.h"
#include "tools/render/surface_colours.h"

namespace geolloyd {
namespace {

double linear(const Vec3& p) {
  return 2 + p.x() - 3 * p.y() + 0.5 * p.z();
}

// A scalar, a colour, a normal and labels per vertex; labels and a scalar per triangle.
Properties sample_properties(const Mesh& mesh) {
  std::vector<double> q;
  std::array<std::vector<std::uint8_t>, 3> colour;
  std::array<std::vector<float>, 3> normal;
  std::vector<std::int16_t> half;
  for (const Vec3& p : mesh.positions) {
    q.push_back(linear(p));
    const Vec3 n = norm(p) > 0 ? normalized(p) : Vec3(0, 0, 1);
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = n[static_cast<Eigen::Index>(c)];
      colour[c].push_back(static_cast<std::uint8_t>(127 + 120 * x));
      normal[c].push_back(static_cast<float>(x));
    }
    half.push_back(p.x() > 0.2 ? 7 : -3);
  }
  Properties properties;
  properties.of_vertices = {
      {"q", q},          {"red", colour[0]}, {"green", colour[1]}, {"blue", colour[2]},
      {"nx", normal[0]}, {"ny", normal[1]},  {"nz", normal[2]},    {"half", half}};
  std::vector<std::int32_t> cap;
  std::vector<float> height;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    cap.push_back(middle.z() > 0.3 ? 5 : 1);
    height.push_back(static_cast<float>(middle.z()));
  }
  properties.of_triangles = {{"cap", cap}, {"height", height}};
  return properties;
}

class Carrying : public Program {
 protected:
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

  void write_sample(const Mesh& mesh) {
    mesh_ = file("sample.ply");
    write(mesh_, mesh, sample_properties(mesh));
  }

  [[nodiscard]] Outcome remesh(const std::string& options,
                               const std::string& name = "r.ply") const {
    return geolloyd_with("remesh " + mesh_.string() + " -o " + file(name).string() + " " + options);
  }

  static LoadedMesh read(const fs::path& path) { return geolloyd::read(path, {true}); }

  static void expect_text(const Outcome& outcome, const std::string& text) {
    EXPECT_NE(outcome.text.find(text), std::string::npos) << text << "\n" << outcome.text;
  }
};

void expect_same_bits(const Property& found, const Property& expected) {
  ASSERT_EQ(found.values.index(), expected.values.index()) << expected.name;
  std::visit(
      [&](const auto& values) {
        const auto& others = std::get<std::remove_cvref_t<decltype(values)>>(expected.values);
        ASSERT_EQ(values.size(), others.size()) << expected.name;
        EXPECT_EQ(std::memcmp(values.data(), others.data(), values.size() * sizeof(values[0])), 0)
            << expected.name;
      },
      found.values);
}

// Every vertex of a remesh that lies on the surface.
void expect_linear(const LoadedMesh& remesh, double tolerance) {
  const Property* q = find_property(remesh.properties.of_vertices, "q");
  ASSERT_NE(q, nullptr);
  for (std::size_t v = 0; v < remesh.mesh.vertex_count(); ++v) {
    EXPECT_NEAR(value_at(*q, v), linear(remesh.mesh.positions[v]), tolerance);
  }
}

double area_of_label(const LoadedMesh& loaded, const std::string& name, double label) {
  const Property& labels = *find_property(loaded.properties.of_triangles, name);
  double area = 0;
  for (std::size_t t = 0; t < loaded.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = loaded.mesh.triangles[t];
    const std::vector<Vec3>& p = loaded.mesh.positions;
    if (value_at(labels, t) == label) area += norm(cross(p[b] - p[a], p[c] - p[a])) / 2;
  }
  return area;
}

TEST_F(Carrying, TessellationHasAllPropertiesUnchanged) {
  const Mesh mesh = icosphere(1500);
  Properties properties = sample_properties(mesh);
  const auto add = [&](const char* name, auto first) {
    std::vector<decltype(first)> values(mesh.vertex_count(), first);
    std::iota(values.begin() + 2, values.end(), decltype(first){0});
    properties.of_vertices.push_back({name, values});
  };
  add("c", std::int8_t{-128});
  add("us", std::uint16_t{65535});
  add("ui", std::uint32_t{4294967295U});
  add("f", -std::numeric_limits<float>::infinity());
  add("d", std::numeric_limits<double>::quiet_NaN());
  mesh_ = file("all.ply");
  write(mesh_, mesh, properties);
  for (const char* graph : {"vertex", "triangle", "mixed"}) {
    SCOPED_TRACE(graph);
    const Outcome outcome = relax(std::string("-k 20 -g ") + graph, graph);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    expect_text(outcome,
                "carried     q, red, green, blue, nx, ny, nz, half, c, us, ui, f, d of vertices; "
                "cap, height of triangles\n");
    const LoadedMesh written = read(out(graph) / "tessellation.ply");
    EXPECT_EQ(written.mesh.triangles, mesh.triangles);
    const bool has_regions = std::string(graph) != "triangle";
    const std::vector<Property>& found = written.properties.of_vertices;
    for (const Property& property : properties.of_vertices) {
      const bool is_colour = is_colour_part(property.name);
      const std::string name = (has_regions && is_colour ? "input_" : "") + property.name;
      ASSERT_NE(find_property(found, name), nullptr) << name;
      expect_same_bits(*find_property(found, name), property);
    }
    EXPECT_EQ(find_property(found, "region") != nullptr, has_regions);
    for (const Property& property : properties.of_triangles) {
      expect_same_bits(*find_property(written.properties.of_triangles, property.name), property);
    }
  }
}

TEST_F(Carrying, RemeshInterpolatesOnASphere) {
  write_sample(icosphere(3000));
  ASSERT_EQ(remesh("-n 200 --no-fit").status, 0);
  const LoadedMesh made = read(file("r.ply"));
  expect_linear(made, 1e-12);
  const std::vector<Property>& found = made.properties.of_vertices;
  EXPECT_EQ(list_names(found), "q, red, green, blue, nx, ny, nz, half");
  const Triple normal = find_triple(found, normal_names);
  const Triple colour = find_triple(found, colour_names);
  for (std::size_t v = 0; v < made.mesh.vertex_count(); ++v) {
    const Vec3 outward = normalized(made.mesh.positions[v]);
    const Vec3 n(value_at(*normal[0], v), value_at(*normal[1], v), value_at(*normal[2], v));
    EXPECT_NEAR(norm(n), 1, 1e-6);
    EXPECT_GT(dot(n, outward), 0.999);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(value_at(*colour[c], v), 127 + 120 * outward[static_cast<Eigen::Index>(c)], 2.5);
    }
    const double x = made.mesh.positions[v].x();
    if (std::abs(x - 0.2) > 0.1) {  // beyond a triangle of the input from the border
      EXPECT_EQ(value_at(*find_property(found, "half"), v), x > 0.2 ? 7 : -3);
    }
  }
  const Property& height = *find_property(made.properties.of_triangles, "height");
  const Property& cap = *find_property(made.properties.of_triangles, "cap");
  for (std::size_t t = 0; t < made.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = made.mesh.triangles[t];
    const double z =
        (made.mesh.positions[a] + made.mesh.positions[b] + made.mesh.positions[c]).z() / 3;
    EXPECT_NEAR(value_at(height, t), z, 0.06);
    if (std::abs(z - 0.3) > 0.2) {
      EXPECT_EQ(value_at(cap, t), z > 0.3 ? 5 : 1);
    }
  }
}

TEST_F(Carrying, RemeshesOfPlanesInterpolateExactly) {
  write_sample(irregular_plane(3000, 1));
  ASSERT_EQ(remesh("-n 150").status, 0);
  expect_linear(read(file("r.ply")), 1e-12);
  for (const char* options : {"-k 40", "-k 40 -g triangle", "-k 40 --dual-vertices centroids"}) {
    SCOPED_TRACE(options);  // at the boundary vertices have left their seeds
    const std::string name = "out" + std::to_string(std::strlen(options));
    ASSERT_EQ(relax(options, name).status, 0);
    expect_linear(read(out(name) / "dual.ply"), 1e-12);
  }
}

TEST_F(Carrying, RelaxTakesSeedsAsTheyAre) {
  write_sample(icosphere(3000));
  ASSERT_EQ(relax("-k 60").status, 0);
  const LoadedMesh input = read(mesh_);
  const LoadedMesh made = read(out() / "dual.ply");
  const auto lines = lines_of(out() / "seeds.csv");
  for (std::size_t r = 0; r + 1 < lines.size(); ++r) {
    const std::size_t seed = std::stoul(lines[r + 1]);
    for (const char* name : {"q", "red", "half"}) {
      EXPECT_EQ(value_at(*find_property(made.properties.of_vertices, name), r),
                value_at(*find_property(input.properties.of_vertices, name), seed));
    }
  }
  EXPECT_EQ(list_names(made.properties.of_triangles), "cap, height");
}

// Borders between labels become edges of the remesh, with the labels on their sides, so the areas
// of labels stay.
TEST_F(Carrying, BordersOfLabelsBecomeFeatures) {
  write_sample(icosphere(6000));
  const LoadedMesh input = read(mesh_);
  for (const std::string name : {"cap", "half"}) {
    SCOPED_TRACE(name);
    const Outcome outcome =
        remesh("-n 300 --feature-labels " + name + " --report " + file("r.json").string());
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    const auto report = nlohmann::json::parse(read_file(file("r.json")));
    EXPECT_EQ(report["options"]["feature_labels"], name);
    EXPECT_GT(report["remesh"]["feature_edges"], 10);
    if (name == "half") continue;
    const LoadedMesh made = read(file("r.ply"));
    for (const double label : {1.0, 5.0}) {
      const double area = area_of_label(input, name, label);
      EXPECT_NEAR(area_of_label(made, name, label), area, 0.02 * area);
    }
    const MeshEdges edges = find_edges(made.mesh);
    const Property& labels = *find_property(made.properties.of_triangles, name);
    std::size_t borders = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto corners = edges.corners(e);
      borders +=
          value_at(labels, triangle_of(corners[0])) != value_at(labels, triangle_of(corners[1]))
              ? 1
              : 0;
    }
    EXPECT_EQ(report["remesh"]["feature_edges"], borders);
  }
}

TEST(LabelGroups, OfVerticesGoByTheMajorityOfCorners) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 2, 0}},
                     {{0, 1, 2}, {1, 3, 2}, {3, 4, 0}}};
  Properties properties;
  properties.of_vertices = {{"label", std::vector<std::int32_t>{4, 4, 9, 9, -2}}};
  EXPECT_EQ(label_groups(mesh, properties, "label"),
            (std::vector<std::uint32_t>{4, 9, static_cast<std::uint32_t>(-2)}));
  properties.of_triangles = {{"label", std::vector<std::uint8_t>{1, 2, 3}}};
  EXPECT_EQ(label_groups(mesh, properties, "label"), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST_F(Carrying, WhatIsNoLabelIsRefused) {
  write_sample(icosphere(500));
  expect_complaint(remesh("-n 50 --feature-labels nothing"),
                   "--feature-labels 'nothing': the mesh has no such property; its vertices have "
                   "q, red, green, blue, nx, ny, nz, half, its triangles cap, height");
  expect_complaint(remesh("-n 50 --feature-labels q"),
                   "--feature-labels 'q': its type is double, and labels are integers");
  expect_complaint(remesh("-n 50 --feature-labels red"),
                   "--feature-labels 'red': it is a part of a colour, and no label");
  EXPECT_FALSE(fs::exists(file("r.ply")));
}

TEST_F(Carrying, DropLeavesPropertiesOut) {
  write_sample(icosphere(1500));
  const Outcome outcome =
      remesh("-n 60 --drop --feature-labels cap --report " + file("r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(outcome.text.find("carried"), std::string::npos);
  EXPECT_TRUE(read(file("r.ply")).properties.empty());
  const auto report = nlohmann::json::parse(read_file(file("r.json")));
  EXPECT_EQ(report["options"]["drop"], true);
  EXPECT_GT(report["remesh"]["feature_edges"], 5);
  EXPECT_TRUE(report["properties"]["vertices"].empty());
  ASSERT_EQ(relax("-k 30 --drop").status, 0);
  EXPECT_EQ(list_names(read(out() / "tessellation.ply").properties.of_vertices),
            "red, green, blue, region");
  EXPECT_TRUE(read(out() / "dual.ply").properties.empty());
}

TEST_F(Carrying, ReportsNameWhatWasCarried) {
  write_sample(icosphere(1500));
  ASSERT_EQ(relax("-k 30").status, 0);
  ASSERT_EQ(remesh("-n 60 --report " + file("r.json").string(), "r.obj").status, 0);
  const auto of_relax = nlohmann::json::parse(read_file(out() / "report.json"));
  EXPECT_EQ(of_relax["options"]["drop"], false);
  EXPECT_EQ(of_relax["properties"]["vertices"].size(), 8U);
  EXPECT_EQ(of_relax["properties"]["triangles"], (nlohmann::json{"cap", "height"}));
  EXPECT_TRUE(of_relax["properties"]["left_out"].empty());
  const auto of_remesh = nlohmann::json::parse(read_file(file("r.json")));
  EXPECT_EQ(of_remesh["properties"]["vertices"],
            (nlohmann::json{"red", "green", "blue", "nx", "ny", "nz"}));
  EXPECT_EQ(of_remesh["properties"]["left_out"],
            (nlohmann::json{"q, half of vertices: OBJ has no place for them; PLY has",
                            "cap, height of triangles: OBJ has no place for them; PLY has"}));
  EXPECT_EQ(list_names(read(file("r.obj")).properties.of_vertices), "red, green, blue, nx, ny, nz");
}

TEST_F(Carrying, ThreadsAndEnginesDoNotMatter) {
  write_sample(icosphere(1500));
  ASSERT_EQ(remesh("-n 60 --threads 1", "a.ply").status, 0);
  ASSERT_EQ(relax("-k 30 --threads 1", "a").status, 0);
  for (const std::string options :
       {"--threads 2", "--threads 5 --backend openmp", "--engine reference"}) {
    ASSERT_EQ(remesh("-n 60 " + options, "b.ply").status, 0);
    EXPECT_EQ(read_file(file("b.ply")), read_file(file("a.ply"))) << options;
    const std::string name = "b" + std::to_string(options.size());
    ASSERT_EQ(relax("-k 30 " + options, name).status, 0);
    for (const char* result : {"tessellation.ply", "dual.ply"}) {
      EXPECT_EQ(read_file(out(name) / result), read_file(out("a") / result)) << options;
    }
  }
}

TEST_F(Carrying, NumbersThatAreNoneStayWhereTheyAre) {
  const Mesh mesh = icosphere(1500);
  Properties properties = sample_properties(mesh);
  auto& q = std::get<std::vector<double>>(properties.of_vertices[0].values);
  for (std::size_t v = 0; v < q.size(); ++v) {
    if (mesh.positions[v].z() > 0) q[v] = std::numeric_limits<double>::quiet_NaN();
  }
  write(mesh_, mesh, properties);
  ASSERT_EQ(remesh("-n 60 --no-fit").status, 0);
  const LoadedMesh made = read(file("r.ply"));
  for (std::size_t v = 0; v < made.mesh.vertex_count(); ++v) {
    const double z = made.mesh.positions[v].z();
    const double value = value_at(made.properties.of_vertices[0], v);
    if (std::abs(z) > 0.15) {  // a triangle of the input away from the border
      EXPECT_EQ(std::isnan(value), z > 0);
    }
  }
}

TEST_F(Carrying, MalformedPropertiesAreRefusedAndCanBeDropped) {
  mesh_ = folder_.write(
      "bad.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 300\n0 1 0 1\n0 0 1 1\n"
      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  const std::string message =
      "bad.ply: line 12: expected property 'red', a number of type uchar, found '300'; --drop does "
      "without properties";
  expect_complaint(remesh("-n 10"), message);
  expect_complaint(relax("-k 4"), message);
  EXPECT_EQ(remesh("-n 10 --drop").status, 0);
  EXPECT_EQ(geolloyd_with("info " + mesh_.string()).status, 0);
}

// In a file of any bytes.
TEST_F(Carrying, OddNamesAreToldInOneLine) {
  mesh_ = folder_.write(
      "odd.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty int \x1b[31m\xff\nproperty list uchar int l\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 1 0\n1 0 0 3 0\n0 1 0 1 0\n"
      "0 0 1 1 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  const Outcome outcome = remesh("-n 10 --report " + file("r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  expect_text(outcome, "  carried     ?[31m? of vertices\n  left out    'l' of vertices: a list\n");
  EXPECT_TRUE(nlohmann::json::accept(read_file(file("r.json"))));
  EXPECT_EQ(read(file("r.ply")).properties.of_vertices.at(0).name, "\x1b[31m\xff");
}

TEST_F(Carrying, PicturesShowColours) {
  write_sample(icosphere(1500));
  const std::string size = " --size 100 ";
  ASSERT_EQ(remesh("-n 60 --picture " + file("a.png").string() + size).status, 0);
  ASSERT_EQ(remesh("-n 60 --drop --picture " + file("b.png").string() + size).status, 0);
  ASSERT_EQ(remesh("-n 60 --picture " + file("c.png").string() + size, "r.stl").status, 0);
  EXPECT_NE(read_file(file("a.png")), read_file(file("b.png")));
  EXPECT_EQ(read_file(file("a.png")), read_file(file("c.png")));
  const auto render = [&](const std::string& panel, const std::string& name) {
    return geolloyd_with("render " + mesh_.string() + size + "--panel " + panel + " -k 9 -o " +
                         file(name).string());
  };
  ASSERT_EQ(render("surface", "own.png").status, 0);
  ASSERT_EQ(render("mesh", "edges.png").status, 0);
  ASSERT_EQ(render("surface --drop", "dropped.png").status, 0);
  const Mesh plain = read(mesh_).mesh;
  write(mesh_, plain);
  ASSERT_EQ(render("surface", "plain.png").status, 0);
  EXPECT_NE(read_file(file("own.png")), read_file(file("plain.png")));
  EXPECT_EQ(read_file(file("dropped.png")), read_file(file("plain.png")));
}

TEST(SurfaceColours, AreThoseOfVerticesElseOfTriangles) {
  Properties properties;
  const std::vector<std::uint8_t> bytes = {0, 128, 255};
  properties.of_triangles = {{"red", bytes}, {"green", bytes}, {"blue", bytes}};
  EXPECT_EQ(colours_of(properties).of_triangles.at(1), (Colour{128, 128, 128}));
  const float none = std::numeric_limits<float>::quiet_NaN();
  properties.of_vertices = {{"red", std::vector<float>{0, 2, none}},
                            {"green", std::vector<float>{0.5F, -1, none}},
                            {"blue", std::vector<std::uint16_t>{0, 65535, 256}}};
  const SurfaceColours colours = colours_of(properties);
  EXPECT_TRUE(colours.of_triangles.empty());
  EXPECT_EQ(colours.of_vertices, (std::vector<Colour>{{0, 128, 0}, {255, 0, 255}, {128, 128, 1}}));
}

}  // namespace
}  // namespace geolloyd
