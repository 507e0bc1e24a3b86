#include "core/formats/ply/ply_properties.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <system_error>
#include <type_traits>
#include <utility>

#include "core/properties/properties.h"

namespace geolloyd {
namespace {

constexpr std::size_t most_columns = 256;

PropertyValues values_of(const PlyNumber& type) {
  return visit_number([](auto zero) { return PropertyValues(std::vector<decltype(zero)>()); },
                      type);
}

// The nearest number of its type: a float is not rounded twice. Nothing where it is too large.
template <class Number>
std::optional<Number> parse_value(std::string_view word) {
  if constexpr (std::is_integral_v<Number>) {
    const auto number = parse_integer(word);
    if (!number || !std::in_range<Number>(*number)) return std::nullopt;
    return static_cast<Number>(*number);
  } else {
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    Number number{};
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error == std::errc{} && stop == end) return number;
    const auto large = parse_real(word);  // or too small for a float
    if (!large || !(std::abs(*large) < 1)) return std::nullopt;
    return static_cast<Number>(*large);
  }
}

}  // namespace

PlyColumnGroup::PlyColumnGroup(const PlyElement& element, std::span<const std::size_t> known,
                               const std::string& what, std::vector<std::string>& left_out)
    : element_(&element), column_of_(element.properties.size(), no_id) {
  std::set<std::string_view> names;
  for (const std::size_t i : known) names.insert(element.properties[i].name);
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (std::find(known.begin(), known.end(), i) != known.end()) continue;
    const PlyProperty& property = element.properties[i];
    const std::string name = in_quotes(property.name) + " of " + what + ": ";
    if (property.count_type) {
      left_out.push_back(name + "a list");
    } else if (!names.insert(property.name).second) {
      left_out.push_back(name + "the second one of this name");
    } else if (columns_.size() == most_columns) {
      left_out.push_back(name + "more than " + std::to_string(most_columns) +
                         " properties, this and the next ones");
      break;
    } else {
      column_of_[i] = static_cast<std::uint32_t>(columns_.size());
      property_of_.push_back(i);
      columns_.push_back({property.name, values_of(property.type)});
    }
  }
}

void PlyColumnGroup::read(PlyBody& body, std::size_t start) {
  const std::size_t end = body.offset();
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    body.rewind(start);
    std::visit(
        [&](auto& values) {
          using Number = ValueOf<std::remove_cvref_t<decltype(values)>>;
          values.resize(element_->count);
          body.for_each_row(*element_, property_of_[c],
                            [&](std::size_t row) { values[row] = body.next<Number>(); });
        },
        columns_[c].values);
  }
  body.rewind(end);
}

bool PlyColumnGroup::read(TextCursor& text, std::size_t property) {
  if (property >= column_of_.size() || column_of_[property] == no_id) return false;
  Property& column = columns_[column_of_[property]];
  std::visit(
      [&](auto& values) {
        using Number = ValueOf<std::remove_cvref_t<decltype(values)>>;
        const std::string_view word = text.word();
        const auto value = parse_value<Number>(word);
        if (!value) {
          text.fail_expected("property " + in_quotes(column.name) + ", a number of type " +
                                 type_name(column.values),
                             word);
        }
        values.push_back(*value);
      },
      column.values);
  return true;
}

PlyColumns::PlyColumns(const PlyHeader& header, const ReadOptions& options) {
  if (!options.properties) return;
  const PlyElement& vertex = header.elements[header.vertex];
  of_vertices = PlyColumnGroup(vertex, header.coordinates, "vertices", left_out_);
  if (header.faces) find_faces(header);
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    const PlyElement& element = header.elements[i];
    const bool has_surface = header.has_faces_at(i) || header.has_strips_at(i);
    if (i == header.vertex || has_surface || element.count == 0) continue;
    left_out_.push_back("element " + in_quotes(element.name) + ": neither vertices nor faces");
  }
}

void PlyColumns::find_faces(const PlyHeader& header) {
  const PlyElement& face = header.elements[header.faces->element];
  if (!header.strips) {
    of_faces = PlyColumnGroup(face, std::span(&header.faces->list, 1), "faces", left_out_);
  } else if (face.properties.size() > 1) {
    left_out_.emplace_back("properties of faces: triangles of strips have none");
  }
}

Properties PlyColumns::take() && {
  return {std::move(of_vertices).take(), std::move(of_faces).take(), std::move(left_out_)};
}

}  // namespace geolloyd
