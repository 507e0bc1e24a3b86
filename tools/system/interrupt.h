#pragma once

namespace geolloyd {

/// From now on the first SIGINT or SIGTERM is only noted, so that work can end in good order. A
/// further one ends the program at once, unless it comes within half a second: some senders, such
/// as timeout(1), send each signal twice.
void catch_interrupts();

/// True once one of them has come.
bool interrupted();

}  // namespace geolloyd
