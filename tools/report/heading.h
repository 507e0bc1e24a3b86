#pragma once

#include "tools/run/stages.h"

namespace geolloyd {

// The first lines that commands print which judge or measure a run.

/// A line that names mesh and graph, one on seeds given by position, and the machine.
void print_heading(const PreparedInput& start);

/// A line that names the machine, and an empty one.
void print_machine();

}  // namespace geolloyd
