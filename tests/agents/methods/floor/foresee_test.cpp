#include <gtest/gtest.h>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

class FloorForesee : public testing::Test {
 protected:
  View view(double contrast = 18.0) const {
    View seen;
    seen.frame = 12;
    seen.data = eye.render(test::FlatFloor::procedural(5, 6.0, 4.0, contrast), {2.0, 2.0, 0.0}, {}, {});
    return seen;
  }
  /// Whether what the other robot sees under that prospect is found in what this one has seen.
  OrRefusal<Related> found(const View& seen, const Passing& passing) const {
    const OrRefusal<View> other = method.foresee(seen, passing);
    if (!other) return tl::unexpected(other.error());
    const auto here = method.extract({}, seen);
    const auto there = method.extract({}, *other);
    if (!here) return tl::unexpected(here.error());
    if (!there) return tl::unexpected(there.error());
    return method.relate(*here, *there, Metric2{passing.robot_from_other});
  }

  const Floor method = *Floor::make({}, test::paper_camera());
  const test::FloorCamera eye{test::paper_camera()};
};

TEST_F(FloorForesee, TheOtherRobotStandsWhereItIsSaidTo) {
  const View seen = view();
  for (const Prospect prospect : {Prospect::as_is, Prospect::half_light, Prospect::worn}) {
    const Passing passing{prospect, {0.0, -0.07, 0.05}, 3};
    const OrRefusal<Related> related = found(seen, passing);
    ASSERT_TRUE(related) << related.error().reason;
    const Pose2 off = passing.robot_from_other.inverse() * planar(related->a_from_b);
    EXPECT_LT(off.translation().norm(), 0.015);
    EXPECT_LT(std::abs(off.heading), 0.015);
  }
}

TEST_F(FloorForesee, IsOfTheSameCameraAndFrame) {
  const View seen = view();
  const OrRefusal<View> other = method.foresee(seen, {Prospect::half_light, {}, 1});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->frame, seen.frame);
  EXPECT_EQ(std::get<Image>(other->data).width, std::get<Image>(seen.data).width);
}

TEST_F(FloorForesee, WorseProspectsLeaveLessToFind) {
  const View faint = view(2.0);
  const auto inliers = [&](Prospect prospect) {
    const OrRefusal<Related> related = found(faint, {prospect, {0.0, 0.05, 0.03}, 3});
    return related ? related->inliers : 0U;
  };
  EXPECT_GT(inliers(Prospect::as_is), inliers(Prospect::half_light));
  EXPECT_GT(inliers(Prospect::as_is), inliers(Prospect::worn));
}

TEST_F(FloorForesee, RefusesWhatIsNoImageOfItsCamera) {
  View marks;
  marks.data = Payload{};
  ASSERT_FALSE(method.foresee(marks, {}));
  EXPECT_EQ(method.foresee(marks, {}).error().reason, "not_an_image");
  View small;
  small.data = Image{2, 2, std::make_shared<const Bytes>(4)};
  ASSERT_FALSE(method.foresee(small, {}));
  EXPECT_EQ(method.foresee(small, {}).error().reason, "wrong_size");
}

}  // namespace
}  // namespace weft::agents
