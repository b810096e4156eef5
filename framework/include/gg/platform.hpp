#pragma once
/// \file
/// The little that differs between Linux, macOS and Windows.

#include <filesystem>
#include <string>
#include <vector>

namespace gg {

/// Before anything is printed: on Windows, makes the terminal show UTF-8 and sets LANG to the
/// user's language if it isn't set; elsewhere both are so.
void prepareTerminal();

/// The folder that the running program lies in. Files are found from there, never from the current
/// directory.
std::filesystem::path programFolder();

/// The folder with the shaders that the user edits: where the program was built from, which
/// source_folder.txt beside the program says; without it the program's own.
std::filesystem::path shaderFolder();

/// The program's arguments as UTF-8, without its name.
std::vector<std::string> utf8Arguments(int argc, char** argv);

} // namespace gg
