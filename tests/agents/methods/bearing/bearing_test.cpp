#include "agents/methods/bearing/bearing.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/aisle.hpp"

namespace weft::agents {
namespace {

using testing::HasSubstr;

static_assert(Exposes<Bearing>);

const AlongPath& along(const Relation& relation) {
  return std::get<AlongPath>(relation);
}

class BearingTest : public testing::Test {
 protected:
  static BearingContent seen(const Bearing& method, test::Lookout& lookout, const Pose2& from) {
    const auto content = method.extract({}, lookout.from(from));
    EXPECT_TRUE(content) << content.error().reason;
    return content.value_or(BearingContent{});
  }
  BearingContent at(double x, double y = 6.0, double heading = 0.0) {
    return seen(method_, lookout_, {x, y, heading});
  }

  test::Lookout lookout_{test::aisle_site()};
  Bearing method_ = *Bearing::make({}, lookout_.camera());
};

TEST_F(BearingTest, TellsByHowMuchTheRobotIsTurned) {
  const BearingContent taught = at(6.0);
  for (const double turned : {-0.2, -0.05, 0.0, 0.1, 0.25}) {
    const auto related = method_.relate(taught, at(6.0, 6.0, turned), std::nullopt);
    ASSERT_TRUE(related) << turned << " " << related.error().reason;
    EXPECT_NEAR(along(related->a_from_b).heading_shift_rad, turned, 0.02);
  }
}

TEST_F(BearingTest, TellsTheHeadingOfARobotWhoseCameraLooksFurtherDown) {
  const BearingContent taught = at(6.0);
  agents::sim::Site site = test::aisle_site();
  site.forward_camera.pitch_rad += 0.12;  // by more rows than a vote stands
  test::Lookout low(site);
  const Bearing other = *Bearing::make({}, low.camera());
  for (const double turned : {-0.1, 0.0, 0.15}) {
    const auto related = other.relate(taught, seen(other, low, {6.0, 6.0, turned}), std::nullopt);
    ASSERT_TRUE(related) << turned << " " << related.error().reason;
    EXPECT_NEAR(along(related->a_from_b).heading_shift_rad, turned, 0.02);
  }
}

TEST_F(BearingTest, WishesAnExposureThatATurnDoesNotBlur) {
  View view = lookout_.from({6.0, 6.0, 0.0});
  view.exposure = Exposure{0.015, 1.0};
  Bearing::Odometry standing;
  const auto calm = method_.expose(standing, view);
  ASSERT_TRUE(calm);
  Bearing::Odometry turning;
  turning.driving = {0.0, 1.0};
  const auto sharp = method_.expose(turning, view);
  ASSERT_TRUE(sharp);
  EXPECT_NEAR(sharp->light_s(), calm->light_s(), 1e-9) << "as bright";
  EXPECT_NEAR(sharp->time_s * lookout_.camera().fx, method_.config().exposure.most_blur_px, 1e-9);
  EXPECT_LT(sharp->time_s, calm->time_s);
}

TEST_F(BearingTest, WishesNoExposureWithoutKnowingWhatItWas) {
  View view = lookout_.from({6.0, 6.0, 0.0});
  view.exposure.reset();
  EXPECT_FALSE(method_.expose({}, view));
  view.exposure = Exposure{0.01, 1.0};
  view.data = Payload{};
  EXPECT_FALSE(method_.expose({}, view));
}

TEST_F(BearingTest, ANearbyViewStillTellsItsHeading) {
  const BearingContent taught = at(6.0);
  const Relation about_here = AlongPath{0.0, 0.04, 0.0, 0.09};  // without it more has to agree
  const auto related = method_.relate(taught, at(6.2, 6.3, 0.0), about_here);
  ASSERT_TRUE(related) << related.error().reason;
  // Beside the path what was straight ahead lies to the right: it steers back.
  EXPECT_GT(along(related->a_from_b).heading_shift_rad, 0.0);
  EXPECT_LT(along(related->a_from_b).heading_shift_rad, 0.15);
}

TEST_F(BearingTest, ADistanceIsOnlyThatOfTheGuess) {
  const BearingContent taught = at(6.0);
  const Relation guess = AlongPath{0.3, 0.04, 0.0, 0.01};
  const auto guided = method_.relate(taught, at(6.1), guess);
  ASSERT_TRUE(guided);
  EXPECT_EQ(along(guided->a_from_b).distance_m, 0.3);
  EXPECT_NEAR(along(guided->a_from_b).distance_variance_m2, 0.04, 1e-12);
  const auto free = method_.relate(taught, at(6.1), std::nullopt);
  ASSERT_TRUE(free);
  EXPECT_EQ(along(free->a_from_b).distance_m, 0.0);
  EXPECT_GE(along(free->a_from_b).distance_variance_m2, 0.2);
}

TEST_F(BearingTest, AnAisleOfTheSameRacksWithOtherLoadsIsAnotherScene) {
  agents::sim::Site site = test::aisle_site();
  for (agents::sim::Box& box : site.boxes) box.name += " of the next aisle";
  site.floor.seed += 1;
  test::Lookout next(site);
  int turned_by_vote = 0;
  for (double x = 5.0; x < 10.0; x += 1.0) {  // further on both see the same wall
    const BearingContent known = at(x);
    const double right = method_.likeness(known, at(x, 6.05));
    for (double other = 5.0; other < 10.0; other += 1.0) {
      const BearingContent elsewhere = seen(method_, next, {other, 6.0, 0.0});
      if (vote_heading(known.features, elsewhere.features, 320.0, {})) ++turned_by_vote;
      EXPECT_FALSE(method_.relate(known, elsewhere, std::nullopt)) << x << " for " << other;
      EXPECT_LT(method_.likeness(known, elsewhere), 0.6 * right) << x << " for " << other;
    }
  }
  EXPECT_GT(turned_by_vote, 0) << "otherwise this shows nothing";
}

TEST_F(BearingTest, LookingBackIsRefused) {
  const auto related = method_.relate(at(6.0), at(10.0, 6.0, M_PI), std::nullopt);
  ASSERT_FALSE(related);
  EXPECT_EQ(related.error().reason, "no_majority");
}

TEST_F(BearingTest, WhoDescribesFeaturesOtherwiseIsTold) {
  BearingConfig config;
  config.features.description = Description::brief;
  const Bearing others = *Bearing::make(config, lookout_.camera());
  const BearingContent brief = seen(others, lookout_, {6.05, 6.0, 0.1});
  const auto related = method_.relate(at(6.0), brief, std::nullopt);
  ASSERT_FALSE(related);
  EXPECT_EQ(related.error().reason, "described_otherwise");
  EXPECT_FALSE(method_.learn(at(6.0), brief, AlongPath{0.05, 1e-4}));
  EXPECT_TRUE(others.relate(seen(others, lookout_, {6.0, 6.0, 0.0}), brief, std::nullopt));
}

TEST_F(BearingTest, AnotherRobotsCameraSeesTheSame) {
  agents::sim::Site site = test::aisle_site();
  site.forward_camera.width = 640;
  site.forward_camera.height = 480;
  site.forward_camera.focal_px = 600.0;
  test::Lookout other(site, 3);
  const Bearing others = *Bearing::make({}, other.camera());
  const auto related = method_.relate(at(6.0), seen(others, other, {6.05, 6.0, 0.1}), std::nullopt);
  ASSERT_TRUE(related) << related.error().reason;
  EXPECT_NEAR(along(related->a_from_b).heading_shift_rad, 0.1, 0.03);
}

TEST_F(BearingTest, MotionIsThatOfWheelsOrElseOfTheCommand) {
  Bearing::Odometry odometry;
  const View view = lookout_.from({6.0, 6.0, 0.0});
  Motion motion{std::chrono::milliseconds(100), {0.5, 0.2}, WheelStep{0.06, 0.03}};
  const Step by_wheels = method_.observe(odometry, &view, motion);
  EXPECT_TRUE(by_wheels.seen);
  EXPECT_NEAR(along(by_wheels.previous_from_current).distance_m, 0.06, 1e-12);
  EXPECT_NEAR(odometry.driving.linear_m_s, 0.6, 1e-9);
  motion.wheels.reset();
  const Step by_command = method_.observe(odometry, nullptr, motion);
  EXPECT_FALSE(by_command.seen);
  EXPECT_EQ(by_command.blind_reason, "no_view");
  EXPECT_NEAR(along(by_command.previous_from_current).distance_m, 0.05, 1e-12);
  EXPECT_NEAR(along(by_command.previous_from_current).heading_shift_rad, 0.02, 1e-12);
  EXPECT_GT(along(by_command.previous_from_current).distance_variance_m2,
            along(by_wheels.previous_from_current).distance_variance_m2);
}

TEST_F(BearingTest, ViewsThatAreNoneAreNamed) {
  View view = lookout_.from({6.0, 6.0, 0.0});
  view.data = Payload{};
  EXPECT_EQ(method_.extract({}, view).error().reason, "not_an_image");
  view.data = Image{10, 10, std::make_shared<const Bytes>(100, 0)};
  EXPECT_EQ(method_.extract({}, view).error().reason, "wrong_size");
  view.data = Image{320, 240, std::make_shared<const Bytes>(320 * 240, 90)};
  EXPECT_EQ(method_.extract({}, view).error().reason, "few_features");
}

TEST_F(BearingTest, SettingsOutOfBoundsAreNamedTogether) {
  BearingConfig config;
  config.focal_px = 0.0;
  config.most_neighbours = 0;
  config.vote.spread = -1.0;
  CameraModel camera = lookout_.camera();
  camera.fx = 0.0;
  const auto made = Bearing::make(config, camera);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("bearing.focal_px"));
  EXPECT_THAT(made.error().message, HasSubstr("bearing.most_neighbours"));
  EXPECT_THAT(made.error().message, HasSubstr("bearing.spread"));
  EXPECT_THAT(made.error().message, HasSubstr("focal length"));
}

/// Arranges an aisle taught every 0.2 m from x = 5 to 9; the chart's centre is at 7.
class BearingLocateTest : public BearingTest {
 protected:
  void SetUp() override {
    for (int i = 0; i <= 20; ++i) {
      const double ahead = -2.0 + 0.2 * i;
      around_.push_back(
          {place(i), 0, AlongPath{ahead, 1e-4}, std::make_shared<const BearingContent>(at(7.0 + ahead))});
    }
    chart_ = method_.chart(around_);
  }
  static PlaceId place(int i) {
    PlaceId id;
    id.index = static_cast<std::uint32_t>(i);
    return id;
  }
  std::vector<ChartPlace<BearingContent>> around_;
  Bearing::Chart chart_;
};

TEST_F(BearingLocateTest, HowNearThingsAreTellsHowFarAlongItIs) {
  for (const double x : {6.1, 6.7, 7.3, 7.7}) {
    for (const double off : {-0.3, 0.25}) {
      // Believed to be `off` away from where it is.
      Bearing::Belief belief{AlongPath{x - 7.0 + off, 0.04}};
      const auto located = method_.locate(chart_, belief, {AlongPath{}, true, {}}, at(x, 6.0, 0.05));
      ASSERT_TRUE(located.fix);
      const AlongPath& told = along(located.fix->place_from_robot);
      EXPECT_NEAR(told.heading_shift_rad, 0.05, 0.02);
      const double true_m = x - (5.0 + 0.2 * located.fix->place.index);
      EXPECT_NEAR(told.distance_m, true_m, 0.06);
      EXPECT_NEAR(told.distance_m, true_m, 4.0 * std::sqrt(told.distance_variance_m2));
    }
  }
}

TEST_F(BearingLocateTest, WhereThePathBeginsItHasNeighboursOnOneSideOnly) {
  const auto located = method_.locate(chart_, {AlongPath{-1.8, 0.04}}, {AlongPath{}, true, {}}, at(4.95));
  ASSERT_TRUE(located.fix);
  EXPECT_EQ(located.fix->place, place(0));
  EXPECT_NEAR(along(located.fix->place_from_robot).distance_m, -0.05, 0.05);
}

TEST_F(BearingLocateTest, PlacesDescribedOtherwiseTellNothing) {
  BearingContent view = at(7.0);
  view.description = Description::brief;
  const auto located = method_.locate(chart_, {AlongPath{0.0, 0.04}}, {AlongPath{}, true, {}}, view);
  EXPECT_FALSE(located.fix);
  ASSERT_FALSE(located.refusals.empty());
  EXPECT_EQ(located.refusals.front().reason, "described_otherwise");
}

TEST_F(BearingLocateTest, AHeadingThatTheOthersDoNotTellIsNone) {
  // The nearest place says that the robot is turned by 0.3 rad, all others that it is not.
  around_[10].content = std::make_shared<const BearingContent>(at(7.0, 6.0, -0.3));
  const auto located =
      method_.locate(method_.chart(around_), {AlongPath{0.0, 0.04}}, {AlongPath{}, true, {}}, at(7.0));
  ASSERT_TRUE(located.fix);
  EXPECT_NEAR(along(located.fix->place_from_robot).heading_shift_rad, 0.0, 0.03);
}

/// Arranges a bend to the left in a room of 7 x 6 m, taught every 0.15 m.
class BearingBendTest : public testing::Test {
 protected:
  static agents::sim::Site room() {
    agents::sim::Site site = test::aisle_site();
    site.boxes.clear();
    for (const double y : {3.0, 9.0})
      site.boxes.push_back({agents::sim::Box::Kind::rack, "long", {12.0, y, 0.0}, 7.0, 0.8, 3.0});
    for (const double x : {8.5, 15.5})
      site.boxes.push_back({agents::sim::Box::Kind::rack, "short", {x, 6.0, M_PI / 2.0}, 4.6, 0.8, 3.0});
    return site;
  }
  static Pose2 path_at(double along_m) { return Pose2{12.0, 5.0, 0.0} * se2_exp({along_m, 0.0, along_m / 0.95}); }
  BearingContent at(const Pose2& site_from_robot) {
    return method_.extract({}, lookout_.from(site_from_robot)).value_or(BearingContent{});
  }

  test::Lookout lookout_{room()};
  Bearing method_ = *Bearing::make({}, lookout_.camera());
};

TEST_F(BearingBendTest, FarBesideTheWayItsHeadingIsTold) {
  std::vector<ChartPlace<BearingContent>> around;
  for (std::uint32_t i = 0; i <= 16; ++i) {
    const double ahead_m = 0.15 * i - 1.2;
    around.push_back({{ExperienceId{1}, i},
                      0,
                      AlongPath{ahead_m, 1e-4, ahead_m / 0.95},
                      std::make_shared<const BearingContent>(at(path_at(ahead_m)))});
  }
  const Bearing::Chart chart = method_.chart(around);
  for (const Pose2& aside : {Pose2{-0.4, -0.6, 0.2}, Pose2{-0.6, -0.4, 0.13}, Pose2{-0.6, 0.4, -0.13}}) {
    const auto located =
        method_.locate(chart, {AlongPath{0.0, 0.04}}, {AlongPath{}, true, {}}, at(path_at(0.0) * aside));
    EXPECT_TRUE(located.fix) << located.refusals.back().reason;
  }
}

TEST_F(BearingLocateTest, ItsBeliefIsWhatNavigationMakesOfIt) {
  const Bearing::Belief before{AlongPath{0.1, 0.04}};
  const Bearing::Belief now = method_.believed(chart_, before, {place(11), AlongPath{0.03, 1e-4, 0.02, 1e-4}, 0.0});
  EXPECT_NEAR(now.centre_from_robot.distance_m, 0.23, 1e-12);
}

/// Looks through a longer lens than its data sheet says: all things seem nearer, as from further ahead. Each fix
/// becomes where the robot believes to be, and it has come to believe something of the lens before.
class BearingOtherLensTest : public BearingLocateTest,
                             public testing::WithParamInterface<std::pair<double, double>> {};

TEST_P(BearingOtherLensTest, IsFoundOutOnTheWay) {
  const auto [error, believed_before] = GetParam();
  sim::Site site = test::aisle_site();
  site.forward_camera.focal_px *= 1.0 + error;
  test::Lookout other{site};
  Bearing::Belief belief{AlongPath{-1.0, 0.01}};
  if (believed_before != 0.0) belief.cameras.told({ExperienceId{}, {believed_before, 1e-4}}, 0.03);
  std::vector<double> off_m;
  for (int i = 0; i <= 120; ++i) {
    const double x = 5.5 + 0.025 * i;
    const Step step{AlongPath{i > 0 ? 0.025 : 0.5, 1e-6}, true, {}};
    const auto located = method_.locate(chart_, belief, step, seen(method_, other, {x, 6.0, 0.0}));
    if (!located.fix) continue;
    belief = method_.believed(chart_, located.belief, {located.fix->place, located.fix->place_from_robot, 0.0});
    off_m.push_back(along(located.fix->place_from_robot).distance_m - (x - (5.0 + 0.2 * located.fix->place.index)));
  }
  ASSERT_GT(off_m.size(), 100U);
  EXPECT_NEAR(std::abs(belief.cameras.of(ExperienceId{}, 0.01).share), error, 0.006);
  EXPECT_LT(std::abs(off_m.back()), 0.03);
}

INSTANTIATE_TEST_SUITE_P(Lenses, BearingOtherLensTest,
                         testing::Values(std::pair{0.02, 0.0}, std::pair{0.03, 0.0}, std::pair{0.0, 0.04},
                                         std::pair{0.0, -0.04}));

/// Shows that around a place that is only supposed to be where it is, nothing is learned for good.
TEST_F(BearingLocateTest, OfLensesOnlyViewsThatAreBelievedTell) {
  sim::Site site = test::aisle_site();
  site.forward_camera.focal_px *= 1.01;
  test::Lookout other{site};
  int looks = 0;
  for (double x = 6.6; x < 7.4; x += 0.05) {
    const auto located = method_.locate(chart_, {AlongPath{x - 7.0, 0.01}}, {AlongPath{}, true, {}},
                                        seen(method_, other, {x, 6.0, 0.0}));
    if (!located.belief.look) continue;
    ++looks;
    EXPECT_EQ(located.belief.cameras.of(ExperienceId{}, 0.01).share, 0.0);
    const Bearing::Belief now = method_.believed(chart_, located.belief, {place(10), AlongPath{}, 0.0});
    EXPECT_NE(now.cameras.of(ExperienceId{}, 0.01).share, 0.0);
  }
  EXPECT_GT(looks, 0);
}

TEST_F(BearingLocateTest, WhereNothingIsNearNothingIsSaid) {
  const auto located = method_.locate(chart_, {AlongPath{9.0, 0.04}}, {AlongPath{}, true, {}}, at(7.0));
  EXPECT_FALSE(located.fix);
  ASSERT_FALSE(located.refusals.empty());
  EXPECT_EQ(located.refusals.back().reason, "nothing_near");
}

TEST_F(BearingLocateTest, ABlindViewCorrectsNothing) {
  const auto located =
      method_.locate(chart_, {AlongPath{0.0, 0.04}}, {AlongPath{0.1, 0.0}, true, {}}, BearingContent{});
  EXPECT_FALSE(located.fix);
  EXPECT_NEAR(located.belief.centre_from_robot.distance_m, 0.1, 1e-12);
  for (const Refusal& refusal : located.refusals) EXPECT_EQ(refusal.reason, "few_features");
}

}  // namespace
}  // namespace weft::agents
