// What is kept of one submission comes back as it was; what is damaged counts as missing.

#include "batch/record.hpp"

#include "few_descriptors.hpp"
#include "framework_temporary_folder.hpp"
#include "report_samples.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;

batch::Record sample(const std::string& folder) {
  batch::Record record;
  record.row.folder = folder;
  record.row.student = "1234";
  record.row.name = "学生1";
  record.row.outcome = results::Outcome::glError;
  record.row.headline = "2 items lost points";
  record.row.reason = "why";
  record.row.score = 81.5;
  record.row.bonus = 4;
  record.row.maxScore = 100;
  record.row.items = {{"mirror.shading", "Shading", results::ItemKind::gain, 3, 20, true},
                      {"mirror.keep", "Kept", results::ItemKind::keep, -2, 10, false}};
  record.row.diagnoses = {{"mirror_upside_down", "Turn it."}};
  record.row.remarks = {"2 attempts"};
  record.row.refused = {"../x: leads out of its folder"};
  record.row.given = " 1234";
  record.row.thumbnail = std::string("\x89PNG\0", 5);
  record.row.seconds = 2.5;
  record.target = "mirror";
  record.seed = 18446744073709551615ULL;
  record.upload = "u";
  record.grader = "g";
  record.sandbox = "none";
  record.feedback = "a\nb";
  record.run = 3;
  return record;
}

TEST(BatchRecord, ComesBackAsItWas) {
  const TemporaryFolder out;
  fs::create_directory(out.path() / "s1");
  const batch::Record kept = sample("s1");
  batch::saveRecord(out.path() / "s1", kept);
  const auto back = batch::loadRecord(out.path() / "s1");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->row.student, "1234");
  EXPECT_EQ(back->row.name, "学生1");
  EXPECT_EQ(back->row.outcome, results::Outcome::glError);
  EXPECT_EQ(back->row.headline, kept.row.headline);
  EXPECT_EQ(back->row.reason, "why");
  EXPECT_EQ(back->row.score, 81.5);
  EXPECT_EQ(back->row.bonus, 4);
  EXPECT_EQ(back->row.maxScore, 100);
  ASSERT_EQ(back->row.items.size(), 2U);
  EXPECT_EQ(back->row.items[1].id, "mirror.keep");
  EXPECT_EQ(back->row.items[1].kind, results::ItemKind::keep);
  EXPECT_EQ(back->row.items[1].earned, -2);
  EXPECT_FALSE(back->row.items[1].judged);
  ASSERT_EQ(back->row.diagnoses.size(), 1U);
  EXPECT_EQ(back->row.diagnoses[0].id, "mirror_upside_down");
  EXPECT_EQ(back->row.remarks, kept.row.remarks);
  EXPECT_EQ(back->row.refused, kept.row.refused);
  EXPECT_EQ(back->row.given, " 1234");
  EXPECT_FALSE(back->isAdjusted);
  EXPECT_EQ(back->row.thumbnail, kept.row.thumbnail);
  EXPECT_EQ(back->seed, kept.seed);
  EXPECT_EQ(back->sandbox, "none");
  EXPECT_EQ(back->feedback, "a\nb");
  EXPECT_EQ(back->run, 3U);
}

TEST(BatchRecord, NamesWhatWasDecidedWithoutCountingItAsTheMachines) {
  const TemporaryFolder out;
  fs::create_directory(out.path() / "s1");
  batch::Record decided = sample("s1");
  decided.row.adjustments = {{"mirror.keep", -2, 50, "why", "kim", "50 points are more"}};
  batch::saveRecord(out.path() / "s1", decided);
  const auto back = batch::loadRecord(out.path() / "s1");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->isAdjusted);
  EXPECT_TRUE(back->row.adjustments.empty());
  EXPECT_EQ(back->row.score, 81.5);
  std::stringstream text;
  text << std::ifstream(out.path() / "s1/record.json").rdbuf();
  EXPECT_NE(text.str().find("\"beyond\": \"50 points are more\""), std::string::npos);
}

TEST(BatchRecord, WhatIsDamagedIsGradedAgain) {
  const TemporaryFolder out;
  const fs::path folder = out.path() / "s1";
  fs::create_directory(folder);
  EXPECT_FALSE(batch::loadRecord(folder)) << "none";
  batch::saveRecord(folder, sample("s1"));
  std::stringstream text;
  text << std::ifstream(folder / "record.json").rdbuf();
  for (const std::string& damaged : {std::string(), text.str().substr(0, text.str().size() / 2),
                                     std::string("{}"), std::string("[1, 2]")}) {
    std::ofstream(folder / "record.json") << damaged;
    EXPECT_FALSE(batch::loadRecord(folder)) << damaged;
  }
  batch::saveRecord(folder, sample("s2"));
  EXPECT_FALSE(batch::loadRecord(folder)) << "another student's, copied there";
}

// Else its student would have no row, and nobody would be told.
TEST(BatchRecord, WhatCantBeReadNowIsNeitherDamagedNorMissing) {
  const TemporaryFolder out;
  const fs::path folder = out.path() / "s1";
  fs::create_directory(folder);
  batch::saveRecord(folder, sample("s1"));
  const FewDescriptors few(0);
  try {
    batch::loadRecord(folder);
    FAIL() << "must throw";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.what(),
              "can't read " + (folder / "record.json").string() + ": Too many open files");
  }
}

TEST(BatchRecord, OnlyFoldersOfResultsAreRead) {
  const TemporaryFolder out;
  for (const char* name : {"s2", "s1", ".ggrade-abcdef"}) {
    fs::create_directory(out.path() / name);
    batch::saveRecord(out.path() / name, sample(name));
  }
  fs::create_directory(out.path() / "notes");
  std::ofstream(out.path() / "gradebook.csv") << "x";
  const auto records = batch::loadRecords(out.path());
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].row.folder, "s1");
  EXPECT_EQ(records[1].row.folder, "s2");
}

TEST(BatchRecord, FeedbackSaysOnlyWhatAStudentMayKnow) {
  results::Result result;
  result.part = "mirror";
  result.outcome = results::Outcome::graded;
  result.maxScore = 100;
  result.score = 80;
  results::Item item;
  item.id = "mirror.shading";
  item.title = "Shading";
  item.points = 20;
  item.judged = true;
  item.message = "hidden-3: 31% differs around (212, 340)";
  item.credits = {{"hidden-3", 0.0}};
  item.messages = {"31% differs around (212, 340)"};
  result.items = {item};
  results::Scene scene;
  scene.name = "hidden-3";
  scene.output = "SECRET";
  result.scenes = {scene};
  const batch::Record record = batch::recordOf(result, report::Reveal::names);
  EXPECT_NE(record.feedback.find("Shading"), std::string::npos) << record.feedback;
  EXPECT_EQ(record.feedback.find("212"), std::string::npos) << record.feedback;
  EXPECT_EQ(record.feedback.find("SECRET"), std::string::npos) << record.feedback;
  EXPECT_NE(batch::recordOf(result, report::Reveal::details).feedback.find("212"),
            std::string::npos);
}

} // namespace
