#include "tools/csv.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace geolloyd {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string text_of(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void flatten(const Json& object, const std::string& prefix, Fields& fields) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      flatten(value, prefix + key + "_", fields);
    } else if (!value.is_array()) {
      fields.emplace_back(prefix + key, text_of(value));
    }
  }
}

}  // namespace

std::string csv_text(const Json& rows) {
  std::string head;
  std::string body;
  for (const Json& row : rows) {
    Fields fields;
    flatten(row, "", fields);
    std::string names;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const char* end = i + 1 < fields.size() ? "," : "\n";
      names += fields[i].first + end;
      body += fields[i].second + end;
    }
    if (head.empty()) head = std::move(names);
  }
  return head + body;
}

}  // namespace geolloyd
