// `main` of every student's program: arguments, scene, and the exception boundary.

#include <cstdio>
#include <filesystem>

#include "arguments.hpp"
#include "live.hpp"
#include "parts.hpp"
#include "words/words.hpp"
#include <gg/app.hpp>
#include <gg/error.hpp>
#include <gg/exit_code.hpp>
#include <gg/platform.hpp>
#include <gg/scene.hpp>
#include <gg/text_file.hpp>

namespace {

using gg::ExitCode;

// On the command line, names start at the current directory; elsewhere, at the program's folder.
std::string meshFromHere(const std::string& name) {
  const std::filesystem::path file = gg::fromUtf8(name);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return name;
  return gg::toUtf8(std::filesystem::absolute(file));
}

void run(const gg::detail::Arguments& arguments) {
  const std::filesystem::path folder = gg::programFolder();
  const auto declared = gg::Declarations::fromFile(gg::toUtf8(folder / "assignment.json"));
  // Read as it stands first: a fault is reported with its line.
  gg::Scene scene = gg::Scene::fromFile(
      arguments.scene ? *arguments.scene : gg::toUtf8(folder / "scene.json"), declared);
  if (!arguments.scene)
    scene = gg::Scene::fromText(gg::detail::sceneOfPart(folder, arguments.part.value_or("")),
                                "scene.json", declared);
  if (arguments.size) scene.size = *arguments.size;
  if (arguments.mesh) {
    if (!scene.has("mesh"))
      throw gg::detail::UsageError(gg::say("--mesh: this assignment has no mesh to choose"));
    scene.setText("mesh", meshFromHere(*arguments.mesh));
  }
  app(scene);
}

int report(const std::string& name, const char* what, ExitCode code) {
  std::fprintf(stderr, "%s: %s\n", name.c_str(), what);
  return static_cast<int>(code);
}

} // namespace

int main(int argc, char** argv) {
  std::string name = "program";
  gg::prepareTerminal();
  try {
    if (argc > 0) name = gg::toUtf8(std::filesystem::path(argv[0]).stem());
    const gg::detail::Arguments arguments =
        gg::detail::parseArguments(gg::utf8Arguments(argc, argv));
    if (arguments.help) {
      std::fputs(gg::detail::usage(name).c_str(), stdout);
      return static_cast<int>(ExitCode::ok);
    }
    run(arguments);
    return static_cast<int>(ExitCode::ok);
  } catch (const gg::detail::UsageError& error) {
    report(name, error.what(), ExitCode::usage);
    std::fputs(gg::detail::usage(name).c_str(), stderr);
    return static_cast<int>(ExitCode::usage);
  } catch (const gg::SceneError& error) {
    return report(name, error.what(), ExitCode::scene);
  } catch (const gg::ShaderError& error) {
    return report(name, error.what(), ExitCode::shader);
  } catch (const gg::WindowError& error) {
    return report(name, error.what(), ExitCode::window);
  } catch (const std::exception& error) {
    return report(name, error.what(), ExitCode::exception);
  } catch (...) {
    return report(name, gg::say("an exception of an unknown type").c_str(), ExitCode::exception);
  }
}
