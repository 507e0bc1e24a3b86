#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

#include "tools/words/named.h"

namespace geolloyd {

// Options whose values have names. They are parsed into what the names stand for; the help text
// lists the names as "a|b|c", and any other name is refused.

inline std::string joined(const std::vector<std::string>& names, const char* separator) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : separator) + name;
  return list;
}

/// Makes `option` refuse what is none of the names, and list them.
template <class Choice>
CLI::Option* one_of(CLI::Option* option, const std::vector<Named<Choice>>& choices) {
  const std::vector<std::string> names = names_of(choices);
  CLI::Validator check = CLI::IsMember(names);
  check.description("");
  return option->check(check)->type_name(joined(names, "|"));
}

/// Adds an option that takes one name. The default is shown; a pointer has none.
template <class Choice>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Choice& choice,
                        const std::vector<Named<Choice>>& choices, const std::string& what) {
  CLI::Option* const option = command.add_option_function<std::string>(
      name, [&choice, &choices](const std::string& text) { choice = value_of(choices, text); },
      what);
  if constexpr (!std::is_pointer_v<Choice>) option->default_str(name_of(choices, choice));
  return one_of(option, choices);
}

/// Adds an option that takes several names, separated by commas. The default is shown where the
/// choices can be compared.
template <class Choice>
CLI::Option* add_choice_list(CLI::App& command, const std::string& name, std::vector<Choice>& list,
                             const std::vector<Named<Choice>>& choices, const std::string& what) {
  const auto store = [&list, &choices](const std::vector<std::string>& texts) {
    list.clear();
    for (const std::string& text : texts) list.push_back(value_of(choices, text));
  };
  CLI::Option* const option =
      command.add_option_function<std::vector<std::string>>(name, store, what);
  if constexpr (std::equality_comparable<Choice>) {
    option->default_str("[" + joined(names_of(choices, list), ",") + "]");
  }
  return one_of(option->delimiter(',')->allow_extra_args(false), choices);
}

}  // namespace geolloyd
