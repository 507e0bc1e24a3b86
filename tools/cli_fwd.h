#pragma once

// CLI11 is large: headers that only name the program or a command include this instead.
namespace CLI {  // NOLINT(readability-identifier-naming): its name
class App;
}
