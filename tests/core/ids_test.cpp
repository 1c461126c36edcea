#include "core/ids.hpp"

#include <gtest/gtest.h>

namespace weft {
namespace {

TEST(Ids, PlacesAreReadAsTheyAreWritten) {
  const PlaceId id{ExperienceId{0x00ab00000000cd01ULL}, 4'294'967'295U};
  EXPECT_EQ(to_string(id), "00ab00000000cd01:4294967295");
  EXPECT_EQ(parse_place_id(to_string(id)), id);
  EXPECT_EQ(parse_experience_id("00AB00000000CD01"), id.experience);
}

TEST(Ids, WhatIsNoPlaceIsNotRead) {
  for (const char* const text :
       {"", ":", "1:2", "00ab00000000cd01", "00ab00000000cd01:", "00ab00000000cd01:-1", "00ab00000000cd01:+1",
        "00ab00000000cd01: 1", "00ab00000000cd01:1x", "00ab00000000cd01:4294967296", "00ab00000000cdg1:1",
        "00ab00000000cd01;1", "000ab00000000cd01:1"}) {
    EXPECT_FALSE(parse_place_id(text)) << text;
  }
  EXPECT_FALSE(parse_experience_id("00ab00000000cd0"));
}

TEST(Ids, HexFillsExactlyItsBytes) {
  RobotId id;
  EXPECT_TRUE(parse_hex("000102030405060708090a0b0c0d0eff", id.bytes.data(), id.bytes.size()));
  EXPECT_EQ(to_string(id), "000102030405060708090a0b0c0d0eff");
  EXPECT_FALSE(parse_hex("000102030405060708090a0b0c0d0ef", id.bytes.data(), id.bytes.size()));
  EXPECT_FALSE(parse_hex("000102030405060708090a0b0c0d0efg", id.bytes.data(), id.bytes.size()));
  EXPECT_TRUE(id);
  EXPECT_FALSE(RobotId{});
}

}  // namespace
}  // namespace weft
