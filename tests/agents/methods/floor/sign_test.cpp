#include <gtest/gtest.h>

#include <algorithm>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

/// Tests which of many places a view may be of, before any is looked at closely.
namespace weft::agents {
namespace {

class FloorSign : public testing::Test {
 protected:
  static Floor make(const CameraModel& given) { return *Floor::make({}, given); }
  static FloorContent content(const Floor& method, const Pose2& at, const test::Shot& shot) {
    auto seen = test::look(method, *eye_, *floor_, at, {}, shot);
    if (!seen) throw std::runtime_error(std::string(seen.error().reason));
    return *std::move(seen);
  }
  static void SetUpTestSuite() {
    floor_ = std::make_unique<test::FlatFloor>(test::FlatFloor::procedural(3, 12.0, 8.0));
    eye_ = std::make_unique<test::FloorCamera>(test::paper_camera());
    const Floor method = make(test::paper_camera());
    for (double y = 2.0; y < 6.1; y += 0.5) {
      for (double x = 2.0; x < 9.1; x += 0.2) {
        places_.push_back({x, y, 0.0});
        signatures_.push_back(*method.sign(content(method, places_.back(), {.blur = {}, .seed = places_.size()})));
      }
    }
  }
  static void TearDownTestSuite() {
    floor_.reset();
    eye_.reset();
    places_.clear();
    signatures_.clear();
  }
  /// Returns how many places seem nearer than every one within 0.25 m of where `method` looks, 40 times; sorted.
  static std::vector<std::size_t> ranks(const Floor& method, double heading, double gain) {
    Random random(5);
    std::vector<std::size_t> ranks;
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pose2 place = places_[random.below(places_.size())];
      // What is seen lies ahead: the robot stands where it sees about the same floor.
      const Pose2 middle{0.75, 0.0, 0.0};
      const Pose2 off{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), heading + random.uniform(-0.1, 0.1)};
      const Pose2 at = place * middle * off * middle.inverse();
      const Signature here = *method.sign(content(method, at, {.gain = gain, .blur = {}, .seed = 1000 + i}));
      double nearest = 1e9;
      for (std::size_t k = 0; k < places_.size(); ++k) {
        if ((places_[k].translation() - place.translation()).norm() < 0.25)
          nearest = std::min(nearest, distance2(here, signatures_[k]));
      }
      ranks.push_back(static_cast<std::size_t>(std::count_if(
          signatures_.begin(), signatures_.end(), [&](const Signature& s) { return distance2(here, s) < nearest; })));
    }
    std::sort(ranks.begin(), ranks.end());
    return ranks;
  }

  static inline std::unique_ptr<test::FlatFloor> floor_;
  static inline std::unique_ptr<test::FloorCamera> eye_;
  static inline std::vector<Pose2> places_;
  static inline std::vector<Signature> signatures_;
};

// By chance the median would be 120 of 324 places. What one view's seeking relates is 12.
TEST_F(FloorSign, PutsTheRightPlaceAmongTheFirst) {
  const std::vector<std::size_t> found = ranks(make(test::paper_camera()), 0.0, 1.0);
  EXPECT_LE(found[20], 1U);
  EXPECT_LT(found[36], 12U);
}

TEST_F(FloorSign, ForAnotherRobotInHalfTheLightTooWhicheverWayItLooks) {
  const Floor other = make(test::miscalibrated(test::paper_camera(), 9));
  for (const double heading : {0.0, M_PI / 2, M_PI}) {
    const std::vector<std::size_t> found = ranks(other, heading, 0.5);
    EXPECT_LT(found[20], 6U) << heading;
    EXPECT_LT(found[36], 40U) << heading;
  }
}

TEST_F(FloorSign, IsTheSameForTheSameContentAndNoneWithoutFeatures) {
  const Floor method = make(test::paper_camera());
  const FloorContent seen = content(method, places_.front(), {.blur = {}, .seed = 1});
  EXPECT_EQ(method.sign(seen), signatures_.front());
  EXPECT_EQ(method.sign(*method.decode(method.encode(seen))), signatures_.front());
  EXPECT_FALSE(method.sign(FloorContent{}));
}

}  // namespace
}  // namespace weft::agents
