#pragma once

#include <CLI/CLI.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "tools/words/named.h"

namespace geolloyd {

/// Makes `option` take one of the names, or several separated by commas where it is a list, and the
/// help text list them as "a|b|c".
template <class Choice>
CLI::Option* one_of(CLI::Option* option, const std::vector<Named<Choice>>& choices) {
  const std::vector<std::string> names = names_of(choices);
  const auto join = [](const std::string& list, const std::string& name) {
    return list.empty() ? name : list + "|" + name;
  };
  CLI::Validator check = CLI::IsMember(names);
  check.description("");
  return option->check(check)->type_name(
      std::accumulate(names.begin(), names.end(), std::string(), join));
}

}  // namespace geolloyd
