#include "core/formats/mesh_writers.h"

namespace geolloyd {
namespace {

void write_place(FileWriter& out, const Vec3& position) {
  for (const double coordinate : position) {
    out.number(coordinate);
    out.text(" ");
  }
}

// The label, or 0 where there is none.
void write_label(FileWriter& out, const Property* label, std::size_t row) {
  if (label == nullptr) return out.text("0");
  std::visit([&](const auto& values) { out.number(values[row]); }, label->values);
}

}  // namespace

void write_medit(FileWriter& out, const Mesh& mesh, const HeldProperties& properties) {
  out.text("MeshVersionFormatted 2\nDimension 3\nVertices\n");
  out.number(mesh.vertex_count());
  out.text("\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    write_place(out, mesh.positions[v]);
    write_label(out, properties.vertex_label, v);
    out.text("\n");
  }
  out.text("Triangles\n");
  out.number(mesh.triangle_count());
  out.text("\n");
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId vertex : mesh.triangles[t]) {
      out.number(std::uint64_t{vertex} + 1);
      out.text(" ");
    }
    write_label(out, properties.triangle_label, t);
    out.text("\n");
  }
  out.text("End\n");
}

// Format 2.2, which more programs read than 4.1. The label is the physical group and the entity.
void write_gmsh(FileWriter& out, const Mesh& mesh, const HeldProperties& properties) {
  out.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n");
  out.number(mesh.vertex_count());
  out.text("\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    out.number(v + 1);
    for (const double coordinate : mesh.positions[v]) {
      out.text(" ");
      out.number(coordinate);
    }
    out.text("\n");
  }
  out.text("$EndNodes\n$Elements\n");
  out.number(mesh.triangle_count());
  out.text("\n");
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out.number(t + 1);
    out.text(" 2 2 ");
    write_label(out, properties.triangle_label, t);
    out.text(" ");
    write_label(out, properties.triangle_label, t);
    for (const VertexId vertex : mesh.triangles[t]) {
      out.text(" ");
      out.number(std::uint64_t{vertex} + 1);
    }
    out.text("\n");
  }
  out.text("$EndElements\n");
}

}  // namespace geolloyd
