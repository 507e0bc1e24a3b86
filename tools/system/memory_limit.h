#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace geolloyd {

// How much memory the program may hold. The system gives memory away that it does not have, and
// ends a program that then uses it: so what cannot fit is refused before the work, and what was
// not foreseen meets a limit that ends it with a message (RLIMIT_DATA).
//
// The limit is the process's own, one for all its threads: it is told to the system, which holds
// every allocation to it, and is a global here as it is there.

/// Has arrays of large meshes go back to the system as soon as they are freed. The allocator would
/// keep holes instead, which the next arrays do not fit into.
void return_freed_memory();

/// Limits this process from now on, instead of any earlier limit.
void limit_memory(std::uint64_t bytes);

/// What this process may hold.
std::uint64_t allowed_memory();

/// Keeps the stacks of so many threads out of that: the system counts them, though they stay empty.
/// 0: as many as can run at once. Throws InvalidInput where the shell has no room for them.
void make_room_for_threads(std::size_t count);

/// Other programs started meanwhile have the limits that this one found.
class LiftedMemoryLimit {
 public:
  LiftedMemoryLimit();
  LiftedMemoryLimit(const LiftedMemoryLimit&) = delete;
  LiftedMemoryLimit& operator=(const LiftedMemoryLimit&) = delete;
  ~LiftedMemoryLimit();
};

/// Throws InvalidInput where `bytes` are more than the limit.
void require_memory(const std::string& what, std::uint64_t bytes);

/// What to tell the user when memory has run out.
std::string out_of_memory_message();

/// "14.2 GB".
std::string memory_text(std::uint64_t bytes);

}  // namespace geolloyd
