#include "core/config/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft::config {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Config, ReadsEachTypeWithinItsBounds) {
  const Table root = parse(R"(
height_m = 0.6
count = 3
whole = 2
on = true
name = "r1"
dds = "fastdds"
size = [20, 12.5]
methods = ["floor", "marks"]
[camera]
focal = 460.0
[[walls]]
x = 1
[[walls]]
x = 2
)",
                           "site.toml");
  EXPECT_DOUBLE_EQ(root.number("height_m", required, 0.0, 10.0), 0.6);
  EXPECT_EQ(root.integer("count", 1, 0, 10), 3);
  EXPECT_DOUBLE_EQ(root.number("whole", required, 0.0, 10.0), 2.0);
  EXPECT_TRUE(root.boolean("on", false));
  EXPECT_EQ(root.text("name", required), "r1");
  EXPECT_EQ(root.choice("dds", "cyclonedds", {"fastdds", "cyclonedds"}), "fastdds");
  EXPECT_THAT(root.numbers("size", required, 2, 2, 0.0, 100.0), ElementsAre(20.0, 12.5));
  EXPECT_THAT(root.texts("methods", required, 1, 4), ElementsAre("floor", "marks"));
  EXPECT_DOUBLE_EQ(root.table("camera").number("focal", required, 1.0, 1e4), 460.0);
  const std::vector<Table> walls = root.tables("walls", 0, 10);
  ASSERT_EQ(walls.size(), 2U);
  EXPECT_DOUBLE_EQ(walls[1].number("x", required, 0.0, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(walls[0].number("x", required, 0.0, 10.0), 1.0);
  EXPECT_THAT(root.issues(), IsEmpty());
  EXPECT_TRUE(root.result());
}

TEST(Config, WhatIsNotWrittenHasItsDefault) {
  const Table root = parse("", "a.toml");
  EXPECT_FALSE(root.has("x"));
  EXPECT_DOUBLE_EQ(root.number("x", 1.5, 0.0, 2.0), 1.5);
  EXPECT_EQ(root.table("deep").table("deeper").text("name", "none"), "none");
  EXPECT_THAT(root.tables("walls", 0, 3), IsEmpty());
  EXPECT_TRUE(root.result());
}

TEST(Config, EveryIssueIsNamedWithFileLineKeyValueAndBound) {
  const Table root = parse(
      "speed = 9.5\ncount = 1.5\non = 1\nname = \"toolong\"\ndds = \"x\"\nsize = [1]\ntypo = 1\n", "dir/a.toml");
  root.number("speed", 0.6, 0.0, 2.0);
  root.integer("count", 1, 0, 10);
  root.boolean("on", true);
  root.text("name", "r", 3);
  root.choice("dds", "fastdds", {"fastdds", "cyclonedds"});
  root.numbers("size", required, 2, 2, 0.0, 1.0);
  root.number("must", required, -1.0, 1.0);
  EXPECT_THAT(
      root.issues(),
      ElementsAre("dir/a.toml:1: speed = 9.5: must be in [0, 2]",
                  "dir/a.toml:1: must: is missing; it has no default, write it",
                  "dir/a.toml:2: count = 1.5: must be a whole number in [0, 10]",
                  "dir/a.toml:3: on = 1: must be true or false", HasSubstr("dir/a.toml:4: name = "),
                  HasSubstr("dir/a.toml:5: dds = "), HasSubstr("dir/a.toml:6: size = "),
                  "dir/a.toml:7: typo: unknown key; there are count, dds, must, name, on, size, speed: correct its "
                  "spelling or remove it"));
  const Result<void> result = root.result();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::invalid);
  EXPECT_THAT(result.error().message, HasSubstr("2 to 2"));
}

TEST(Config, NumbersThatAreNoneAreRefused) {
  const Table root = parse("a = nan\nb = inf\nc = -inf\nd = \"1\"\n", "a.toml");
  for (const char* const key : {"a", "b", "c", "d"}) EXPECT_DOUBLE_EQ(root.number(key, 0.5, -1e9, 1e9), 0.5);
  EXPECT_EQ(root.issues().size(), 4U);
}

TEST(Config, BoundsAreInclusive) {
  const Table root = parse("a = 1\nb = 2\nc = [1, 2]\n", "a.toml");
  root.integer("a", 1, 1, 2);
  root.number("b", 1.0, 1.0, 2.0);
  root.numbers("c", required, 2, 2, 1.0, 2.0);
  EXPECT_THAT(root.issues(), IsEmpty());
}

TEST(Config, UnknownKeysAreFoundInTablesAndTheirArrays) {
  const Table root = parse("[known]\nused = 1\nunused = 2\n[other]\nx = 1\n[[walls]]\nx = 1\ny = 2\n", "a.toml");
  root.table("known").integer("used", 0, 0, 9);
  root.tables("walls", 0, 9).at(0).integer("x", 0, 0, 9);
  EXPECT_THAT(root.issues(),
              ElementsAre(HasSubstr("a.toml:3: known.unused: unknown"), HasSubstr("a.toml:4: other: unknown"),
                          HasSubstr("a.toml:8: walls[0].y: unknown")));
}

TEST(Config, AnUnknownKeyIsToldWhichKeysItsTableHas) {
  const Table root = parse("[a]\n\"x y\" = 1\nz = 2\n[b]\nc = 1\n[[walls]]\nhieght = 1\n", "a.toml");
  const Table a = root.table("a");
  a.integer("x y", 0, 0, 9);
  a.integer("size", 0, 0, 9);
  a.table("deep").integer("deeper", 0, 0, 9);
  root.table("b");
  root.tables("walls", 0, 9).at(0).integer("height", 0, 0, 9);
  EXPECT_THAT(root.issues(), ElementsAre(HasSubstr("a.z: unknown key; there are deep, size: correct"),
                                         HasSubstr("b.c: unknown key; correct its spelling"),
                                         HasSubstr("walls[0].hieght: unknown key; there are height: correct")));
}

TEST(Config, ARequiredKeyIsMissedAtItsTablesLine) {
  const Table root = parse("x = 1\n\n[camera]\nfocal = 2\n", "a.toml");
  root.integer("x", 0, 0, 9);
  const Table camera = root.table("camera");
  camera.number("focal", required, 0.0, 9.0);
  camera.number("height_m", required, 0.0, 9.0);
  EXPECT_THAT(root.issues(), ElementsAre(HasSubstr("a.toml:3: camera.height_m: is missing")));
}

TEST(Config, TablesOfTheWrongShapeAreRefused) {
  const Table root = parse("a = 1\nb = [1, 2]\n[[c]]\n[[c]]\n", "a.toml");
  root.table("a").number("x", 1.0, 0.0, 2.0);
  EXPECT_THAT(root.tables("b", 0, 9), IsEmpty());
  root.tables("c", 0, 1);
  EXPECT_THAT(root.issues(), ElementsAre(HasSubstr("a.toml:1: a = 1: must be a table"),
                                         HasSubstr("a.toml:2: b = [ 1, 2 ]: must be an array of tables"),
                                         HasSubstr("a.toml:3: c: has 2 entries, must have 0 to 1")));
}

TEST(Config, TextThatIsNoTomlIsOneIssue) {
  const Table root = parse("a = 1\nb = = 2\n", "a.toml");
  EXPECT_EQ(root.integer("a", required, 0, 9), 0);
  EXPECT_THAT(root.issues(), ElementsAre(HasSubstr("a.toml:2: no TOML: ")));
}

TEST(Config, CallersAddIssuesOfTheirOwn) {
  const Table root = parse("low = 3\nhigh = 2\n", "a.toml");
  if (root.number("low", 0.0, 0.0, 9.0) > root.number("high", 1.0, 0.0, 9.0))
    root.refuse("low", "must be below high");
  EXPECT_THAT(root.issues(), ElementsAre("a.toml:1: low = 3: must be below high"));
}

TEST(Config, TheEffectiveListMarksWhatIsNotDefault) {
  const Table root = parse("b = 2\nc = 3\n[t]\nname = \"x\"\n", "a.toml");
  root.number("a", 0.25, 0.0, 9.0);
  root.integer("b", 2, 0, 9);
  root.integer("c", 1, 0, 9);
  root.integer("c", 1, 0, 9);
  root.table("t").text("name", "");
  root.numbers("size", std::vector<double>{1.0, 2.5}, 2, 2, 0.0, 9.0);
  EXPECT_EQ(to_text(root.effective()), "  a = 0.25\n  b = 2\n* c = 3\n* t.name = 'x'\n  size = [1, 2.5]\n");
}

}  // namespace
}  // namespace weft::config
