// A class through the real tool: what is written, what a second run does, what a killed one leaves.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// A folder of uploads, and where their results go.
class Class {
public:
  Class() {
    fs::create_directory(uploads());
    add("student1", tool::Submission::solution());
    tool::Submission broken = tool::Submission::stub();
    broken.write("floor.cpp", "int main( {");
    add("student2", broken);
    tool::Submission dark = tool::Submission::solution();
    dark.replace("tile.frag", "* reflected", "* reflected * 0.3");
    add("student3", dark);
    fs::create_directory(uploads() / "student4"); // handed in nothing
  }
  void add(const std::string& name, const tool::Submission& submission) {
    fs::copy(submission.path(), uploads() / name);
  }
  fs::path uploads() const { return folder_.path() / "uploads"; }
  fs::path out(const std::string& name = "out") const { return folder_.path() / name; }
  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }
  tool::Arguments arguments(const tool::Arguments& more = {}, const std::string& name = "out") {
    tool::Arguments all = {"batch", "mirror", uploads(), "--out", out(name), "--no-diagnosis"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  tool::Ended run(const tool::Arguments& more = {}, const std::string& name = "out") {
    return tool::runTool(arguments(more, name), {}, 300);
  }

private:
  TemporaryFolder folder_;
};

/// A class that was graded at once, for tests that change no upload.
class Batch : public testing::Test {
protected:
  static void SetUpTestSuite() {
    students_ = std::make_unique<Class>();
    const tool::Ended ended = students_->run({"--jobs", "1"}, "whole");
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  }
  static void TearDownTestSuite() { students_.reset(); }
  static Class& shared() { return *students_; }

private:
  static inline std::unique_ptr<Class> students_;
};

/// The rows of a gradebook without quoted cells, by student.
std::map<std::string, std::vector<std::string>> gradebook(const fs::path& out) {
  std::map<std::string, std::vector<std::string>> rows;
  std::istringstream in(tool::read(out / "gradebook.csv"));
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    rows[cells.at(3)] = cells;
  }
  return rows;
}

/// A record without what no two runs have in common.
json record(const fs::path& folder) {
  json kept = json::parse(tool::read(folder / "record.json"));
  kept["row"].erase("seconds");
  return kept;
}

TEST_F(Batch, WritesAFolderAStudentAGradebookAndAPage) {
  Class students;
  const tool::Ended ended = students.run({"--json"});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const json said = json::parse(ended.out);
  EXPECT_EQ(said.at("graded"), 4);
  EXPECT_EQ(said.at("unfinished"), json::array());
  const auto rows = gradebook(students.out());
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows.at("student1").at(9), "110");
  EXPECT_EQ(rows.at("student2").at(9), "0");
  EXPECT_EQ(rows.at("student4").at(9), "0");
  const double dark = std::stod(rows.at("student3").at(9));
  EXPECT_EQ(dark, 90) << "a line that was handed out is spoiled";
  std::map<std::string, std::string> outcomes;
  for (const json& one : said.at("submissions")) outcomes[one.at("student")] = one.at("outcome");
  EXPECT_EQ(outcomes["student1"], "graded");
  EXPECT_EQ(outcomes["student2"], "build_failed");
  EXPECT_EQ(outcomes["student4"], "build_failed");
  for (const char* name : {"student1", "student2", "student3", "student4"}) {
    const auto files = tool::names(students.out() / name);
    for (const char* file :
         {"index.html", "junit.xml", "record.json", "results.json", "student.html"})
      EXPECT_EQ(std::ranges::count(files, file), 1) << name << '/' << file;
  }
  const std::string page = tool::read(students.out() / "index.html");
  EXPECT_THAT(page, HasSubstr("student3/index.html"));
  EXPECT_THAT(tool::read(students.out() / "student4/student.html"), HasSubstr("floor.cpp"));
  EXPECT_EQ(
      tool::names(students.out()),
      (std::vector<std::string>{".ggrade-batch.json", ".ggrade-lock", "gradebook.csv", "index.html",
                                "student1", "student2", "student3", "student4"}));

  // The same as `grade` says.
  const tool::Graded alone = tool::gradeByTool(students.uploads() / "student3");
  EXPECT_EQ(alone.score() + alone.bonus(), dark);

  // Nothing to do: nothing is done.
  const json before = record(students.out() / "student3");
  const tool::Ended unclear = students.run();
  EXPECT_EQ(unclear.exitCode, 2);
  EXPECT_THAT(unclear.errors, HasSubstr("holds an earlier run: --resume grades"));
  const tool::Ended resumed = students.run({"--resume"});
  EXPECT_EQ(resumed.exitCode, 0) << resumed.errors;
  EXPECT_THAT(resumed.out, HasSubstr("0 graded, 4 kept from before, 0 not gradable"));
  EXPECT_EQ(record(students.out() / "student3"), before);

  // One upload has changed, for the worse.
  fs::copy_file(students.uploads() / "student3/tile.frag",
                students.uploads() / "student1/tile.frag", fs::copy_options::overwrite_existing);
  const tool::Ended changed = students.run({"--resume"});
  EXPECT_EQ(changed.exitCode, 0) << changed.errors;
  EXPECT_THAT(changed.out, HasSubstr("1 graded, 3 kept from before"));
  EXPECT_THAT(changed.out, HasSubstr("drop: student1 110 -> "));
  EXPECT_THAT(tool::read(students.out() / "index.html"), HasSubstr("Since the last run"));

  // Again, and only one.
  const tool::Ended again = students.run({"--regrade", "--only", "student2"});
  EXPECT_EQ(again.exitCode, 0) << again.errors;
  EXPECT_THAT(again.out, HasSubstr("1 graded, 0 kept from before"));
  const tool::Ended nobody = students.run({"--resume", "--only", "student9"});
  EXPECT_EQ(nobody.exitCode, 2);
  EXPECT_THAT(nobody.errors, HasSubstr("--only: no upload is student9's"));
  EXPECT_THAT(
      students.run({"--resume", "--seed", "5"}).errors,
      HasSubstr(
          "was graded with the assignment's own seed and --quality balanced: give the same, or"));
  EXPECT_THAT(students.run({"--resume", "--quality", "fast"}).errors,
              HasSubstr("--quality balanced: give the same"));
}

TEST_F(Batch, AnotherLanguageIsToldAnew) {
  Class students;
  ASSERT_EQ(students.run({"--only", "student4"}).exitCode, 0);
  EXPECT_THAT(students.run({"--resume", "--only", "student4"}).out, HasSubstr("0 graded, 1 kept"));
  const tool::Ended other = students.run({"--resume", "--only", "student4", "--lang", "ja"});
  EXPECT_THAT(other.out, HasSubstr("1 graded, 0 kept")) << other.errors;
  EXPECT_THAT(tool::read(students.out() / "student4/student.html"),
              HasSubstr("<html lang=\"ja\">"));
}

TEST_F(Batch, WhatIsKilledGoesOnAndEndsTheSame) {
  Class& students = shared();
  for (const double seconds : {0.3, 2.5, 5.0}) {
    tool::Arguments arguments = students.arguments({"--jobs", "1"}, "killed");
    if (fs::exists(students.out("killed") / ".ggrade-batch.json")) arguments.push_back("--resume");
    tool::Running running(tool::words(arguments));
    running.says("nobody says this", seconds);
    kill(running.pid(), SIGKILL); // the parent alone, as the kernel does it
    const tool::Ended ended = running.wait(10);
    EXPECT_TRUE(ended.signal == SIGKILL || ended.exitCode == 0) << ended.errors;
  }
  const tool::Ended ended = students.run({"--resume", "--jobs", "1"}, "killed");
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_EQ(tool::read(students.out("killed") / "gradebook.csv"),
            tool::read(students.out("whole") / "gradebook.csv"));
  EXPECT_EQ(tool::names(students.out("killed")), tool::names(students.out("whole")));
  for (const char* name : {"student1", "student2", "student3", "student4"})
    EXPECT_EQ(record(students.out("killed") / name), record(students.out("whole") / name)) << name;
  const json state = json::parse(tool::read(students.out("killed") / ".ggrade-batch.json"));
  EXPECT_EQ(state.at("finished"), true);
  EXPECT_EQ(state.at("work"), "");
}

TEST_F(Batch, CtrlCKeepsWhatIsDone) {
  Class& students = shared();
  tool::Running running(tool::words(students.arguments({"--jobs", "1"})));
  ASSERT_TRUE(running.says("1/4 student1: graded", 100));
  running.signalGroup(SIGINT);
  const tool::Ended ended = running.wait(20);
  EXPECT_EQ(ended.exitCode, 130) << ended.errors;
  EXPECT_TRUE(fs::exists(students.out() / "student1/record.json"));
  for (const std::string& name : tool::names(students.out()))
    EXPECT_THAT(name, testing::AnyOf("student1", "student2", ".ggrade-batch.json", ".ggrade-lock"));
  const tool::Ended resumed = students.run({"--resume"});
  EXPECT_EQ(resumed.exitCode, 0);
  EXPECT_THAT(resumed.out, Not(HasSubstr("4 graded")));
}

TEST_F(Batch, SharesOfTwoMachinesAreJoined) {
  Class& students = shared();
  ASSERT_EQ(students.run({"--shard", "1/2"}, "one").exitCode, 0);
  ASSERT_EQ(students.run({"--shard", "2/2"}, "two").exitCode, 0);
  EXPECT_EQ(gradebook(students.out("one")).size(), 3U);
  const tool::Ended merged = tool::runTool(
      {"merge", students.out("one"), students.out("two"), "--out", students.out("joined")});
  ASSERT_EQ(merged.exitCode, 0) << merged.errors;
  EXPECT_EQ(tool::read(students.out("joined") / "gradebook.csv"),
            tool::read(students.out("whole") / "gradebook.csv"));
  EXPECT_TRUE(fs::exists(students.out("joined") / "student3/student.html"));
  EXPECT_THAT(merged.out, Not(HasSubstr("unlike machines")));

  // A share of another machine. The same student, with another result.
  json kept = json::parse(tool::read(students.out("two") / "student2/record.json"));
  kept["row"]["score"] = 55;
  kept["machine"] = "AuthenticAMD Some Processor, llvmpipe";
  kept["row"]["folder"] = "student1";
  fs::create_directory(students.out("two") / "student1");
  std::ofstream(students.out("two") / "student1/record.json") << kept;
  const tool::Ended conflict = tool::runTool(
      {"merge", students.out("one"), students.out("two"), "--out", students.out("other")});
  EXPECT_EQ(conflict.exitCode, 1);
  EXPECT_THAT(conflict.out, testing::ContainsRegex("drawn on unlike machines: .*llvmpipe \\(LLVM"));
  EXPECT_THAT(conflict.out, HasSubstr("AuthenticAMD Some Processor, llvmpipe"));
  EXPECT_THAT(conflict.out, HasSubstr("110 in "));
  EXPECT_THAT(conflict.out, HasSubstr("55 in "));
  EXPECT_EQ(gradebook(students.out("other")).at("student1").at(9), "110");

  // Half a record is nobody's: its student is named, and the others are there.
  std::ofstream(students.out("two") / "student2/record.json") << kept.dump().substr(0, 40);
  const tool::Ended damaged = tool::runTool(
      {"merge", students.out("one"), students.out("two"), "--out", students.out("fourth")});
  EXPECT_EQ(damaged.exitCode, 1);
  EXPECT_THAT(damaged.out, HasSubstr("student2 is missing here: its record in "));
  EXPECT_EQ(gradebook(students.out("fourth")).count("student2"), 0U);
  EXPECT_EQ(gradebook(students.out("fourth")).count("student3"), 1U);

  EXPECT_THAT(tool::runTool({"merge", students.uploads(), "--out", students.out("third")}).errors,
              HasSubstr("holds no graded class"));
}

TEST_F(Batch, InstructorsDecisionsSurviveAndAlterNoMachineScore) {
  Class students;
  for (const char* name : {"student2", "student4"}) fs::remove_all(students.uploads() / name);
  fs::rename(students.uploads() / "student1",
             students.uploads() / "Student One_1_assignsubmission_file_");
  fs::rename(students.uploads() / "student3",
             students.uploads() / "学生三_3_assignsubmission_file_");
  const fs::path overrides = students.file(
      "decided.csv", "student,item,points,reason,who\n3,,77,<b>Oral</b> exam,Teacher\n"
                     "9,,5,gone,Teacher\n");
  const fs::path submitted = students.file(
      "times.csv", "student,submitted\n1,2026-11-21T12:00+09:00\n3,2026-11-22T12:00+09:00\n");
  const std::string before = "\xEF\xBB\xBFIdentifier,\"Full name\",Grade,\"Maximum Grade\",\"Grade "
                             "can be changed\",\"Feedback comments\"\r\nParticipant 1,\"A, B\",";
  const std::string between = ",50.00,Yes,";
  const std::string after = "\r\nParticipant 7,\"C\",,50.00,Yes,\r\n";
  const fs::path moodle = students.file("sheet.csv", before + between + after);
  const tool::Arguments more = {"--overrides", overrides,
                                "--submitted", submitted,
                                "--due",       "2026-11-20T23:59+09:00",
                                "--late",      "10% per day, at most 50%",
                                "--gradebook", "moodle=" + moodle.string()};
  const tool::Ended ended = students.run(more);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const auto rows = gradebook(students.out());
  ASSERT_EQ(rows.size(), 3U);
  const double machine = std::stod(rows.at("1").at(7));
  EXPECT_GE(machine, 100);
  EXPECT_EQ(rows.at("1").at(8), "10");
  EXPECT_EQ(std::stod(rows.at("1").at(9)), machine - 10);
  // A total that a person has given is the last word, lateness or not.
  EXPECT_EQ(rows.at("3").at(8), "0");
  EXPECT_EQ(rows.at("3").at(9), "77");
  const fs::path folder = students.out() / "学生三_3";
  EXPECT_EQ(record(folder).at("row").at("score"), 90);
  EXPECT_EQ(json::parse(tool::read(folder / "results.json")).at("extra_data").at("max_score"), 100);
  EXPECT_THAT(tool::read(folder / "student.html"), HasSubstr("&lt;b&gt;Oral&lt;/b&gt; exam"));
  EXPECT_THAT(tool::read(students.out() / "Student_One_1/student.html"),
              HasSubstr("Handed in late: 10 points off"));
  EXPECT_THAT(ended.out, HasSubstr("decided.csv:3"));
  EXPECT_THAT(ended.out, HasSubstr("Participant 7"));

  const std::string filled = tool::read(students.out() / "moodle.csv");
  ASSERT_TRUE(filled.starts_with(before)) << filled;
  ASSERT_TRUE(filled.ends_with(after)) << filled;
  EXPECT_THAT(filled, HasSubstr(between));

  tool::Arguments again = more;
  again.push_back("--regrade");
  ASSERT_EQ(students.run(again).exitCode, 0);
  EXPECT_EQ(gradebook(students.out()), rows);
  EXPECT_THAT(tool::read(folder / "student.html"), HasSubstr("&lt;b&gt;Oral&lt;/b&gt; exam"));
}

/// Uploads of nothing, which are graded in no time.
void handInNothing(const Class& students, const std::vector<std::string>& names) {
  for (const char* name : {"student1", "student2", "student3", "student4"})
    fs::remove_all(students.uploads() / name);
  for (const std::string& name : names) fs::create_directory(students.uploads() / name);
}

TEST_F(Batch, WhoLooksLikeAnotherGetsNoGradeAndNeedsAPerson) {
  Class students;
  handInNothing(students, {"ada", " ada", "ada\u200B", "\u0430da", "ben"});
  const std::string sheet = "Identifier,Grade,Maximum grade\nada,7,100\nben,,100\n";
  const fs::path moodle = students.file("sheet.csv", sheet);
  const tool::Arguments more = {"--gradebook", "moodle=" + moodle.string()};
  const tool::Ended ended = students.run(more);
  EXPECT_EQ(ended.exitCode, 1) << ended.errors;
  EXPECT_THAT(ended.out, HasSubstr("line 2, ada: 4 uploads claim this row, no grade is written: "));
  EXPECT_THAT(ended.out, HasSubstr("NEEDS A PERSON \"ada\\u{200B}\": Looks like "));
  EXPECT_THAT(ended.out,
              HasSubstr("0 not gradable, 4 look alike and have no grade: mend the cause"));
  EXPECT_EQ(tool::read(students.out() / "moodle.csv"),
            "Identifier,Grade,Maximum grade\nada,7,100\nben,0,100\n");
  const auto rows = gradebook(students.out());
  EXPECT_EQ(rows.size(), 2U) << "the header and ben";
  EXPECT_EQ(rows.count("ben"), 1U);
  const std::string page = tool::read(students.out() / "index.html");
  EXPECT_THAT(page, HasSubstr("<h2>4 of 5 students need a person</h2>"));
  for (const char* shown : {"&quot;ada&quot;", "&quot;␣ada&quot;", "&quot;ada\\u{200B}&quot;",
                            "&quot;\\u{430}da&quot;"})
    EXPECT_THAT(page, HasSubstr(std::string("<span class=\"chip none\">looks like 3 others</span>"
                                            "<span class=\"student\">found as ") +
                                shown));

  const json said = json::parse(students.run({"--resume", "--json"}).out);
  EXPECT_EQ(said.at("needs_person").size(), 4U);
  EXPECT_THAT(said.at("protections").at("sandbox"), testing::StartsWith("bubblewrap "));
  EXPECT_THAT(said.at("protections").at("self-test"), HasSubstr("16 escapes were tried"));
  EXPECT_EQ(said.at("without_sandbox"), 0);

  // One is left, and what the others had is gone.
  for (const char* name : {" ada", "ada\u200B", "\u0430da"})
    fs::remove_all(students.uploads() / name);
  for (const json& one : said.at("submissions"))
    if (one.at("student") != "ben")
      fs::remove_all(students.out() / one.at("folder").get<std::string>());
  tool::Arguments again = more;
  again.push_back("--resume");
  const tool::Ended mended = students.run(again);
  EXPECT_EQ(mended.exitCode, 0) << mended.out;
  EXPECT_THAT(tool::read(students.out() / "moodle.csv"), HasSubstr("ada,0,100\nben,0,100\n"));
  EXPECT_THAT(tool::read(students.out() / "index.html"), HasSubstr("Nobody needs a person"));
}

TEST_F(Batch, AnArchiveBesideAFolderOfOneStudentIsNotChosen) {
  Class students;
  handInNothing(students, {"ada"});
  std::ofstream(students.uploads() / "ada.zip") << "no archive";
  const tool::Ended ended = students.run();
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.out, HasSubstr("NEEDS A PERSON \"ada.zip\": Looks like \"ada\""));
  EXPECT_EQ(gradebook(students.out()).size(), 1U) << "the header alone";
  EXPECT_THAT(tool::read(students.out() / "index.html"),
              HasSubstr("<li>&quot;ada.zip&quot;: ada.zip can&apos;t be read as a zip or tar"));
}

TEST_F(Batch, OverridesBeyondWhatCanBeGivenCountAndAreMarked) {
  Class students;
  handInNothing(students, {"ada", "ben"});
  fs::create_symlink("/etc/passwd", students.uploads() / "cem");
  const fs::path overrides = students.file(
      "decided.csv", "student,item,points,reason,who\nada,mirror.keep_state,50,kept,kim\n"
                     "ben,,160,extra work,kim\n");
  const tool::Ended ended = students.run({"--overrides", overrides});
  EXPECT_EQ(ended.exitCode, 0) << "the instructor's word counts\n" << ended.errors;
  EXPECT_THAT(ended.out, HasSubstr("decided.csv:2: ada: 50 points are more than the 0 that "
                                   "mirror.keep_state can give; they count, as they were given"));
  EXPECT_THAT(ended.out,
              HasSubstr("NEEDS A PERSON ben: Is this override meant? 160 points are more "
                        "than the 110 that all items can give (kim); they count."));
  EXPECT_THAT(ended.out, HasSubstr("refused: cem: a symbolic link is not followed"));
  EXPECT_EQ(gradebook(students.out()).at("ben").at(9), "160");
  const json kept = record(students.out() / "ada");
  EXPECT_EQ(kept.at("adjustments").at(0).at("beyond"),
            "50 points are more than the 0 that mirror.keep_state can give");
  EXPECT_EQ(kept.at("row").at("score"), 0) << "the machine's stays";
  const std::string page = tool::read(students.out() / "index.html");
  EXPECT_THAT(page, HasSubstr("<h2>2 of 2 students need a person</h2>"));
  EXPECT_THAT(page, HasSubstr("<span class=\"beyond\">160 points are more than the 110"));
  EXPECT_THAT(page, HasSubstr("<li>cem: a symbolic link is not followed</li>"));
  // Taken back, no trace is left.
  fs::remove(overrides);
  ASSERT_EQ(students.run({"--resume"}).exitCode, 0);
  EXPECT_FALSE(record(students.out() / "ada").contains("adjustments"));
}

TEST_F(Batch, BadInputIsNamedBeforeAnythingIsGraded) {
  Class students;
  const auto error = [&](const tool::Arguments& more) {
    const tool::Ended ended = students.run(more);
    EXPECT_EQ(ended.exitCode, 2) << ended.errors;
    EXPECT_FALSE(fs::exists(students.out() / "student1"));
    return ended.errors;
  };
  EXPECT_THAT(error({"--shard", "3/2"}), HasSubstr("--shard 3/2: write i/n with i from 1 to n"));
  EXPECT_THAT(error({"--gradebook", "excel=x.csv"}),
              HasSubstr("--gradebook excel=x.csv: write moodle=FILE or canvas=FILE"));
  EXPECT_THAT(error({"--late", "10% per day"}),
              HasSubstr("lateness needs all of --submitted FILE, --due TIME and --late RULE"));
  const fs::path canvas =
      students.file("canvas.csv", "Student,ID,Other (1)\n    Points Possible,,10\n");
  EXPECT_THAT(error({"--gradebook", "canvas=" + canvas.string()}),
              HasSubstr("no columns are called \"Mirror reflection"));
  EXPECT_THAT(error({"--overrides", students.file("o.csv", "student,points\n")}),
              HasSubstr("o.csv"));
  EXPECT_THAT(error({"--reveal", "all"}), HasSubstr("--reveal"));
  EXPECT_THAT(error({"--seed", "-1"}), HasSubstr("--seed: -1 is not a whole number from 0"));
  EXPECT_THAT(tool::runTool({"batch", "mirror", "/nowhere", "--out", students.out()}).errors,
              HasSubstr("/nowhere: there is no such folder or archive"));
  std::ofstream(students.file("notes", "x"));
  const tool::Ended foreign = tool::runTool(
      {"batch", "mirror", students.uploads(), "--out", students.uploads().parent_path()});
  EXPECT_EQ(foreign.exitCode, 2);
  EXPECT_THAT(foreign.errors, HasSubstr("which is no earlier result of this tool"));
}

TEST_F(Batch, WithoutASandboxEveryResultSaysSo) {
  Class students;
  for (const char* name : {"student2", "student3", "student4"})
    fs::remove_all(students.uploads() / name);
  const tool::Ended ended = students.run({"--sandbox", "none"});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.errors, HasSubstr("no sandbox: every submission runs as you"));
  const json results = json::parse(tool::read(students.out() / "student1/results.json"));
  EXPECT_EQ(results.at("extra_data").at("sandbox"), "none");
  EXPECT_EQ(results.at("score"), 110) << "100 and the bonus";
  EXPECT_EQ(record(students.out() / "student1").at("sandbox"), "none");
  const std::string page = tool::read(students.out() / "index.html");
  EXPECT_THAT(page, HasSubstr("<h2>No sandbox: every program ran as the user who graded"));
  EXPECT_THAT(page, Not(HasSubstr("bubblewrap")));
}

} // namespace
