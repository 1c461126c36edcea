#include "clients/evaluate/floor/trace_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/clients/evaluate/floor/driven_trace.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

TEST(TraceFile, ComesBackAsItWas) {
  const storage::TemporaryDirectory folder;
  const auto file = folder.path() / "series" / "a.csv";
  Trace trace = straight_trace(0.5, 1.0);
  const PlaceId place{ExperienceId{7}, 3};
  trace.moments[4].fix = FixSeen{place, {0.1, -0.2, 0.03}, {0.11, -0.21, 0.04}};
  trace.moments[5].kept = place;
  trace.moments[6].matches = 42;
  trace.moments[6].seen = trace.moments[7].lost = true;
  ASSERT_TRUE(write_trace(file, "stamp", trace).has_value());
  const auto back = read_trace(file, "stamp");
  ASSERT_TRUE(back.has_value());
  ASSERT_EQ(back->moments.size(), trace.moments.size());
  EXPECT_EQ(back->moments[4].fix->place, place);
  EXPECT_NEAR(back->moments[4].fix->measured.y, -0.2, 1e-6);
  EXPECT_NEAR(back->moments[4].fix->believed.heading, 0.04, 1e-6);
  EXPECT_EQ(back->moments[5].kept, place);
  EXPECT_FALSE(back->moments[5].fix.has_value());
  EXPECT_EQ(back->moments[6].matches, 42U);
  EXPECT_TRUE(back->moments[6].seen);
  EXPECT_TRUE(back->moments[7].lost);
  EXPECT_NEAR(back->moments.back().site_from_robot.x, 1.0, 1e-6);
  EXPECT_EQ(places_of(*back).site_from_place.size(), 1U);
}

TEST(TraceFile, OfAnotherStudyOrDamagedIsNone) {
  const storage::TemporaryDirectory folder;
  const auto file = folder.path() / "a.csv";
  EXPECT_FALSE(read_trace(file, "stamp").has_value());
  ASSERT_TRUE(write_trace(file, "stamp", straight_trace(0.5, 1.0)).has_value());
  EXPECT_FALSE(read_trace(file, "other").has_value());
  std::ofstream(file, std::ios::app) << "1,2,3\n";
  EXPECT_FALSE(read_trace(file, "stamp").has_value());
}

}  // namespace
}  // namespace weft::evaluate::floor
