#pragma once
/// \file
/// The judge: a trusted process that knows the scenes of one plan, forks for every submission that
/// it is asked about, and runs the rubric there, so that a crash keeps what was judged before.

#include "assignment/assignment.hpp"
#include "grading/workspace.hpp"
#include "image/compare.hpp"
#include "rubric/evidence.hpp"

#include <mutex>

#include <sys/types.h>

namespace ggrade::grading {

/// The heading of the handout's step about a TODO, as results name it; empty: the part has no such
/// TODO.
std::string stepHeading(const Part& part, const std::string& todo);

/// An item as declared, with nothing earned yet.
results::Item unjudgedItem(const ItemDeclaration& declared);

/// Items of which only these scenes are known, see results::creditOf. What none of them shows
/// is given, for nobody saw it wrong.
void keepScenes(std::vector<results::Item>& items, const std::vector<std::string>& scenes);

/// The program whose command `judge` is the judge, whichever program asks for it.
std::filesystem::path judgeProgram();

/// May be asked by several threads.
class Judge {
public:
  /// `many`: what depends on the reference alone is worked out before the first submission comes.
  /// Throws std::runtime_error where it can't be started.
  /// \param tolerances null: the published ones
  Judge(const Target& target, std::vector<rubric::SceneFolders> scenes, bool many,
        const Tolerances* tolerances = nullptr);
  ~Judge();
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  struct Request {
    /// The folders of what a submission drew, by scene; empty where it drew nothing. Where the last
    /// ones are left out, the items are those of the scenes before, see keepScenes.
    std::vector<std::filesystem::path> students;
    std::vector<std::string> arguments{}; ///< GoogleTest's
    std::vector<std::string> again{};     ///< see rubric::Evidence
  };
  /// `work` is for the answer's files. An item that was never reached stays unjudged, and `problem`
  /// says why. Throws Interrupted.
  std::vector<results::Item> judge(const Request& request, const std::filesystem::path& work,
                                   std::string& problem);

  /// More requests are to come: what depends on the reference alone is worked out before the next,
  /// unless that was done.
  void warm();

private:
  /// Why it is gone, or "".
  std::string gone();
  /// One line. Was it taken?
  bool send(const nlohmann::json& request);
  /// Ends it and all that it has forked.
  void stop();

  const Target& target_;
  const std::vector<rubric::SceneFolders> scenes_;
  TemporaryFolder folder_;
  std::mutex mutex_;
  pid_t pid_ = 0;
  int requests_ = -1;
  unsigned asked_ = 0;
  bool warm_ = false;
  std::string end_;
};

} // namespace ggrade::grading
