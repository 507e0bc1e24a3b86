#pragma once

#include <string>

namespace geolloyd {

/// "geolloyd 0.1.0 (99d485b)": version and, where it was built from a repository, commit.
std::string program_name();

/// "GCC 12.2.0".
std::string compiler_name();

/// Lines for people who report a fault: program, compiler, flags, libraries built against.
std::string build_facts_text();

}  // namespace geolloyd
