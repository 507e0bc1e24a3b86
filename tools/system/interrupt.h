#pragma once

namespace geolloyd {

// An interrupt is SIGINT, SIGTERM or SIGHUP; the last not where it was ignored when the program
// began, as nohup has it. The note is a global: a handler of signals gets no argument of ours.

/// From now on an interrupt ends the program at once, whatever it does, with one line on standard
/// error and exit status 130. Nothing is lost by that before there are results: a file has no name
/// until it is complete (file_io.h says where that fails), and folders are made after
/// catch_interrupts(). So no
/// function that reads a mesh, builds a graph or chooses seeds needs to ask for interrupts.
void end_on_interrupts();

/// From now on the first interrupt is only noted, so that work can end in good order. A further one
/// ends the program at once, unless it comes within half a second: some senders, such as
/// timeout(1), send each signal twice. To be called after end_on_interrupts().
void catch_interrupts();

/// True once an interrupt has been noted.
bool interrupted();

/// Thrown by a command that did its work after an interrupt: exit status 130, nothing printed.
struct InterruptedExit {};

/// Throws InterruptedExit once an interrupt has been noted: the watch of an executor whose work is
/// of no use by halves.
void give_up_if_interrupted();

/// Thrown by a command whose results are there, but bad, where --strict was given: exit status 3,
/// nothing printed.
struct WarnedExit {};

}  // namespace geolloyd
