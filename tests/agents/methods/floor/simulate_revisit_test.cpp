#include <gtest/gtest.h>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

class FloorSimulatesRevisits : public testing::Test {
 protected:
  View view(double contrast = 18.0) const {
    View seen;
    seen.frame = 12;
    seen.data = eye.render(test::FlatFloor::procedural(5, 6.0, 4.0, contrast), {2.0, 2.0, 0.0}, {}, {});
    return seen;
  }
  /// Relates what the other robot sees under that condition to what this one has seen; an error: it is not found.
  OrRefusal<Related> found(const View& seen, const Revisit& revisit) const {
    const OrRefusal<View> other = method.simulate_view(seen, revisit);
    if (!other) return tl::unexpected(other.error());
    const auto here = method.extract({}, seen);
    const auto there = method.extract({}, *other);
    if (!here) return tl::unexpected(here.error());
    if (!there) return tl::unexpected(there.error());
    return method.relate(*here, *there, Metric2{revisit.robot_from_other});
  }

  const Floor method = *Floor::make({}, test::paper_camera());
  const test::FloorCamera eye{test::paper_camera()};
};

TEST_F(FloorSimulatesRevisits, TheOtherRobotStandsWhereItIsSaidTo) {
  const View seen = view();
  for (const auto condition : {Floor::as_is, Floor::half_light, Floor::worn}) {
    const Revisit revisit{condition, {0.0, -0.07, 0.05}, 3};
    const OrRefusal<Related> related = found(seen, revisit);
    ASSERT_TRUE(related) << related.error().reason;
    const Pose2 off = revisit.robot_from_other.inverse() * planar(related->a_from_b);
    EXPECT_LT(off.translation().norm(), 0.015);
    EXPECT_LT(std::abs(off.heading), 0.015);
  }
}

TEST_F(FloorSimulatesRevisits, IsOfTheSameCameraAndFrame) {
  const View seen = view();
  const OrRefusal<View> other = method.simulate_view(seen, {Floor::half_light, {}, 1});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->frame, seen.frame);
  EXPECT_EQ(std::get<Image>(other->data).width, std::get<Image>(seen.data).width);
}

TEST_F(FloorSimulatesRevisits, ReturnsWhatTheOtherRobotExtracts) {
  const View seen = view();
  const Revisit revisit{Floor::worn, {0.0, 0.04, 0.02}, 5};
  const OrRefusal<Revisited<FloorContent>> other = method.simulate_revisit({}, seen, revisit);
  ASSERT_TRUE(other) << other.error().reason;
  EXPECT_EQ(other->robot_from_other, revisit.robot_from_other);
  EXPECT_EQ(method.encode(other->content), method.encode(*method.extract({}, *method.simulate_view(seen, revisit))));
}

TEST_F(FloorSimulatesRevisits, WorseConditionsLeaveLessToFind) {
  const View faint = view(2.0);
  const auto inliers = [&](Floor::Condition condition) {
    const OrRefusal<Related> related = found(faint, {condition, {0.0, 0.05, 0.03}, 3});
    return related ? related->inliers : 0U;
  };
  EXPECT_GT(inliers(Floor::as_is), inliers(Floor::half_light));
  EXPECT_GT(inliers(Floor::as_is), inliers(Floor::worn));
}

TEST_F(FloorSimulatesRevisits, RefusesWhatIsNoImageOfItsCamera) {
  View marks;
  marks.data = Payload{};
  ASSERT_FALSE(method.simulate_view(marks, {}));
  EXPECT_EQ(method.simulate_view(marks, {}).error().reason, "not_an_image");
  View small;
  small.data = Image{2, 2, std::make_shared<const Bytes>(4)};
  ASSERT_FALSE(method.simulate_view(small, {}));
  EXPECT_EQ(method.simulate_view(small, {}).error().reason, "wrong_size");
}

}  // namespace
}  // namespace weft::agents
