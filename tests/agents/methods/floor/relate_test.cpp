#include <gtest/gtest.h>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

// What a stitch needs is 100 mm and 3 degrees; with one calibration runs show at most 4 mm and 0.2 degrees.
constexpr double kOffM = 0.015;
constexpr double kOffDeg = 0.5;

class FloorRelate : public testing::Test {
 protected:
  static Floor make(const CameraModel& given) {
    auto made = Floor::make({}, given);
    if (!made) throw std::runtime_error(made.error().message);
    return *made;
  }
  static void SetUpTestSuite() {
    floor_ = std::make_unique<test::FlatFloor>(test::FlatFloor::procedural(9, 12.0, 8.0));
    eye_ = std::make_unique<test::FloorCamera>(test::paper_camera());
  }
  static void TearDownTestSuite() {
    floor_.reset();
    eye_.reset();
  }
  static FloorContent content(const Floor& method, const Pose2& at, const test::Shot& shot,
                              const Attitude& attitude = {}) {
    auto seen = test::look(method, *eye_, *floor_, at, attitude, shot);
    if (!seen) throw std::runtime_error(std::string(seen.error().reason));
    // As another robot would get it: through bytes.
    return *method.decode(method.encode(*seen));
  }
  static std::optional<Relation> about(const Pose2& a_from_b, Random& random) {
    return Metric2{
        a_from_b * Pose2{random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), random.uniform(-0.1, 0.1)},
        Eigen::Matrix3d::Zero()};
  }
  static void expect_right(const OrRefusal<Related>& related, const Pose2& truth, double off_m, double off_deg) {
    ASSERT_TRUE(related) << related.error().reason << " " << related.error().measured << " against "
                         << related.error().bound;
    const Pose2 off = truth.inverse() * planar(related->a_from_b);
    EXPECT_LT(off.translation().norm(), off_m);
    EXPECT_LT(std::abs(off.heading) * 180.0 / M_PI, off_deg);
    EXPECT_GE(related->inliers, 20U);
    EXPECT_GT(related->overlap, 0.1);
    EXPECT_TRUE(check(related->a_from_b));
  }

  static inline std::unique_ptr<test::FlatFloor> floor_;
  static inline std::unique_ptr<test::FloorCamera> eye_;
  static inline const std::vector<Pose2> kOffsets{{0.1, 0.0, 0.0},   {0.25, 0.05, 0.05},  {0.5, 0.05, 0.1},
                                                  {0.5, 0.0, 0.436}, {-0.5, 0.1, -0.436}, {0.0, 0.5, 0.0},
                                                  {-0.3, 0.0, -0.2}, {1.8, 0.0, 3.14159}};
};

TEST_F(FloorRelate, OffsetsAndHeadingsWithAndWithoutAGuess) {
  const Floor method = make(test::paper_camera());
  Random random(41);
  test::Shot shot;
  const Pose2 at{3.0, 4.0, 0.7};
  const FloorContent a = content(method, at, shot);
  for (const Pose2& a_from_b : kOffsets) {
    SCOPED_TRACE(testing::Message() << a_from_b.x << " " << a_from_b.y << " " << a_from_b.heading);
    shot.seed++;
    const FloorContent b = content(method, at * a_from_b, shot, {0.0008, -0.0006, 0.001});
    expect_right(method.relate(a, b, about(a_from_b, random)), a_from_b, kOffM, kOffDeg);
    expect_right(method.relate(a, b, std::nullopt), a_from_b, kOffM, kOffDeg);
  }
}

TEST_F(FloorRelate, ARobotThatHasSunkIsSeenToStandLower) {
  const Floor method = make(test::paper_camera());
  Random random(43);
  const Pose2 at{3.0, 4.0, 0.7};
  const FloorContent place = content(method, at, {});
  for (const double offset_m : {0.0, -0.01, 0.006}) {
    test::Shot shot;
    shot.seed += 5;
    const Pose2 place_from_robot{0.2, 0.03, 0.05};
    const FloorContent now = content(method, at * place_from_robot, shot, {0.0, 0.0, offset_m});
    const auto related = method.relate(place, now, about(place_from_robot, random));
    ASSERT_TRUE(related) << related.error().reason;
    ASSERT_EQ(related->diagnostics.size(), 1U);
    EXPECT_EQ(related->diagnostics[0].name, "height_offset_m");
    EXPECT_NEAR(related->diagnostics[0].value, offset_m, 0.002);
    EXPECT_LE(related->diagnostics[0].sigma, 0.002);
  }
}

TEST_F(FloorRelate, HalfTheLightAShadowEdgeAndBlur) {
  const Floor method = make(test::paper_camera());
  Random random(42);
  const Pose2 at{3.2, 3.6, -1.2};
  const FloorContent a = content(method, at, {});
  test::Shot dark;
  dark.gain = 0.5;
  dark.shadow = true;
  dark.blur = {0.005, 0.0, 0.002};
  for (const Pose2& a_from_b : kOffsets) {
    SCOPED_TRACE(testing::Message() << a_from_b.x << " " << a_from_b.y << " " << a_from_b.heading);
    dark.seed++;
    expect_right(method.relate(a, content(method, at * a_from_b, dark), about(a_from_b, random)), a_from_b, kOffM,
                 kOffDeg);
  }
}

TEST_F(FloorRelate, TwoRobotsWithOtherCalibrations) {
  // What the mounts' position (3 mm) and heading (0.3 degrees, 1 sigma each) are wrong by cannot be seen and stays.
  Random random(43);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Floor one = make(test::miscalibrated(test::paper_camera(), 10 + seed));
    const Floor other = make(test::miscalibrated(test::paper_camera(), 30 + seed));
    const Pose2 at{3.0, 3.0 + 0.5 * static_cast<double>(seed), 0.4};
    const FloorContent a = content(one, at, {});
    for (const Pose2& a_from_b : {Pose2{0.1, 0.05, 0.05}, Pose2{0.4, 0.1, -0.2}}) {
      test::Shot shot;
      shot.seed = seed + 70;
      shot.gain = 0.7;
      const auto related = one.relate(a, content(other, at * a_from_b, shot), about(a_from_b, random));
      expect_right(related, a_from_b, 0.030, 1.3);
      const Eigen::Vector3d error = se2_log(planar(related->a_from_b).inverse() * a_from_b);
      EXPECT_LT(error.dot(planar_covariance(related->a_from_b).inverse() * error), 20.0) << "the covariance knows";
    }
  }
}

TEST_F(FloorRelate, IsTheSameTwice) {
  const Floor method = make(test::paper_camera());
  const FloorContent a = content(method, {3.0, 4.0, 0.0}, {});
  const FloorContent b = content(method, {3.3, 4.0, 0.1}, {});
  const auto first = method.relate(a, b, std::nullopt);
  const auto second = method.relate(a, b, std::nullopt);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(planar(first->a_from_b), planar(second->a_from_b));
}

TEST_F(FloorRelate, WrongPairsAreRefused) {
  const Floor method = make(test::paper_camera());
  Random random(44);
  std::vector<Pose2> at;
  std::vector<FloorContent> contents;
  // Views look ahead by up to 1.5 m: places on a ring, looking outwards or along, see floors of their own.
  for (int i = 0; i < 18; ++i) {
    test::Shot shot;
    shot.seed = static_cast<std::uint64_t>(i);
    at.push_back(
        {2.0 + 2.0 * (i % 5), 2.0 + 2.0 * ((i / 5) % 3) + random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0)});
    contents.push_back(content(method, at.back(), shot));
  }
  int tried = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = 0; j < at.size(); ++j) {
      const Eigen::Vector2d centre_i = at[i] * Eigen::Vector2d(0.9, 0.0);
      const Eigen::Vector2d centre_j = at[j] * Eigen::Vector2d(0.9, 0.0);
      if ((centre_i - centre_j).norm() < 2.2) continue;  // may share floor
      const Pose2 lie{random.uniform(-0.3, 0.4), random.uniform(-0.2, 0.2), random.uniform(-0.3, 0.3)};
      for (const auto& guess :
           {std::optional<Relation>(Metric2{lie, Eigen::Matrix3d::Zero()}), std::optional<Relation>()}) {
        const auto related = method.relate(contents[i], contents[j], guess);
        EXPECT_FALSE(related) << i << " " << j << " with " << related->inliers << " inliers";
        ++tried;
      }
    }
  EXPECT_GT(tried, 200);
}

TEST_F(FloorRelate, AWrongGuessIsNotBentToFit) {
  const Floor method = make(test::paper_camera());
  const FloorContent a = content(method, {3.0, 4.0, 0.0}, {});
  const FloorContent b = content(method, {3.3, 4.0, 0.0}, {});
  const auto related = method.relate(a, b, Metric2{{0.3, 0.45, 0.0}, Eigen::Matrix3d::Zero()});
  ASSERT_FALSE(related);
  EXPECT_GT(related.error().measured, -1.0);
  EXPECT_EQ(method.relate(a, b, Metric2{{9.0, 0.0, 0.0}, Eigen::Matrix3d::Zero()}).error().reason, "no_overlap");
}

TEST_F(FloorRelate, AFloorThatRepeatsItselfIsNoPlace) {
  const Floor method = make(test::paper_camera());
  constexpr double tile_m = 0.3;
  const test::FlatFloor tiles = test::FlatFloor::tiled(3, tile_m, 9.0, 6.0);
  const Pose2 at{3.0, 3.0, 0.3};
  const auto look = [&](const Pose2& from, std::uint64_t seed) {
    test::Shot shot;
    shot.seed = seed;
    return *test::look(method, *eye_, tiles, from, {}, shot);
  };
  const FloorContent place = look(at, 1);
  const Pose2 place_from_robot{0.12, 0.03, 0.1};
  const FloorContent near = look(at * place_from_robot, 2);
  const FloorContent far = look(Pose2{8 * tile_m, 2 * tile_m, 0.0} * at * place_from_robot, 3);
  const Relation guess = Metric2{place_from_robot, Eigen::Matrix3d::Zero()};
  for (const FloorContent& view : {near, far}) {
    EXPECT_FALSE(method.relate(place, view, std::nullopt));
    EXPECT_FALSE(method.relate(place, view, guess));
  }
  // Tiles agree with the guess, and with others beside it.
  const auto related = method.relate(place, near, guess);
  EXPECT_EQ(related.error().reason, "ambiguous");
  EXPECT_GT(related.error().measured, related.error().bound);
}

TEST_F(FloorRelate, AGuessTellsWideTilesApart) {
  const Floor method = make(test::paper_camera());
  const test::FlatFloor tiles = test::FlatFloor::tiled(4, 0.75, 9.0, 6.0);
  const Pose2 at{3.0, 3.0, 0.0};
  const Pose2 place_from_robot{0.1, 0.02, 0.05};
  const auto place = test::look(method, *eye_, tiles, at, {}, {});
  test::Shot other;
  other.seed = 2;
  const auto view = test::look(method, *eye_, tiles, at * place_from_robot, {}, other);
  ASSERT_TRUE(place && view);
  expect_right(method.relate(*place, *view, Metric2{place_from_robot, Eigen::Matrix3d::Zero()}), place_from_robot,
               kOffM, kOffDeg);
  const auto unguided = method.relate(*place, *view, std::nullopt);
  ASSERT_FALSE(unguided);
  EXPECT_EQ(unguided.error().reason, "ambiguous");
}

TEST_F(FloorRelate, ABlankFloorIsNoPlace) {
  const Floor method = make(test::paper_camera());
  test::Shot quiet;
  quiet.noise = 0.0;
  const auto seen = test::look(method, *eye_, test::FlatFloor::blank(6.0, 6.0), {3.0, 3.0, 0.0}, {}, quiet);
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().reason, "too_blank");
  EXPECT_LT(seen.error().measured, seen.error().bound);
}

TEST_F(FloorRelate, NoiseOnABlankFloorRelatesToNothing) {
  const Floor method = make(test::paper_camera());
  const test::FlatFloor blank = test::FlatFloor::blank(6.0, 6.0);
  const test::Shot first;
  test::Shot second;
  second.seed = 2;
  const auto a = test::look(method, *eye_, blank, {3.0, 3.0, 0.0}, {}, first);
  const auto b = test::look(method, *eye_, blank, {3.0, 3.0, 0.0}, {}, second);
  if (!a || !b) return;  // too_blank is as good
  EXPECT_FALSE(method.relate(*a, *b, Metric2{}));
}

TEST_F(FloorRelate, DamagedContentsThatDecodeDoNoHarm) {
  const Floor method = make(test::paper_camera());
  const FloorContent a = content(method, {3.0, 4.0, 0.0}, {});
  const Pose2 a_from_b{0.2, 0.0, 0.0};
  const Bytes good = method.encode(content(method, {3.2, 4.0, 0.0}, {}));
  Random random(45);
  int decoded = 0;
  for (int trial = 0; trial < 300 && decoded < 40; ++trial) {
    Bytes bytes = good;
    for (int k = 0; k < 4; ++k) bytes[8 + random.below(200)] = static_cast<std::uint8_t>(random.below(256));
    const auto b = method.decode(bytes);
    if (!b) continue;
    ++decoded;
    for (const auto& guess :
         {std::optional<Relation>(Metric2{a_from_b, Eigen::Matrix3d::Zero()}), std::optional<Relation>()}) {
      const auto related = method.relate(a, *b, guess);
      if (related) {
        EXPECT_TRUE(check(related->a_from_b));
      }
    }
  }
  EXPECT_GT(decoded, 5);
}

/// Arranges two floors equal in one patch alone: a worn stencil, a mended slab, a photograph's crop used twice.
TEST_F(FloorRelate, APatchThatLooksTheSameElsewhereIsNoPlace) {
  const Floor method = make(test::paper_camera());
  const FloorContent a = content(method, {3.2, 4.0, 0.0}, {});
  FloorContent b = content(method, {8.0, 2.0, 1.0}, {});
  const Pose2 b_from_a{0.1, 0.3, 0.2};
  const auto in_patch = [](const Eigen::Vector2d& p) {
    return (p - Eigen::Vector2d(0.8, 0.1)).cwiseAbs().maxCoeff() < 0.2;
  };
  std::erase_if(b.features, [&](const PlaneFeature& f) { return in_patch(b_from_a.inverse() * f.on_plane); });
  std::size_t same = 0;
  for (PlaneFeature feature : a.features) {
    if (!in_patch(feature.on_plane)) continue;
    feature.on_plane = b_from_a * feature.on_plane;
    feature.heading_rad += b_from_a.heading;
    b.features.push_back(feature);
    ++same;
  }
  ASSERT_GT(same, 24U);
  const auto related = method.relate(a, b, std::nullopt);
  ASSERT_FALSE(related);
  EXPECT_EQ(related.error().reason, "little_spread") << related.error().measured;
}

TEST_F(FloorRelate, APlaceIsAtMost40Kilobytes) {
  const Floor method = make(test::paper_camera());
  EXPECT_LT(method.encode(content(method, {3.0, 4.0, 0.0}, {})).size(), 40000U);
}

}  // namespace
}  // namespace weft::agents
