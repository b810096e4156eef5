#include <gg/handle.hpp>

#include <type_traits>
#include <vector>

#include <gmock/gmock.h>

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Names that count up, and a list of those that were deleted.
struct FakeTraits {
  static inline GLuint next = 1;
  static inline std::vector<GLuint> deleted;
  static GLuint create() { return next++; }
  static void destroy(GLuint name) { deleted.push_back(name); }
};
using FakeHandle = gg::Handle<FakeTraits>;

class Handle : public testing::Test {
protected:
  void SetUp() override {
    FakeTraits::next = 1;
    FakeTraits::deleted.clear();
  }
};

static_assert(!std::is_copy_constructible_v<FakeHandle>);
static_assert(!std::is_copy_assignable_v<FakeHandle>);
static_assert(std::is_nothrow_move_constructible_v<FakeHandle>);
static_assert(std::is_nothrow_move_assignable_v<FakeHandle>);

TEST_F(Handle, DeletesOnceAtTheEndOfItsScope) {
  {
    const FakeHandle handle;
    EXPECT_EQ(handle, 1u);
    EXPECT_THAT(FakeTraits::deleted, IsEmpty());
  }
  EXPECT_THAT(FakeTraits::deleted, ElementsAre(1));
}

TEST_F(Handle, MovedTwiceIsDeletedOnce) {
  {
    FakeHandle first;
    FakeHandle second(std::move(first));
    const FakeHandle third(std::move(second));
    EXPECT_EQ(first, 0u);
    EXPECT_EQ(second, 0u);
    EXPECT_EQ(third, 1u);
  }
  EXPECT_THAT(FakeTraits::deleted, ElementsAre(1));
}

TEST_F(Handle, AssignmentDeletesWhatItReplaces) {
  {
    FakeHandle kept;     // 1
    FakeHandle replaced; // 2
    replaced = std::move(kept);
    EXPECT_THAT(FakeTraits::deleted, ElementsAre(2));
    EXPECT_EQ(replaced, 1u);
    EXPECT_EQ(kept, 0u);
  }
  EXPECT_THAT(FakeTraits::deleted, ElementsAre(2, 1));
}

TEST_F(Handle, AssignmentToItselfKeepsTheName) {
  FakeHandle handle;
  FakeHandle& same = handle;
  handle = std::move(same);
  EXPECT_EQ(handle, 1u);
  EXPECT_THAT(FakeTraits::deleted, IsEmpty());
}

TEST_F(Handle, BeforeTheWindowSaysSo) {
  try {
    const gg::Texture texture;
    FAIL() << "no window, and yet a texture";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "a Texture was made before the window; make the window first");
  }
}

} // namespace
