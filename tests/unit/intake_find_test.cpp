#include "intake_samples.hpp"

#include "assignment/usage_error.hpp"

#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/stat.h>

namespace ggrade::intake {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class FindUploads : public testing::Test {
protected:
  Intake find() const {
    return findUploads(folder.path(), kWanted, folder.path(), sandbox::Isolation::none);
  }
  std::vector<std::string> folders(const Intake& intake) const {
    std::vector<std::string> names;
    for (const Upload& upload : intake.uploads) names.push_back(upload.folder);
    return names;
  }
  /// Sets the time of modification, seconds since 1970.
  void touch(const fs::path& path, std::int64_t seconds) const {
    const timespec times[2] = {{0, UTIME_OMIT}, {seconds, 0}};
    ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  }

  TemporaryFolder folder;
};

using FindPlain = FindUploads;
using FindMoodle = FindUploads;
using FindCanvas = FindUploads;

TEST_F(FindPlain, EveryEntryIsAStudent) {
  folder.write("student1/floor.cpp", "");
  folder.write("student2.tar.gz", "");
  folder.write("student3.cpp", "");
  const Intake intake = find();
  EXPECT_EQ(intake.layout, Layout::plain);
  ASSERT_THAT(folders(intake), ElementsAre("student1", "student2", "student3"));
  EXPECT_EQ(intake.uploads[1].student, "student2");
  EXPECT_EQ(intake.uploads[1].name, "student2");
  EXPECT_EQ(intake.uploads[1].sources[0].path, folder.path() / "student2.tar.gz");
  EXPECT_EQ(intake.uploads[2].sources[0].name, "student3.cpp");
  EXPECT_THAT(intake.remarks, IsEmpty());
}

TEST_F(FindPlain, DoesNotGuessAttempts) {
  folder.write("ada-1.zip", "");
  folder.write("ada-2.zip", "");
  EXPECT_THAT(folders(find()), ElementsAre("ada-1", "ada-2"));
}

TEST_F(FindPlain, KeepsUploadsOfOneNameApart) {
  folder.write("ada.zip", "");
  folder.write("ada/floor.cpp", "");
  const Intake intake = find();
  EXPECT_THAT(folders(intake), ElementsAre("ada", "ada_zip"));
  for (const Upload& upload : intake.uploads) EXPECT_EQ(upload.student, "ada") << "not ours to say";
  EXPECT_EQ(intake.uploads[0].name, "ada");
  EXPECT_EQ(intake.uploads[1].name, "ada.zip");
  EXPECT_THAT(intake.remarks,
              ElementsAre("ada.zip: graded under its whole name, since 2 uploads are called ada",
                          "ada: graded under its whole name, since 2 uploads are called ada"));
}

TEST_F(FindPlain, KeepsWhatCannotBeSeenInANameBesideWhatIsShown) {
  folder.write(" ada/floor.cpp", "");
  folder.write("ada\u200B/floor.cpp", "");
  folder.write("ada\u202E/floor.cpp", "");
  const Intake intake = find();
  std::vector<std::string> given, students;
  for (const Upload& upload : intake.uploads) {
    given.push_back(upload.given);
    students.push_back(upload.student);
  }
  EXPECT_THAT(given, testing::UnorderedElementsAre(" ada", "ada\u200B", "ada\u202E"));
  EXPECT_THAT(students, testing::UnorderedElementsAre("ada", "ada\u200B", "ada"));
}

TEST_F(FindPlain, FoldersAreUniqueAlsoWhereCaseIsIgnored) {
  folder.write("Ada/x", "");
  folder.write("ada/x", "");
  folder.write("ADA!/x", "");
  const Intake intake = find();
  EXPECT_THAT(folders(intake), ElementsAre("ADA", "Ada-2", "ada-3"));
  EXPECT_EQ(intake.uploads[2].student, "ada");
}

TEST_F(FindPlain, NamesComeOutAsNfc) {
  folder.write("学生か\u3099/floor.cpp", "");
  const Intake intake = find();
  EXPECT_EQ(intake.uploads.at(0).student, "学生\u304C");
  EXPECT_EQ(intake.uploads.at(0).name, "学生\u304C");
  EXPECT_EQ(intake.uploads.at(0).folder, "学生\u304C");
}

TEST_F(FindPlain, NamesOfJapaneseWindowsAreDecoded) {
  folder.write("\x8A\x77\x90\xB6"
               "1/floor.cpp",
               "");
  folder.write("Jos\xE9/floor.cpp", "");
  const Intake intake = find();
  ASSERT_THAT(folders(intake), ElementsAre("Jos_xE9", "学生1"));
  EXPECT_EQ(intake.uploads[0].name, "Jos\\xE9");
  EXPECT_EQ(intake.uploads[1].student, "学生1");
  EXPECT_TRUE(fs::exists(intake.uploads[1].sources[0].path)) << "the path keeps its bytes";
}

TEST_F(FindPlain, SaysWhatItPassesOver) {
  folder.write("student1/floor.cpp", "");
  folder.write(".DS_Store", "");
  folder.write("__MACOSX/x", "");
  fs::create_symlink("/etc/passwd", folder.path() / "student2");
  fs::create_directory_symlink("/etc", folder.path() / "student3");
  ASSERT_EQ(mkfifo((folder.path() / "student4").c_str(), 0600), 0);
  const Intake intake = find();
  EXPECT_THAT(folders(intake), ElementsAre("student1"));
  EXPECT_THAT(intake.remarks, ElementsAre(".DS_Store: passed over, no student's",
                                          "__MACOSX: passed over, no student's"));
  EXPECT_THAT(intake.refused, ElementsAre("student2: a symbolic link is not followed",
                                          "student3: a symbolic link is not followed",
                                          "student4: neither a file nor a folder"));
}

TEST_F(FindPlain, AsksForAnotherFolderWhereThereIsNothing) {
  const std::string path = folder.path().string();
  EXPECT_THAT([&] { find(); }, testing::ThrowsMessage<UsageError>(
                                   HasSubstr(path + " holds no upload: name the folder with")));
  const auto findIn = [&](const fs::path& source) {
    findUploads(source, kWanted, folder.path(), sandbox::Isolation::none);
  };
  EXPECT_THAT([&] { findIn(path + "/none"); },
              testing::ThrowsMessage<UsageError>("there is no " + path +
                                                 "/none: name the folder or archive of uploads"));
  folder.write("list.txt", "");
  EXPECT_THAT([&] { findIn(path + "/list.txt"); },
              testing::ThrowsMessage<UsageError>(
                  HasSubstr("list.txt is neither a folder nor a zip or tar file: name")));
}

TEST_F(FindMoodle, ReadsFoldersInBothSpellings) {
  folder.write("Hanako Yamada_101_assignsubmission_file_/floor.cpp", "");
  folder.write("学生 二_102_assignsubmission_file/homework.zip", "");
  folder.write("A B_103_assignsubmission_onlinetext_/onlinetext.html", "");
  folder.write("readme.txt", "");
  const Intake intake = find();
  EXPECT_EQ(intake.layout, Layout::moodle);
  // Nobody is left out: neither who handed in no file, nor who has another name.
  ASSERT_THAT(folders(intake),
              ElementsAre("A_B_103", "Hanako_Yamada_101", "readme", "学生_二_102"));
  EXPECT_THAT(intake.uploads[0].sources, IsEmpty());
  EXPECT_EQ(intake.uploads[1].student, "101");
  EXPECT_EQ(intake.uploads[1].name, "Hanako Yamada");
  EXPECT_EQ(intake.uploads[2].student, "readme");
  EXPECT_EQ(intake.uploads[3].name, "学生 二");
  EXPECT_THAT(intake.refused,
              ElementsAre("A B_103_assignsubmission_onlinetext_: online text, not a file"));
  EXPECT_THAT(intake.remarks,
              ElementsAre("readme.txt: not a name of Moodle's, graded under its own"));
}

/// A student chose it: that must not make the others vanish.
TEST_F(FindMoodle, OneNameOfMoodlesInAPlainFolderIsAName) {
  for (const char* name : {"ada", "ben", "cem", "dot", "eve", "fay"})
    folder.write(std::string(name) + "/floor.cpp", "");
  folder.write("x_1_assignsubmission_file_/floor.cpp", "");
  const Intake intake = find();
  EXPECT_EQ(intake.layout, Layout::plain);
  EXPECT_THAT(folders(intake),
              ElementsAre("ada", "ben", "cem", "dot", "eve", "fay", "x_1_assignsubmission_file"));
}

TEST_F(FindMoodle, FilesWithoutFoldersAreOneAttempt) {
  folder.write("A B_101_assignsubmission_file_floor.cpp", "");
  folder.write("A B_101_assignsubmission_file_mirror.vert", "");
  const Intake intake = find();
  ASSERT_EQ(intake.uploads.size(), 1u);
  ASSERT_EQ(intake.uploads[0].sources.size(), 2u);
  EXPECT_EQ(intake.uploads[0].sources[0].name, "floor.cpp");
  EXPECT_EQ(intake.uploads[0].sources[1].name, "mirror.vert");
  EXPECT_THAT(intake.uploads[0].remarks, IsEmpty());
}

TEST_F(FindMoodle, TheLatestAttemptCounts) {
  touch(folder.write("A B_101_assignsubmission_file/floor.cpp", ""), 1700000000);
  touch(folder.write("A B_101_assignsubmission_file_/floor.cpp", ""), 1700000100);
  touch(folder.write("A B_101_assignsubmission_file_homework.zip", ""), 1600000000);
  const Intake intake = find();
  ASSERT_EQ(intake.uploads.size(), 1u);
  EXPECT_EQ(intake.uploads[0].sources[0].path, folder.path() / "A B_101_assignsubmission_file_");
  EXPECT_THAT(intake.uploads[0].remarks,
              ElementsAre("3 attempts: the one of 2023-11-14T22:15:00Z counts"));
}

TEST_F(FindMoodle, StudentsOfOneNameAreTwo) {
  folder.write("A B_101_assignsubmission_file_/floor.cpp", "");
  folder.write("A B_102_assignsubmission_file_/floor.cpp", "");
  EXPECT_THAT(folders(find()), ElementsAre("A_B_101", "A_B_102"));
}

TEST_F(FindCanvas, GathersAStudentsFiles) {
  folder.write("yamadahanako_5012_80311_floor.cpp", "");
  folder.write("yamadahanako_5012_80312_mirror.vert", "");
  folder.write("学生二_LATE_5013_80313_homework.zip", "");
  folder.write("notes.txt", "");
  const Intake intake = find();
  EXPECT_EQ(intake.layout, Layout::canvas);
  ASSERT_THAT(folders(intake), ElementsAre("notes", "yamadahanako_5012", "学生二_5013"));
  EXPECT_EQ(intake.uploads[1].student, "5012");
  EXPECT_THAT(intake.uploads[1].remarks, Not(Contains("Canvas marks it as late")));
  EXPECT_THAT(intake.uploads[2].remarks, Contains("Canvas marks it as late"));
  ASSERT_EQ(intake.uploads[1].sources.size(), 2u);
  EXPECT_EQ(intake.uploads[1].sources[1].name, "mirror.vert");
  EXPECT_THAT(intake.remarks,
              ElementsAre("notes.txt: not a name of Canvas', graded under its own"));
}

TEST_F(FindCanvas, TheHighestVersionCounts) {
  folder.write("ada_1_10_floor.cpp", "");
  folder.write("ada_1_11_floor-2.cpp", "");
  folder.write("ada_1_12_floor-10.cpp", "");
  folder.write("ada_1_13_homework-1.zip", "");
  const Intake intake = find();
  const std::vector<Source>& sources = intake.uploads.at(0).sources;
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[0].path.filename(), "ada_1_12_floor-10.cpp");
  EXPECT_EQ(sources[0].name, "floor.cpp");
  EXPECT_EQ(sources[1].name, "homework.zip");
  EXPECT_THAT(intake.uploads[0].remarks, ElementsAre("3 versions of floor.cpp: number 10 counts"));
}

TEST_F(FindCanvas, NumbersOfTheStudentsOwnAreNoVersions) {
  folder.write("ada_1_10_blur-1.frag", "");
  folder.write("ada_1_11_blur-2.frag", "");
  EXPECT_EQ(find().uploads.at(0).sources.size(), 2u);
}

TEST_F(FindCanvas, IsNotTakenFromOneFileOfAPlainFolder) {
  folder.write("ada_1_10_floor.cpp", "");
  folder.write("student2/floor.cpp", "");
  folder.write("student3.zip", "");
  EXPECT_EQ(find().layout, Layout::plain);
}

} // namespace
} // namespace ggrade::intake
