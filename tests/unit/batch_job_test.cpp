// What parent and workers say to each other, and what tells one upload from another.

#include "batch/job.hpp"

#include "framework_temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string key(const fs::path& path, const std::string& name = "floor.cpp") {
  intake::Upload upload;
  upload.sources = {{path, name}};
  return batch::keyOf(upload);
}

TEST(BatchJob, SurvivesTheWayToAWorker) {
  batch::Job job;
  job.upload = {"1234",         "学生1", "学生1_1234", {{"/in/\x83\x65.zip", "テ.zip"}},
                {"2 attempts"}, " 学生1"};
  job.key = "abc";
  const std::string line = batch::toJson(job).dump();
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const batch::Job back = batch::jobFrom(nlohmann::json::parse(line));
  EXPECT_EQ(back.upload.student, "1234");
  EXPECT_EQ(back.upload.name, "学生1");
  EXPECT_EQ(back.upload.folder, "学生1_1234");
  ASSERT_EQ(back.upload.sources.size(), 1U);
  EXPECT_EQ(back.upload.sources[0].path.string(), "/in/\x83\x65.zip"); // bytes that aren't UTF-8
  EXPECT_EQ(back.upload.sources[0].name, "テ.zip");
  EXPECT_EQ(back.upload.remarks, std::vector<std::string>{"2 attempts"});
  EXPECT_EQ(back.upload.given, " 学生1");
  EXPECT_EQ(back.key, "abc");
}

TEST(BatchJob, AnswersSurviveTheWayBack) {
  const batch::Reply back = batch::replyFrom(
      nlohmann::json::parse(batch::toJson(batch::Reply{"why", "crash", 12.5, 100, 3}).dump()));
  EXPECT_EQ(back.problem, "why");
  EXPECT_EQ(back.outcome, "crash");
  EXPECT_EQ(back.score, 12.5);
  EXPECT_EQ(back.maxScore, 100);
  EXPECT_EQ(back.seconds, 3);
  EXPECT_THROW(batch::replyFrom(nlohmann::json::parse(R"({"outcome": 3})")),
               nlohmann::json::exception);
}

TEST(BatchKey, IsAnotherForEveryByteNameAndPlace) {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / "a";
  fs::create_directories(a / "sub");
  write(a / "floor.cpp", "one");
  write(a / "sub/more.frag", "two");
  const std::string before = key(a);
  EXPECT_EQ(key(a), before);
  EXPECT_NE(key(a, "other"), before);

  write(a / "floor.cpp", "onE");
  const std::string changed = key(a);
  EXPECT_NE(changed, before);
  write(a / "floor.cpp", "one");
  EXPECT_EQ(key(a), before) << "times and inodes don't count";

  fs::rename(a / "sub/more.frag", a / "more.frag");
  EXPECT_NE(key(a), before);
  fs::rename(a / "more.frag", a / "sub/more.frag");
  write(a / "empty", "");
  EXPECT_NE(key(a), before);
}

TEST(BatchKey, ReadsNoLinkAndWaitsOnNoFifo) {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / "a", secret = folder.path() / "secret";
  fs::create_directory(a);
  write(secret, "one");
  fs::create_symlink(secret, a / "floor.cpp");
  ASSERT_EQ(mkfifo((a / "mirror.frag").c_str(), 0600), 0);
  const std::string before = key(a);
  write(secret, "other");
  EXPECT_EQ(key(a), before);
  EXPECT_EQ(key(folder.path() / "gone"), key(folder.path() / "nowhere"));
}

TEST(BatchKey, ReadsOnlySoMuch) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "large.zip";
  write(file, "PK");
  fs::resize_file(file, 8ULL << 30); // sparse
  const std::string before = key(file);
  fs::resize_file(file, (8ULL << 30) + 1);
  EXPECT_NE(key(file), before);
}

} // namespace
