#include <gg/platform.hpp>

#include <gg/text_file.hpp>

#if defined(_WIN32)
#include <cstdlib>

#include <windows.h>
// After windows.h, which it needs.
#include <shellapi.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

namespace gg {

namespace {

std::filesystem::path programFile() {
#if defined(_WIN32)
  std::wstring name(32768, L'\0'); // the longest path that Windows knows
  name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
  return name;
#elif defined(__APPLE__)
  std::uint32_t size = 0;
  _NSGetExecutablePath(nullptr, &size);
  std::string name(size, '\0');
  _NSGetExecutablePath(name.data(), &size);
  return std::filesystem::canonical(name.c_str());
#else
  return std::filesystem::read_symlink("/proc/self/exe");
#endif
}

} // namespace

void prepareTerminal() {
#if defined(_WIN32)
  if (std::getenv("LANG") == nullptr && PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_JAPANESE)
    _putenv_s("LANG", "ja");
  static const UINT before = GetConsoleOutputCP();
  SetConsoleOutputCP(CP_UTF8);
  std::atexit([] { SetConsoleOutputCP(before); }); // what runs there next may count on it
#endif
}

std::filesystem::path programFolder() {
  static const std::filesystem::path folder = programFile().parent_path();
  return folder;
}

std::filesystem::path shaderFolder() {
  std::error_code ignored;
  const std::filesystem::path note = programFolder() / "source_folder.txt";
  if (!std::filesystem::exists(note, ignored)) return programFolder();
  const std::filesystem::path folder = fromUtf8(readFile(note));
  return std::filesystem::is_directory(folder, ignored) ? folder : programFolder();
}

std::vector<std::string> utf8Arguments(int argc, char** argv) {
#if defined(_WIN32)
  (void)argv;
  (void)argc;
  std::vector<std::string> arguments;
  int count = 0;
  wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), &count);
  for (int i = 1; wide != nullptr && i < count; ++i)
    arguments.push_back(toUtf8(std::filesystem::path(wide[i])));
  LocalFree(wide);
  return arguments;
#else
  return argc > 0 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>();
#endif
}

} // namespace gg
