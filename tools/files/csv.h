#pragma once

#include <string>

#include "tools/files/json.h"

namespace geolloyd {

/// An array of objects with the same keys as a table: {"a": {"b": 1}, "c": null} becomes the
/// columns a_b and c, the latter empty.
std::string csv_text(const Json& rows);

}  // namespace geolloyd
