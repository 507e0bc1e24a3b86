#pragma once

#include <string>
#include <vector>

namespace geolloyd {

/// A choice and the word for it on the command line and in report.json.
template <class Choice>
struct Named {
  const char* name;
  Choice value;
};

template <class Choice>
std::vector<std::string> names_of(const std::vector<Named<Choice>>& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& choice : choices) names.emplace_back(choice.name);
  return names;
}

template <class Choice>
std::vector<Choice> values_of(const std::vector<Named<Choice>>& choices) {
  std::vector<Choice> values;
  values.reserve(choices.size());
  for (const auto& choice : choices) values.push_back(choice.value);
  return values;
}

/// `name` must be one of the names.
template <class Choice>
Choice value_of(const std::vector<Named<Choice>>& choices, const std::string& name) {
  auto choice = choices.begin();
  while (choice->name != name) ++choice;
  return choice->value;
}

template <class Choice>
std::string name_of(const std::vector<Named<Choice>>& choices, Choice value) {
  auto choice = choices.begin();
  while (choice->value != value) ++choice;
  return choice->name;
}

template <class Choice>
std::vector<std::string> names_of(const std::vector<Named<Choice>>& choices,
                                  const std::vector<Choice>& values) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const Choice value : values) names.push_back(name_of(choices, value));
  return names;
}

}  // namespace geolloyd
