// The archive of a whole class.
#include "intake_fixture.hpp"

#include "assignment/usage_error.hpp"

namespace ggrade::intake {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ClassArchive : public ArchiveUpload {
protected:
  Intake find(const std::string& bytes) {
    return findUploads(folder.write("class.zip", bytes), kWanted, folder.path(), GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(With, ClassArchive,
                         testing::Values(sandbox::Isolation::bwrap, sandbox::Isolation::none),
                         [](const auto& parameter) {
                           return parameter.param == sandbox::Isolation::bwrap ? "bwrap" : "none";
                         });

TEST_P(ClassArchive, OfMoodleIsUnpackedAndItsUploadsToo) {
  const Intake intake = find(
      zipOf({{"学生 一_101_assignsubmission_file_/homework.zip", zipOf({{"hw/floor.cpp", "one"}})},
             {"A B_102_assignsubmission_file_/floor.cpp", "two"},
             {"A B_102_assignsubmission_onlinetext_/onlinetext.html", "<p>"},
             {"__MACOSX/x", ""}}));
  EXPECT_EQ(intake.layout, Layout::moodle);
  ASSERT_EQ(intake.uploads.size(), 2u);
  EXPECT_EQ(intake.uploads[0].folder, "A_B_102");
  EXPECT_EQ(intake.uploads[1].folder, "学生_一_101");
  EXPECT_THAT(intake.refused,
              ElementsAre("A B_102_assignsubmission_onlinetext_: online text, not a file"));
  EXPECT_THAT(intake.remarks, ElementsAre("passed over 1 entry: __MACOSX"));
  EXPECT_EQ(unpack(intake.uploads[1], kWanted, into, GetParam()).problem, "");
  EXPECT_EQ(textOf(into / "floor.cpp"), "one");
}

TEST_P(ClassArchive, KeepsTheTimesThatAttemptsAreToldApartBy) {
  const Intake intake = find(zipOf({{.name = "A B_101_assignsubmission_file_/floor.cpp",
                                     .bytes = "later",
                                     .modified = 1700000060},
                                    {.name = "A B_101_assignsubmission_file/floor.cpp",
                                     .bytes = "earlier",
                                     .modified = 1700000000}}));
  ASSERT_EQ(intake.uploads.size(), 1u);
  EXPECT_THAT(intake.uploads[0].remarks,
              ElementsAre("2 attempts: the one of 2023-11-14T22:14:20Z counts"));
  EXPECT_EQ(textOf(intake.uploads[0].sources[0].path / "floor.cpp"), "later");
}

TEST_P(ClassArchive, StudentsWhoseNamesDifferInCaseAreTwo) {
  EXPECT_EQ(find(zipOf({{"Ada/floor.cpp", ""}, {"ada/floor.cpp", ""}})).uploads.size(), 2u);
}

TEST_P(ClassArchive, LinksInItAreNotMade) {
  const Intake intake = find(zipOf({{"student1/floor.cpp", ""},
                                    {"student2", "/etc", 0, 3, 0120777},
                                    {"../student3/floor.cpp", ""}}));
  ASSERT_EQ(intake.uploads.size(), 1u);
  EXPECT_THAT(intake.refused, ElementsAre("../student3/floor.cpp: leads out of its folder",
                                          "student2: is a symbolic link"));
}

TEST_P(ClassArchive, ThatCannotBeReadNamesTheRemedy) {
  EXPECT_THAT([&] { find("no zip at all"); },
              testing::ThrowsMessage<UsageError>(
                  testing::AllOf(HasSubstr("class.zip can't be read as a zip or tar file"),
                                 HasSubstr("Unpack it yourself and name the folder"))));
}

} // namespace
} // namespace ggrade::intake
