#pragma once

namespace geolloyd {

/// Thrown where the work can be left: no benchmark's failure, so no std::exception.
struct Interrupted {};

/// From now on Ctrl-C is answered by leave_if_interrupted(), so that temporary files go and
/// what has been measured is written; a second
/// one ends the program at once.
void watch_for_interrupts();
void leave_if_interrupted();
bool was_interrupted();

}  // namespace geolloyd
