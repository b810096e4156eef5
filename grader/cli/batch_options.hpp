#pragma once
/// \file
/// What `batch` is told on the command line, and what it says while it works.

#include "batch/batch.hpp"
#include "batch/books.hpp"
#include "cli/terminal.hpp"

#include <CLI/CLI.hpp>

#include <chrono>

namespace ggrade::cli {

struct BatchCommand {
  std::string id, out, reveal = "names", sandbox = "bwrap", quality = "balanced", shard;
  std::uint64_t seed = 0;
  bool noDiagnosis = false, json = false;
  batch::BatchOptions how;
  batch::BookOptions books;
};

void declare(CLI::App& app, BatchCommand& command);
/// What follows from the words given. Throws UsageError.
void finish(const CLI::App& app, BatchCommand& command);

/// The options about gradebooks, lateness and overrides, which `merge` has, too.
void declareBooks(CLI::App& app, batch::BookOptions& books);

/// A bar with the time left on a terminal, a line a submission in a log; to stderr.
class ClassProgress {
public:
  explicit ClassProgress(const std::string& title);
  /// What is shown before the first submission.
  Progress& preparing() { return preparing_; }
  void operator()(const batch::Step& step);
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  Progress preparing_;
  bool terminal_, shown_ = false;
  Clock::time_point start_;
  bool started_ = false;
};

} // namespace ggrade::cli
