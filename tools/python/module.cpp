#include "tools/python/module.h"

#include <array>
#include <cstdio>

#include "geolloyd/errors.h"

namespace geolloyd {

std::string fingerprint_words(std::uint64_t fingerprint) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(fingerprint));
  return text.data();
}

}  // namespace geolloyd

PYBIND11_MODULE(_core, module) {
  module.attr("version") = GEOLLOYD_VERSION;
  pybind11::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const geolloyd::IoError& e) {
      PyErr_SetString(PyExc_OSError, e.what());
    } catch (const geolloyd::Error& e) {
      PyErr_SetString(PyExc_ValueError, e.what());
    }
  });
  geolloyd::bind_remesh(module);
  geolloyd::bind_tessellation(module);
  geolloyd::bind_measures(module);
  geolloyd::bind_files(module);
}
