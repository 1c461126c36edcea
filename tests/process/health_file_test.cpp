#include "process/health_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>
#include <utility>

#include "tests/process/folder.hpp"

namespace weft::process::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr SteadyTime kWritten{Duration(1000s)};

Health living() {
  return {.program = "weft-agent", .process = 12, .beat = kWritten, .is_starting = false, .trouble = {}};
}

TEST(HealthFile, IsHealthyWhileItIsHeld) {
  const Folder folder;
  std::optional<HealthFile> file = HealthFile::open(folder.path()).value();
  ASSERT_TRUE(file->write(living()));
  EXPECT_TRUE(look_at_health(folder.path(), kWritten + 1s).healthy);
  EXPECT_THAT(look_at_health(folder.path(), kWritten + 11s).why, HasSubstr("hung for 11.0 s"));
  HealthFile moved = std::move(*file);
  file.reset();
  EXPECT_TRUE(look_at_health(folder.path(), kWritten + 1s).healthy);
}

TEST(HealthFile, WhatADeadProcessLeftDoesNotCount) {
  const Folder folder;
  ASSERT_TRUE(HealthFile::open(folder.path()).value().write(living()));
  const Verdict verdict = look_at_health(folder.path(), kWritten);
  EXPECT_FALSE(verdict.healthy);
  EXPECT_THAT(verdict.why, HasSubstr("not running"));
}

TEST(HealthFile, NoFileMeansThatNothingRuns) {
  const Folder folder;
  for (const auto& directory : {folder.path(), folder.path() / "nowhere"}) {
    const Verdict verdict = look_at_health(directory, kWritten);
    EXPECT_FALSE(verdict.healthy);
    EXPECT_THAT(verdict.why, HasSubstr("not running"));
    EXPECT_THAT(verdict.why, HasSubstr((directory / "health").string()));
  }
}

TEST(HealthFile, LookingTakesNothingFromTheProcess) {
  const Folder folder;
  folder.write("health", health_text(living()));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(look_at_health(folder.path(), kWritten).healthy);
  EXPECT_TRUE(HealthFile::open(folder.path()));
}

TEST(HealthFile, ASecondProcessIsKeptOut) {
  const Folder folder;
  const auto first = HealthFile::open(folder.path());
  ASSERT_TRUE(first);
  const auto second = HealthFile::open(folder.path());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("cannot be locked"));
}

TEST(HealthFile, GarbageIsNamedAndReplacedAtTheNextBeat) {
  const Folder folder;
  auto file = HealthFile::open(folder.path());
  ASSERT_TRUE(file);
  for (const std::string& garbage : {std::string(), std::string("garbage\n"), std::string(4096, '\x01')}) {
    folder.write("health", garbage);
    const Verdict verdict = look_at_health(folder.path(), kWritten);
    EXPECT_FALSE(verdict.healthy);
    EXPECT_THAT(verdict.why, HasSubstr("holds no health record"));
    ASSERT_TRUE(file->write(living()));
    EXPECT_TRUE(look_at_health(folder.path(), kWritten).healthy);
  }
}

TEST(HealthFile, WhatIsNoFileIsNamed) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "health");
  EXPECT_THAT(look_at_health(folder.path(), kWritten).why, HasSubstr("is no file"));
  EXPECT_FALSE(HealthFile::open(folder.path()));
  std::filesystem::remove(folder.path() / "health");
  ASSERT_EQ(mkfifo(folder.file("health").c_str(), 0644), 0);
  EXPECT_THAT(look_at_health(folder.path(), kWritten).why, HasSubstr("is no file"))
      << "and nobody waits for a writer";
}

TEST(HealthFile, AFullDiskIsAnErrorAndNoCrash) {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "health");
  auto file = HealthFile::open(folder.path());
  if (!file) GTEST_SKIP() << "this machine's devices take no locks";
  const Result<void> written = file->write(living());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::exhausted);
}

TEST(HealthFile, ARemovedFileIsAnError) {
  const Folder folder;
  auto file = HealthFile::open(folder.path());
  ASSERT_TRUE(file);
  std::filesystem::remove(folder.path() / "health");
  const Result<void> written = file->write(living());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::unavailable);
}

}  // namespace
}  // namespace weft::process::test
