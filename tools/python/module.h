#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>

#include "geolloyd/errors.h"
#include "geolloyd/evaluation.h"
#include "geolloyd/quality.h"
#include "tools/words/named.h"

namespace geolloyd {

// The functions of geolloyd._core, by what they are about. geolloyd/_core.pyi has their types.

void bind_remesh(pybind11::module_& module);
void bind_tessellation(pybind11::module_& module);
void bind_measures(pybind11::module_& module);
void bind_files(pybind11::module_& module);

/// What the name stands for. Throws InvalidInput where `text` is none of the names.
template <class Choice>
Choice choice_of(const char* option, const std::vector<Named<Choice>>& choices,
                 const std::string& text) {
  std::string names;
  for (const Named<Choice>& choice : choices) {
    if (choice.name == text) return choice.value;
    names += (names.empty() ? "" : ", ") + std::string(choice.name);
  }
  throw InvalidInput(std::string(option) + ": '" + text + "': give one of " + names);
}

/// As reports have it.
std::string fingerprint_words(std::uint64_t fingerprint);
pybind11::dict words_of(const DistanceBounds& bounds);
pybind11::dict words_of(const MeshTopology& topology);
pybind11::dict words_of(const MeshQuality& quality);

}  // namespace geolloyd
