#include "clients/evaluate/odometry/row.hpp"

#include <gtest/gtest.h>

namespace weft::evaluate::odometry {
namespace {

/// Returns an observer that says `share` of the true motion: 1 cm a sample straight ahead for 12 m.
Observer who_says(const std::string& name, double share) {
  Observer observer(
      name, 1,
      [share, first = true](const agents::View*, const agents::Motion&) mutable {
        const double metres = first ? 0.0 : 0.01 * share;
        const bool seen = !first;
        first = false;
        return agents::Step{Metric2{{metres, 0.0, 0.0}, Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal()}, seen, {}};
      },
      [] { return 0.0; });
  for (std::uint64_t i = 0; i <= 1250; ++i) {
    agents::Sample sample;
    sample.frame = i;
    observer.take(sample);
    floor::Moment& moment = observer.trace().moments.back();
    moment.true_s = static_cast<double>(i) / 30.0;
    moment.site_from_robot = {0.01 * static_cast<double>(i), 0.0, 0.0};
  }
  return observer;
}

TEST(OdometryRow, IsWhatTheTraceComesTo) {
  const Row row = row_of("wood", 3, "mapping", who_says("x", 1.01));
  EXPECT_NEAR(row.speed_percent, 1.0, 1e-6);
  EXPECT_NEAR(row.drift_mm, 10.0, 0.1);
  EXPECT_EQ(row.blind_percent, 0.0);
  // 10 mm off with 10 mm of sigma over 1 m; 100 mm with 32 mm over 10 m.
  EXPECT_NEAR(row.over_1m.front(), 1.0, 0.05);
  EXPECT_NEAR(row.over_10m.front(), 10.0, 0.5);
}

TEST(OdometryRow, TheTablePoolsFloorsAndNamesThem) {
  std::vector<Row> rows;
  rows.push_back(row_of("wood", 3, "mapping", who_says("x", 1.01)));
  rows.push_back(row_of("tiles", 3, "mapping", who_says("x", 1.0)));
  const std::string table = table_of(rows);
  EXPECT_NE(table.find("50.0"), std::string::npos) << "held over 10 m by one of two\n" << table;
  for (const char* const word : {"all", "wood", "tiles", "mapping"})
    EXPECT_NE(table.find(word), std::string::npos) << table;
  EXPECT_NE(csv_of(rows).find("\"wood\",3,\"mapping\",\"x\",1"), std::string::npos) << csv_of(rows);
}

TEST(OdometryObserver, ASkippedImageLeavesItsMotionToTheNext) {
  std::vector<double> metres;
  Observer observer(
      "every third", 3,
      [&](const agents::View*, const agents::Motion& motion) {
        metres.push_back(motion.wheels ? motion.wheels->distance_m : -1.0);
        return agents::Step{Metric2{}, false, "blind"};
      },
      [] { return 0.0; });
  for (std::uint64_t i = 0; i < 7; ++i) {
    agents::Sample sample;
    sample.frame = i;
    sample.motion.wheels = agents::WheelStep{0.01, 0.0};
    observer.take(sample);
  }
  ASSERT_EQ(metres.size(), 3U);
  EXPECT_NEAR(metres[1], 0.03, 1e-12);
  EXPECT_NEAR(metres[2], 0.03, 1e-12);
  EXPECT_EQ(observer.trace().refusals.at("blind"), 3U);
}

}  // namespace
}  // namespace weft::evaluate::odometry
