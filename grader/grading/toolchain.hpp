#pragma once
/// \file
/// Where this build's parts are. Only toolchain.cpp, which CMake makes, holds the values:
/// everything else is compiled to the same in every copy of this tree.

namespace ggrade::toolchain {

extern const char* const kVersion;
extern const char* const kSourceFolder;
extern const char* const kBuildFolder;
extern const char* const kCompiler;
extern const char* const kCompilerVersion;
/// Separated by spaces; the precompiled header is made with the same.
extern const char* const kCompileFlags;
/// The system's libraries that a submission is linked with, between semicolons, and a program that
/// is linked with the same, and draws.
extern const char* const kLibraries;
extern const char* const kProbe;
/// Everything that a submission is compiled and linked with: headers, loader, library, precompiled
/// header.
extern const char* const kKitFolder;
/// Holds the capture library under the four names that it replaces.
extern const char* const kCaptureFolder;
/// Holds `play`, which draws a tape again.
extern const char* const kPlayerFolder;

} // namespace ggrade::toolchain
