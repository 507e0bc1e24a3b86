#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

std::vector<Named<MeshFormat>> names_that(bool MeshFormatFacts::*is_one) {
  std::vector<Named<MeshFormat>> names;
  names.reserve(mesh_formats.size());
  for (const MeshFormatFacts& facts : mesh_formats) {
    if (facts.*is_one) names.push_back({facts.extension + 1, facts.format});
  }
  return names;
}

std::string listed(const std::vector<Named<MeshFormat>>& formats) {
  std::string text;
  for (const Named<MeshFormat>& format : formats) {
    text.append(text.empty() ? "" : ", ").append(format.name);
  }
  return text;
}

}  // namespace

const std::vector<Named<MeshFormat>> read_format_names = names_that(&MeshFormatFacts::is_read);
const std::vector<Named<MeshFormat>> written_format_names =
    names_that(&MeshFormatFacts::is_written);

const std::string input_mesh_text =
    "Mesh file: " + listed(read_format_names) + ";\nalso packed as .gz or .zst; -: standard input";
const std::string output_mesh_text =
    listed(written_format_names) + ",\nalso .gz or .zst; -: standard output";

}  // namespace geolloyd
