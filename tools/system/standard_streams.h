#pragma once

namespace geolloyd {

/// Where the program was started with standard input, output or error closed, opens something in
/// its place that cannot be read or written: else a file of ours would take the number, and with it
/// what is printed.
void hold_standard_streams();

/// Throws IoError where something printed was lost: on a full disk, say.
void check_printed();

}  // namespace geolloyd
