#include "core/formats/corner_properties.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/properties/properties.h"

namespace geolloyd {
namespace {

std::string count_of(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what;
}

template <class Predicate>
bool all_of(const std::array<std::vector<double>, 4>& parts, Predicate&& predicate) {
  return std::all_of(parts.begin(), parts.end(), [&](const std::vector<double>& part) {
    return std::all_of(part.begin(), part.end(), predicate);
  });
}

}  // namespace

void CornerProperties::finish(std::size_t vertex_count, Properties& properties) {
  if (corners_.empty()) return;
  const auto leave_out = [&](const std::string& why) {
    properties.left_out.push_back(what_ + ": " + why);
  };
  if (corners_without_ > 0) {
    return leave_out(count_of(corners_without_, "of ") +
                     count_of(corners_.size() + corners_without_, "corners of faces have none"));
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::uint32_t> row_of(vertex_count, no_id);
  std::vector<std::uint8_t> is_on_seam(vertex_count, 0);
  for (const auto& [vertex, row] : corners_) {
    if (row_of[vertex] == no_id) row_of[vertex] = row;
    if (row_of[vertex] != row && rows_[row_of[vertex]] != rows_[row]) is_on_seam[vertex] = 1;
  }
  const auto seams = std::count(is_on_seam.begin(), is_on_seam.end(), 1);
  if (seams > 0) {
    return leave_out("a vertex has one, and " +
                     count_of(static_cast<std::size_t>(seams), "of them have") +
                     " several, in different faces (a seam)");
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    std::vector<double> values(vertex_count, none);
    for (std::size_t v = 0; v < vertex_count; ++v) {
      if (row_of[v] != no_id) values[v] = rows_[row_of[v]][i];
    }
    properties.of_vertices.push_back({names_[i], std::move(values)});
  }
}

void TextColours::add(const std::array<double, 4>& colour, std::size_t count) {
  ++items_;
  for (std::size_t c = 0; c < count; ++c) parts_[c].push_back(colour[c]);
}

bool TextColours::are_whole() const {
  const bool all =
      all_of(parts_, [](double x) { return x >= 0 && x <= 255 && x == std::floor(x); });
  return all && !all_of(parts_, [](double x) { return x <= 1; });
}

bool TextColours::are_shares_of_255() const {
  return all_of(parts_, [](double x) {
    constexpr double four_digits = 0.00006;
    return x >= 0 && x <= 1 && std::abs(x - std::floor(255 * x + 0.5) / 255) <= four_digits;
  });
}

void TextColours::finish(std::vector<Property>& properties, std::vector<std::string>& left_out) {
  static constexpr std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
  if (parts_[0].empty()) return;
  if (parts_[0].size() < items_) {
    left_out.push_back("colours of " + what_ + ": " + count_of(items_ - parts_[0].size(), "of ") +
                       count_of(items_, (what_ + " have none").c_str()));
    return;
  }
  if (parts_[3].size() < items_) {
    if (!parts_[3].empty()) left_out.push_back("alpha of " + what_ + ": some have none");
    parts_[3].clear();
  }
  const bool whole = are_whole();
  const bool become_bytes = whole || are_shares_of_255();
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (parts_[c].empty()) continue;
    if (!become_bytes) {
      properties.push_back({names[c], std::move(parts_[c])});
      continue;
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(items_);
    for (const double x : parts_[c]) {
      bytes.push_back(static_cast<std::uint8_t>(whole ? x : std::floor(255 * x + 0.5)));
    }
    properties.push_back({names[c], std::move(bytes)});
  }
}

}  // namespace geolloyd
