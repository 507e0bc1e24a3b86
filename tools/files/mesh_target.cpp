#include "tools/files/mesh_target.h"

#include <unistd.h>

#include "core/formats/mesh_formats.h"
#include "geolloyd/errors.h"
#include "tools/files/output_folder.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {

bool MeshTarget::is_stream() const {
  return file == standard_output;
}

std::string MeshTarget::name() const {
  return is_stream() ? "standard output" : file.string();
}

MeshFormat format_to_write(const MeshTarget& target) {
  const bool is_told = !target.is_stream() && known_format(target.file);
  return !is_told && target.format ? *target.format : format_to_write(target.file);
}

void prepare_target(MeshTarget& target, std::optional<MeshFormat> input_format,
                    std::span<const std::filesystem::path> others, Console& console) {
  if (target.is_stream() && !target.format) target.format = input_format.value_or(MeshFormat::ply);
  const MeshFormat format = format_to_write(target);
  if (!target.is_stream()) return check_target(target.file, others);
  target.stream = console.lend_standard_output();
  if (::isatty(target.stream) != 0 && facts_of(format).is_binary) {
    throw InvalidInput(target.name() + ": " + facts_of(format).name +
                       " is binary, and this is a terminal: name a file, or send it elsewhere");
  }
}

std::unique_ptr<FileWriter> open_target(const MeshTarget& target) {
  if (!target.is_stream()) return std::make_unique<FileWriter>(target.file);
  return std::make_unique<FileWriter>(target.stream, target.name());
}

void write(const MeshTarget& target, const Mesh& mesh, const Properties& properties) {
  const std::unique_ptr<FileWriter> out = open_target(target);
  write(*out, format_to_write(target), mesh, properties);
  out->commit();
}

}  // namespace geolloyd
