#pragma once

#include <string>

namespace geolloyd {

/// Asks the desktop to open an address (xdg-open), and does not wait for it. False where there is
/// nobody to ask. Other users of the machine may see the address in the list of processes.
bool open_in_browser(const std::string& address);

}  // namespace geolloyd
