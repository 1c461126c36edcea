#include <gtest/gtest.h>

#include <cmath>

#include "agents/perception/particles/likelihood_field.hpp"
#include "tests/agents/perception/particles/room.hpp"

namespace weft::agents {
namespace {

double log_at(const LikelihoodField& field, const Scan& scan, const Pose2& pose) {
  ParticleSet one;
  one.add(pose, 1.0);
  std::vector<float> logs(1, 0.0F);
  field.weigh(field.ends_of(scan), one, logs);
  return static_cast<double>(logs[0]);
}

Scan one_beam(double range_m, double sigma_m = 0.0) {
  return {{}, {{0.0, range_m, sigma_m, 0.0, Beam::Return::obstacle}}};
}

TEST(LikelihoodField, IsThatOfADistanceWithTheWidthOfTheBeam) {
  const Room room;
  const LikelihoodConfig config;
  const LikelihoodField field = room.field(config);
  const auto expected = [&](double off_m, double sigma_m) {
    return std::log(1.0 - config.hit_share + config.hit_share * std::exp(-0.5 * off_m * off_m / sigma_m / sigma_m));
  };
  // The beam ends 0.2 m before the wall at x = 8, whose nearest cell's middle is 0.225 m away.
  EXPECT_NEAR(log_at(field, one_beam(2.8), {5.0, 4.0, 0.0}), expected(0.2, 0.05), 0.15);
  const double wide_m = std::hypot(0.05, 0.2);
  EXPECT_NEAR(log_at(field, one_beam(2.8, 0.2), {5.0, 4.0, 0.0}), expected(0.2, wide_m), 0.15);
  EXPECT_GT(log_at(field, one_beam(3.0), {5.0, 4.0, 0.0}), -0.2);
}

TEST(LikelihoodField, AFloorThatEndsSpeaksLessAgainstAPoseThanAnObstacle) {
  const Room room;
  const LikelihoodConfig config;
  const LikelihoodField field = room.field(config);
  Scan edge = one_beam(1.5);  // in the middle of the room
  edge.beams.front().kind = Beam::Return::floor_edge;
  EXPECT_NEAR(log_at(field, edge, {5.0, 4.0, 0.0}), std::log(1.0 - config.edge_share), 1e-3);
  EXPECT_NEAR(log_at(field, one_beam(1.5), {5.0, 4.0, 0.0}), std::log(1.0 - config.hit_share), 1e-3);
  edge.beams.front().range_m = 3.0;
  EXPECT_GT(log_at(field, edge, {5.0, 4.0, 0.0}), -0.2);
  std::vector<BeamEnd> ends = field.ends_of(edge);
  for (int i = 0; i < 20; ++i) LikelihoodField::widen(ends);
  ParticleSet far;
  far.add({2.0, 4.0, 0.0}, 1.0);
  std::vector<float> logs(1, 0.0F);
  field.weigh(ends, far, logs);
  EXPECT_GE(static_cast<double>(logs[0]), std::log(1.0 - config.edge_share)) << "it stays an edge";
}

TEST(LikelihoodField, UnknownCellsAndWhatIsOutsideAreNeutral) {
  const Room room;
  const LikelihoodField field = room.field();
  const double hits = log_at(field, one_beam(3.0), {5.0, 4.0, 0.0});
  const double misses = log_at(field, one_beam(1.5), {5.0, 4.0, 0.0});
  const double unknown = log_at(field, one_beam(3.5), {5.0, 4.0, 0.0});
  const double outside = log_at(field, one_beam(300.0), {5.0, 4.0, 0.0});
  EXPECT_LT(misses, unknown);
  EXPECT_LT(unknown, hits);
  EXPECT_EQ(unknown, outside);
  EXPECT_EQ(log_at(field, one_beam(-300.0), {5.0, 4.0, 0.0}), outside);
}

TEST(LikelihoodField, UsesSoManyBeamsEvenlyAndNoneThatDidNotReturn) {
  const Room room;
  Random random(1);
  Scan scan = room.scan_from({4.0, 3.0, 0.0}, random);
  EXPECT_EQ(room.field().ends_of(scan).size(), 60U);
  for (std::size_t i = 0; i + 10 < scan.beams.size(); ++i) scan.beams[i].kind = Beam::Return::none;
  EXPECT_EQ(room.field().ends_of(scan).size(), 10U);
}

TEST(LikelihoodField, IsHighestWhereTheScanWasTaken) {
  const Room room;
  Random random(2);
  const Pose2 truth{3.1, 2.2, 0.8};
  const Scan scan = room.scan_from(truth, random);
  const LikelihoodField field = room.field();
  const double best = log_at(field, scan, truth);
  for (int i = 0; i < 200; ++i) {
    const Pose2 other = Room::anywhere(random);
    if ((other.translation() - truth.translation()).norm() < 0.3) continue;
    EXPECT_GT(best, log_at(field, scan, other));
  }
}

TEST(LikelihoodField, ABlurredBeamTellsFromFartherOffAndLessNearby) {
  const Room room;
  const LikelihoodField field = room.field();
  const auto log_of_blurred = [&](double range_m, int blurs) {
    std::vector<BeamEnd> ends = field.ends_of(one_beam(range_m));
    for (int i = 0; i < blurs; ++i) LikelihoodField::widen(ends);
    ParticleSet one;
    one.add({5.0, 4.0, 0.0}, 1.0);
    std::vector<float> logs(1, 0.0F);
    field.weigh(ends, one, logs);
    return logs[0];
  };
  const float most = log_of_blurred(2.7, 3) - log_of_blurred(2.2, 3);
  EXPECT_GT(most, log_of_blurred(2.7, 0) - log_of_blurred(2.2, 0)) << "0.3 against 0.8 m off";
  EXPECT_GT(log_of_blurred(2.7, 3), log_of_blurred(2.7, 1));
  EXPECT_EQ(log_of_blurred(2.7, 50), log_of_blurred(2.7, 60)) << "there is a widest";
}

TEST(LikelihoodField, EightAtOnceAreTheSameBitByBit) {
  const Room room;
  Random random(3);
  const LikelihoodField field = room.field();
  const std::vector<BeamEnd> ends = field.ends_of(room.scan_from({3.1, 2.2, 0.8}, random));
  ParticleSet particles;
  for (int i = 0; i < 1003; ++i) {
    const Pose2 pose = Room::anywhere(random);
    particles.add({3.0 * pose.x - 6.0, 3.0 * pose.y - 6.0, pose.heading}, 1.0);  // some outside
  }
  std::vector<float> at_once(particles.size(), 0.5F);
  std::vector<float> one_by_one(particles.size(), 0.5F);
  field.weigh(ends, particles, at_once);
  field.weigh_plain(ends, particles, one_by_one);
  EXPECT_EQ(at_once, one_by_one);
}

}  // namespace
}  // namespace weft::agents
