#pragma once

namespace geolloyd {

/// From now on the first SIGINT or SIGTERM is only noted, so that work can end in good order; the
/// second ends the program at once.
void catch_interrupts();

/// True once one of them has come.
bool interrupted();

}  // namespace geolloyd
