#include "process/vitals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "tests/process/folder.hpp"
#include "tests/process/manager_socket.hpp"

namespace weft::process::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr SteadyTime kStart{Duration(1000s)};

struct VitalsTest : testing::Test {
  Vitals vitals(Duration watchdog = {}) {
    return {"weft-server", folder.path(), [this](const std::string& text) { warnings.push_back(text); },
            ServiceManager(folder.file("notify"), watchdog), kStart};
  }
  Verdict looked(Duration later) const { return look_at_health(folder.path(), kStart + later); }

  Folder folder;
  ManagerSocket manager{folder.file("notify")};
  std::vector<std::string> warnings;
};

TEST_F(VitalsTest, AProcessStartsWorksAndHangs) {
  Vitals one = vitals();
  one.starting("it opens its store", kStart);
  EXPECT_THAT(looked(3s).why, HasSubstr("starting for 3.0 s: it opens its store"));
  one.ready(kStart + 4s);
  EXPECT_TRUE(looked(5s).healthy);
  EXPECT_EQ(one.due(), kStart + 5s);
  one.beat(kStart + 5s, "deaf");
  EXPECT_THAT(looked(5s).why, HasSubstr("deaf"));
  one.beat(kStart + 6s, "");
  EXPECT_TRUE(looked(6s).healthy);
  EXPECT_THAT(looked(16s).why, HasSubstr("hung for 10.0 s"));
}

TEST_F(VitalsTest, WhatItWaitsForIsTimedFromItsBeginning) {
  Vitals one = vitals();
  for (int second = 0; second < 5; ++second) one.starting("it waits for its link", kStart + second * 1s);
  EXPECT_THAT(looked(5s).why, HasSubstr("starting for 5.0 s"));
}

TEST_F(VitalsTest, TheServiceManagerHearsOfEachStepAndAtHalfItsTime) {
  Vitals one = vitals(1s);
  one.starting("it opens its store", kStart);
  EXPECT_THAT(manager.take(), HasSubstr("STATUS=it opens its store"));
  one.ready(kStart);
  EXPECT_EQ(manager.take(), "READY=1");
  EXPECT_EQ(manager.take(), "WATCHDOG=1\nSTATUS=works");
  EXPECT_EQ(one.due(), kStart + 500ms);
  one.beat(kStart + 500ms, "");
  EXPECT_EQ(manager.take(), "WATCHDOG=1");
  one.beat(kStart + 1s, "deaf\nand more");
  EXPECT_EQ(manager.take(), "WATCHDOG=1\nSTATUS=deaf; and more");
  one.stopping();
  EXPECT_EQ(manager.take(), "STOPPING=1");
}

TEST_F(VitalsTest, AFileThatCannotBeWrittenIsSaidOnceAndTriedAgain) {
  std::filesystem::create_directory(folder.path() / "health");
  Vitals one = vitals();
  one.starting("it opens its store", kStart);
  EXPECT_THAT(warnings, IsEmpty());
  one.ready(kStart);
  one.beat(kStart + 1s, "");
  EXPECT_THAT(warnings, SizeIs(1));
  std::filesystem::remove(folder.path() / "health");
  one.beat(kStart + 2s, "");
  EXPECT_TRUE(looked(2s).healthy);
}

TEST_F(VitalsTest, ARemovedFileIsMadeAnew) {
  Vitals one = vitals();
  one.ready(kStart);
  std::filesystem::remove(folder.path() / "health");
  one.beat(kStart + 1s, "");
  one.beat(kStart + 2s, "");
  EXPECT_TRUE(looked(2s).healthy);
}

}  // namespace
}  // namespace weft::process::test
