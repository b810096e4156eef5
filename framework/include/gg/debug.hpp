#pragma once
/// \file
/// What OpenGL has to say about the program's mistakes.

namespace gg {

/// Prints the driver's error messages and warnings on stderr, each once, as they happen. Needs
/// KHR_debug, which Macs lack; there, and with GG_DEBUG_OUTPUT=0 in the environment,
/// reportErrors() is what remains.
void installDebugSink();
bool hasDebugSink();

/// Prints each kind of pending GL error once on stderr. Does nothing where the sink is installed.
///   where: what the program was doing, for the message
void reportErrors(const char* where);

} // namespace gg
