/// \file
/// The command line of `ggrade compare`.

#include "cli/compare.hpp"
#include "cli/help.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using gg::say;
using ggrade::cli::CompareArguments;
using ggrade::cli::CompareExit;

std::string explanation() {
  return say(
      "Exit codes\n"
      "  0  the same within the limits    3  sizes or channels differ\n"
      "  1  beyond the warning's limits   4  a file or the command line is wrong\n"
      "  2  beyond the limits, or NaN or Inf in either image\n"
      "The verdict follows idiff's limits: without --fail any difference above 1e-06 fails.\n"
      "idiff's spelling with one hyphen (-fail 0.01) works too.\n"
      "\n"
      "How grades compare\n"
      "  Pixel by pixel numbers punish an edge that moved by a pixel and hide a small thing that "
      "is\n"
      "  missing. So a grade asks of every pixel whether its value lies inside the range of the "
      "other\n"
      "  image's values within R pixels, widened by T, in both directions. Published tolerances:\n"
      "  R = 1 pixel, T = 3.5/255 (three steps of 8 bits pass, four do not). Alpha is not judged.\n"
      "  Errors are counted over the image and in the densest window of 32x32 pixels.\n"
      "  Points depend on these numbers only. The mean and RMS errors, SSIM and FLIP cost none: a "
      "small\n"
      "  thing that is missing hardly moves them, an edge that moved by a pixel does.\n"
      "\n"
      "FLIP (--flip)\n"
      "  How visible the differences are to somebody who flips between the pictures: 0 no "
      "difference, 1 as\n"
      "  large as can be (Andersson et al. 2020). Files of floats (.exr) count as linear light and "
      "are\n"
      "  looked at in several exposures (HDR-FLIP, 2021), all others as display values.\n"
      "\n"
      "Examples\n"
      "  ggrade compare mine.png reference.png\n"
      "  ggrade compare -fail 0.016 -failpercent 1 mine.png reference.png\n"
      "  ggrade compare mine.exr reference.exr --abs --scale 10 -o difference.png\n"
      "  ggrade compare mine.png reference.png --flip -o flip.png");
}

// CLI11 reads -fail as -f -a -i -l; idiff's scripts mean --fail.
std::vector<std::string> withDoubleHyphens(int argc, char** argv) {
  constexpr std::array<std::string_view, 16> names{
      "fail", "failpercent", "hardfail", "warn",      "warnpercent", "hardwarn", "out", "scale",
      "abs",  "json",        "radius",   "tolerance", "channels",    "flip",     "ppd", "help"};
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  for (std::string& argument : arguments) {
    if (argument == "--") break;
    if (argument.size() < 3 || argument[0] != '-' || argument[1] == '-') continue;
    const std::string_view name = std::string_view(argument).substr(1);
    if (std::ranges::find(names, name.substr(0, name.find('='))) != names.end())
      argument.insert(0, 1, '-');
  }
  return arguments;
}

// CLI11's own check lets NaN through, which no difference ever exceeds.
const CLI::Validator zeroOrMore(
    [](std::string& text) -> std::string {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && value >= 0) return {};
      return say("'{}' is not a number of 0 or more", text);
    },
    "");

void addOptions(CLI::App& app, CompareArguments& a) {
  const auto limit = [&](const char* name, auto& value, const std::string& text) {
    app.add_option(name, value, text)->check(zeroOrMore)->group(say("Limits (idiff's)"));
  };
  app.add_option("A", a.image, say("image to judge"))->required();
  app.add_option("B", a.reference, say("reference"))->required();
  limit("--fail", a.fail, say("a pixel fails if a channel differs by more (default 1e-06)"));
  limit("--failpercent", a.failPercent, say("percent of the pixels that may fail (default 0)"));
  limit("--hardfail", a.hardFail, say("fail if any pixel differs by more (default: no limit)"));
  limit("--warn", a.warn,
        say("a pixel warns if a channel differs by more (default 1e-06 if any is over --fail)"));
  limit("--warnpercent", a.warnPercent, say("percent of the pixels that may warn (default 0)"));
  limit("--hardwarn", a.hardWarn, say("warn if any pixel differs by more (default: no limit)"));

  const std::string grade = say("The grade's comparison");
  app.add_option("--tolerance", a.tolerant.tolerance, say("T, default 3.5/255 = 0.01373"))
      ->check(zeroOrMore)
      ->group(grade);
  app.add_option("--radius", a.tolerant.radius, say("R in pixels, default 1"))
      ->check(CLI::Range(0, ggrade::kMaxRadius))
      ->group(grade);
  app.add_option("--channels", a.tolerant.channels,
                 say("compare the first N channels (default: all but alpha)"))
      ->check(CLI::Range(1, 4))
      ->group(grade);

  const char* const flip = "FLIP";
  app.add_flag("--flip", a.flip, say("compute FLIP too; --out then writes its heat map"))
      ->group(flip);
  app.add_option(
         "--ppd", a.pixelsPerDegree,
         say("pixels that a degree of sight covers (default 67: 3840 pixels on 0.7 m, seen from "
             "0.7 m)"))
      ->check(CLI::Range(ggrade::kFlipMinPixelsPerDegree, ggrade::kFlipMaxPixelsPerDegree))
      ->group(flip);

  app.add_option("-o,--out", a.out, say("write A - B to this file (.png, .exr, ...), opaque"));
  app.add_option("--scale", a.scale, say("factor on the difference image (default 1)"));
  app.add_flag("--abs", a.absolute, say("difference image of absolute values"));
  app.add_flag("-q", a.quiet, say("print the verdict alone, and only if it isn't PASS"));
  app.add_flag("--json", a.json, say("print one JSON object on stdout"));
}

} // namespace

int main(int argc, char** argv) try {
  CLI::App app(say("Compares two images as idiff does, and as grades do."), "ggrade compare");
  ggrade::cli::sayHelp(app);
  app.footer(explanation());
  CompareArguments arguments;
  addOptions(app, arguments);
  auto given = withDoubleHyphens(argc, argv);
  std::ranges::reverse(given); // CLI11 wants the last argument first
  try {
    app.parse(given);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    std::cerr << "ggrade compare: " << ggrade::cli::sayRefusal(error) << '\n'
              << say("Usage: ggrade compare A B [options]; ggrade compare --help explains them.")
              << '\n';
    return int(CompareExit::fileError);
  }
  return int(ggrade::cli::runCompare(arguments, std::cout, std::cerr));
} catch (const std::exception& error) {
  std::cerr << "ggrade compare: " << error.what() << '\n';
  return int(CompareExit::fileError);
}
