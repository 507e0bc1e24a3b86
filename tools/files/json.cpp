#include "tools/files/json.h"

#include <nlohmann/json.hpp>

namespace geolloyd {

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace geolloyd
