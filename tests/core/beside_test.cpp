#include "core/network/beside.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/network/change.hpp"

namespace weft {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr ExperienceId kTaughtLane{1};
constexpr ExperienceId kStub{2};

/// Returns a lane of places 0.25 m apart, and a place of another run at `lane_from_stub` of its third place.
Snapshot lane_and(const Pose2& lane_from_stub) {
  const auto edge = [](const PlaceId& a, const PlaceId& b, const Pose2& a_from_b, Drivable drivable) {
    Edge made;
    made.id = {a, b};
    made.a_from_b = Metric2{a_from_b, Eigen::Matrix3d::Identity() * 1e-6};
    made.origin = drivable == Drivable::none ? Origin::stitch : Origin::odometry;
    made.method = "marks";
    made.drivable = drivable;
    return made;
  };
  const auto place = [](const PlaceId& id) {
    Place made;
    made.id = id;
    made.method = "marks";
    made.content.hash.bytes[0] = 1;
    made.content.size = 1;
    return made;
  };
  Batch first;
  first.experience = kTaughtLane;
  first.sequence = 1;
  first.method = "marks";
  for (std::uint32_t index = 0; index < 8; ++index) {
    first.places.push_back(place({kTaughtLane, index}));
    if (index > 0)
      first.edges.push_back(edge({kTaughtLane, index - 1}, {kTaughtLane, index}, {0.25, 0, 0}, Drivable::a_to_b));
  }
  Batch second;
  second.experience = kStub;
  second.sequence = 1;
  second.method = "marks";
  second.places.push_back(place({kStub, 0}));
  second.edges.push_back(edge({kTaughtLane, 2}, {kStub, 0}, lane_from_stub, Drivable::none));
  return with(with(Snapshot{}, first), second);
}

TEST(PlacesBeside, NearestFirstWhicheverWayTheyAreDriven) {
  EXPECT_THAT(places_beside(lane_and({0.1, 0.1, 0.0}), {kStub, 0}),
              ElementsAre(PlaceId{kTaughtLane, 2}, PlaceId{kTaughtLane, 3}, PlaceId{kTaughtLane, 1}));
}

TEST(PlacesBeside, NoneFartherAwayThanARobotChangesOver) {
  EXPECT_THAT(places_beside(lane_and({0.0, 0.41, 0.0}), {kStub, 0}), IsEmpty());
}

TEST(PlacesBeside, NoneThatLookAnotherWay) {
  EXPECT_THAT(places_beside(lane_and({0.0, 0.0, 0.6}), {kStub, 0}), IsEmpty());
  EXPECT_THAT(places_beside(lane_and({0.0, 0.0, M_PI}), {kStub, 0}), IsEmpty());
}

TEST(PlacesBeside, NoneWithoutThePlace) {
  EXPECT_THAT(places_beside(lane_and({0.0, 0.0, 0.0}), {ExperienceId{9}, 0}), IsEmpty());
}

}  // namespace
}  // namespace weft
