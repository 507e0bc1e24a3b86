#include "tools/files/csv.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace geolloyd {
namespace {

// "/a/b" as flatten() names it: a_b.
std::string column_of(std::string pointer) {
  std::replace(pointer.begin(), pointer.end(), '/', '_');
  return pointer.substr(1);
}

// In quotes where what is in it would end a cell (RFC 4180).
std::string cell_of(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  const auto& text = value.get_ref<const std::string&>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + "\"";
}

void end_line(std::string& line) {
  if (!line.empty()) line.back() = '\n';
}

}  // namespace

std::string csv_text(const Json& rows) {
  std::string text;
  for (const Json& row : rows) {
    std::string names;
    std::string cells;
    const Json flat = row.flatten();
    for (auto field = flat.begin(); field != flat.end(); ++field) {
      names += column_of(field.key()) + ",";
      cells += cell_of(field.value()) + ",";
    }
    end_line(names);
    end_line(cells);
    text += (text.empty() ? names : "") + cells;
  }
  return text;
}

}  // namespace geolloyd
