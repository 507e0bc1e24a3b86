#pragma once

// CLI11 is large: headers that only name the program or a command include this instead.
namespace CLI {
class App;
}
