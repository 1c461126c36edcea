#include "process/settings_file.hpp"

#include <gtest/gtest.h>

#include "tests/process/folder.hpp"

namespace weft::process::test {
namespace {

TEST(SettingsFile, IsReadWholeAndNoneIsEmpty) {
  const Folder folder;
  folder.write("a.toml", "name = \"r1\"\n");
  EXPECT_EQ(read_settings(folder.file("a.toml")).value(), "name = \"r1\"\n");
  EXPECT_EQ(read_settings("").value(), "");
}

TEST(SettingsFile, WhatIsNoFileIsNamed) {
  const Folder folder;
  for (const std::string& wrong : {folder.file("gone.toml"), folder.path().string()}) {
    const Result<std::string> read = read_settings(wrong);
    ASSERT_FALSE(read) << wrong;
    EXPECT_EQ(read.error().code, ErrorCode::invalid);
    EXPECT_EQ(read.error().message, wrong + ": cannot be read; is --config right?");
  }
}

}  // namespace
}  // namespace weft::process::test
