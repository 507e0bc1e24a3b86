#include "core/formats/mesh_formats.h"

#include <string_view>
#include <vector>

#include "core/text/compression.h"
#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

std::string extension_of(const std::filesystem::path& path) {
  return lower_case(name_without_compression(path).extension().string());
}

// ".ply, .obj and .off".
std::string list_extensions(bool MeshFormatFacts::*is_one) {
  std::vector<std::string> extensions;
  extensions.reserve(mesh_formats.size());
  for (const MeshFormatFacts& facts : mesh_formats) {
    if (facts.*is_one) extensions.emplace_back(facts.extension);
  }
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    if (i > 0) text += i + 1 < extensions.size() ? ", " : " and ";
    text += extensions[i];
  }
  return text;
}

MeshFormat format_that(bool MeshFormatFacts::*is_one, const char* what,
                       const std::filesystem::path& path) {
  const auto format = known_format(path);
  if (format && facts_of(*format).*is_one) return *format;
  const std::string extension = extension_of(path);
  if (format) {
    throw InvalidInput(path.string() + ": " + facts_of(*format).name + " is not " + what + "; " +
                       list_extensions(is_one) + " are");
  }
  throw InvalidInput(path.string() + ": unknown extension " + in_quotes(extension) + "; " +
                     list_extensions(is_one) + " are understood");
}

}  // namespace

const MeshFormatFacts& facts_of(MeshFormat format) {
  return mesh_formats[static_cast<std::size_t>(format)];
}

std::optional<MeshFormat> known_format(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  for (const MeshFormatFacts& facts : mesh_formats) {
    if (extension == facts.extension) return facts.format;
  }
  return std::nullopt;
}

MeshFormat format_to_read(const std::filesystem::path& path) {
  return format_that(&MeshFormatFacts::is_read, "read", path);
}

MeshFormat format_to_write(const std::filesystem::path& path) {
  return format_that(&MeshFormatFacts::is_written, "written", path);
}

bool has_mesh_name(const std::filesystem::path& path) {
  const auto format = known_format(path);
  return format && facts_of(*format).is_read;
}

}  // namespace geolloyd
