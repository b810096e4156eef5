#pragma once
/// \file
/// The subcommands, one file each. `add...` declares options and what runs when the command is
/// named.

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::cli {

/// Exit codes of the contract.
enum ExitCode : int { kDone = 0, kNotGradable = 1, kUsage = 2, kNoSandbox = 3, kInterrupted = 130 };

/// Set by the command that ran.
extern int exitCode;

/// What stands after `--`, word for word: a program, or GoogleTest's arguments.
extern std::vector<std::string> afterDashes;

std::filesystem::path assignmentsFolder();
std::filesystem::path
solutionFolder(const std::string& assignment); ///< throws UsageError if there is none
/// Ends the command (kNoSandbox) with the remedy unless the sandbox holds. Returns which escapes
/// were tried in vain.
std::vector<std::string> requireSandbox();
/// `--context`: what programs are drawn with. Only who measures or looks may take a graphics card.
void declareContext(CLI::App& app, bool measures = false);
/// Declares `--repair`, see grading::repairs.
void declareRepair(CLI::App& app);
/// "bwrap" (see requireSandbox) or "none": what `--sandbox` says for everything that is run from
/// now on.
std::vector<std::string> chooseSandbox(const std::string& word);

/// What is wrong with the text of a seed, for CLI11, which would take -1; empty: nothing.
std::string notAWholeNumber(const std::string& text);

/// `--quality` of a command that grades.
CLI::Option* declareQuality(CLI::App& app, std::string& quality, const std::string& about);

/// The folder that --out names, without a slash at its end. Throws UsageError with the remedy,
/// before any work is done, unless it can be made or replaced (see grading::requireReplaceable).
std::filesystem::path outputFolder(const std::string& named);

/// Declares one command.
using AddCommand = void (*)(CLI::App&);
/// A program's main: runs the command that is named and says what went wrong. Returns the exit
/// code.
int runCommands(int argc, char** argv, const std::vector<AddCommand>& commands);

// Of `ggrade-look`.
void addList(CLI::App& app);
void addRender(CLI::App& app);
void addInspect(CLI::App& app);

// Of `ggrade`.
void addGrade(CLI::App& app);
void addBatch(CLI::App& app);
void addMerge(CLI::App& app);
void addWorker(CLI::App& app);
void addDemo(CLI::App& app);
void addJudge(CLI::App& app);

// Of `ggrade-author`.
void addCalibrate(CLI::App& app);
void addTradeoff(CLI::App& app);
void addDerive(CLI::App& app);
void addNew(CLI::App& app);
void addRelease(CLI::App& app);
void addExpect(CLI::App& app);

} // namespace ggrade::cli
