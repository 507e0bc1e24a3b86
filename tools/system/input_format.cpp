#include "tools/system/input_format.h"

namespace geolloyd {
namespace {

std::optional<MeshFormat> format_of_input;

}  // namespace

void set_input_format(MeshFormat format) {
  format_of_input = format;
}

std::optional<MeshFormat> input_format() {
  return format_of_input;
}

}  // namespace geolloyd
