#include "batch/job.hpp"

#include "grading/references.hpp"
#include "intake/files.hpp"
#include "intake/limits.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <system_error>

#include <sys/stat.h>

namespace ggrade::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What one file or folder holds, as text that is another one where it holds anything else.
/// `entries` and `bytes` are what may still be read.
class Content {
public:
  std::string of(const fs::path& path) {
    struct stat status {};
    if (lstat(path.c_str(), &status) != 0) return "gone\n";
    if (S_ISREG(status.st_mode)) return ofFile(path, std::uint64_t(status.st_size));
    if (!S_ISDIR(status.st_mode)) return "no file\n";
    std::vector<fs::path> inside;
    std::error_code error;
    for (fs::directory_iterator entry(path, error), end; !error && entries_ > 0 && entry != end;
         entry.increment(error)) {
      inside.push_back(entry->path());
      --entries_;
    }
    if (error && error != std::errc::permission_denied)
      throw std::system_error(error, "can't read " + path.string());
    std::sort(inside.begin(), inside.end());
    std::string all;
    for (const fs::path& entry : inside) {
      const std::string name = entry.filename().string();
      all += fmt::format("{}:{} {}", name.size(), name, of(entry));
    }
    return fmt::format("folder {}\n{}", inside.size(), all);
  }

private:
  std::string ofFile(const fs::path& path, std::uint64_t size) {
    try {
      const std::string bytes = intake::readRegular(path, std::min(size, bytes_)).bytes;
      bytes_ -= bytes.size();
      return fmt::format("{} {}\n", size, grading::hashOf(bytes));
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::permission_denied) throw;
      return fmt::format("{} unreadable\n", size);
    } catch (const std::exception& error) {
      return fmt::format("{} {}\n", size, error.what()); // nobody will grade it, either
    }
  }

  std::size_t entries_ = 4 * intake::kUploadLimits.entries;
  std::uint64_t bytes_ = 2 * intake::kUploadLimits.archiveBytes;
};

} // namespace

json toJson(const Job& job) {
  json sources = json::array();
  for (const intake::Source& source : job.upload.sources) {
    // A path may be any bytes, JSON is UTF-8: as numbers.
    const std::string path = source.path.string();
    sources.push_back({std::vector<std::uint8_t>(path.begin(), path.end()), source.name});
  }
  return {{"student", job.upload.student},
          {"given", job.upload.given},
          {"name", job.upload.name},
          {"folder", job.upload.folder},
          {"sources", sources},
          {"remarks", job.upload.remarks},
          {"key", job.key}};
}

Job jobFrom(const json& line) {
  Job job;
  line.at("student").get_to(job.upload.student);
  line.at("given").get_to(job.upload.given);
  line.at("name").get_to(job.upload.name);
  line.at("folder").get_to(job.upload.folder);
  for (const json& source : line.at("sources")) {
    const auto path = source.at(0).get<std::vector<std::uint8_t>>();
    job.upload.sources.push_back(
        {fs::path(std::string(path.begin(), path.end())), source.at(1).get<std::string>()});
  }
  line.at("remarks").get_to(job.upload.remarks);
  line.at("key").get_to(job.key);
  return job;
}

json toJson(const Reply& reply) {
  return {{"problem", reply.problem},
          {"outcome", reply.outcome},
          {"score", reply.score},
          {"max_score", reply.maxScore},
          {"seconds", reply.seconds}};
}

Reply replyFrom(const json& line) {
  Reply reply;
  line.at("problem").get_to(reply.problem);
  line.at("outcome").get_to(reply.outcome);
  line.at("score").get_to(reply.score);
  line.at("max_score").get_to(reply.maxScore);
  line.at("seconds").get_to(reply.seconds);
  return reply;
}

namespace {
const std::map<std::string, grading::Runs> kRuns = {{"none", grading::Runs::none},
                                                    {"told", grading::Runs::told},
                                                    {"hidden", grading::Runs::hidden}};
}

json toJson(grading::Runs kind) {
  const auto named =
      std::ranges::find_if(kRuns, [&](const auto& one) { return one.second == kind; });
  return {{"runs", named->first}};
}

grading::Runs runsFrom(const json& line) {
  const auto known = kRuns.find(line.at("runs").get<std::string>());
  if (known == kRuns.end())
    throw json::other_error::create(501, "no kind of runs: " + line.dump(), &line);
  return known->second;
}

std::string keyOf(const intake::Upload& upload) {
  Content content;
  std::string all;
  for (const intake::Source& source : upload.sources)
    all += fmt::format("{}:{} {}", source.name.size(), source.name, content.of(source.path));
  return grading::hashOf(all);
}

std::string graderOf(const Target& target, const fs::path& solutionFolder,
                     const grading::ScenePlan& plan) {
  return grading::hashOf(grading::gradingKey(target, solutionFolder, plan) +
                         std::string(gg::name(gg::language())) +
                         grading::wordsKey(target.assignment, solutionFolder));
}

} // namespace ggrade::batch
