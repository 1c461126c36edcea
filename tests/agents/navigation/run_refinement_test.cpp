#include "agents/navigation/run_refinement.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/support/refining_marks.hpp"

namespace weft::agents {
namespace {

constexpr ExperienceId kTaught{1};

RefiningMarks::Content a_content(std::uint32_t index) {
  RefiningMarks::Content content;
  content.sightings.push_back({index, Pose2{1.0, 0.0, 0.0}});
  return content;
}

Kept a_kept(const RefiningMarks& method, std::uint32_t index) {
  Kept kept;
  kept.place.id = {kTaught, index};
  kept.content = method.encode(a_content(index));
  if (index == 0) return kept;
  Edge edge;
  edge.id = {{kTaught, index - 1}, {kTaught, index}};
  edge.a_from_b = Metric2{Pose2{0.5, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4};
  kept.edges.push_back(edge);
  edge.id.a = {ExperienceId{2}, 7};
  edge.origin = Origin::stitch;
  kept.edges.push_back(edge);
  return kept;
}

struct DraftOfMarks : testing::Test {
  void add(std::uint32_t places) {
    for (std::uint32_t i = 0; i < places; ++i) ASSERT_TRUE(refinement.add(a_kept(method, i)));
  }
  int pieces() {
    int pieces = 1;
    while (refinement.piece()) ++pieces;
    return pieces;
  }
  RefiningMarks method;
  RunRefinement<RefiningMarks> refinement{method};
};

TEST_F(DraftOfMarks, IsRefinedPieceByPieceAndSaysHowFarItIs) {
  add(25);
  EXPECT_EQ(refinement.progress(), RefineProgress{}) << "nothing has begun";
  EXPECT_TRUE(refinement.piece());
  EXPECT_EQ(refinement.progress(), (RefineProgress{0, 3}));
  EXPECT_TRUE(refinement.piece());
  EXPECT_EQ(refinement.progress(), (RefineProgress{1, 3}));
  EXPECT_TRUE(refinement.piece());
  EXPECT_FALSE(refinement.piece());
  EXPECT_EQ(refinement.progress(), (RefineProgress{3, 3}));
  EXPECT_FALSE(refinement.piece()) << "it stays done";
}

TEST_F(DraftOfMarks, AmendsWhatTheMethodSaysAndNothingElse) {
  add(12);
  EXPECT_EQ(pieces(), 3) << "the first begins";
  const RunAmendments amendments = refinement.amendments();
  ASSERT_EQ(amendments.edges.size(), 11U) << "not what joins it to others";
  for (const AmendedEdge& edge : amendments.edges) {
    EXPECT_EQ(edge.edge.b.index, edge.edge.a.index + 1);
    EXPECT_DOUBLE_EQ(planar(edge.a_from_b).x, 0.5 + RefiningMarks::shift_m);
    EXPECT_TRUE(RefiningMarks::is_refined(edge.a_from_b));
  }
  ASSERT_EQ(amendments.places.size(), 12U);
  const auto content = method.decode(amendments.places[3].content);
  ASSERT_TRUE(content);
  EXPECT_DOUBLE_EQ(content->sightings.front().robot_from_mark.x, 1.0 - RefiningMarks::shift_m);
}

TEST_F(DraftOfMarks, WithoutPlacesHasNothingToAmend) {
  EXPECT_EQ(pieces(), 2);
  EXPECT_TRUE(refinement.amendments().edges.empty());
}

TEST_F(DraftOfMarks, RefusesAContentThatIsNoneOfTheMethods) {
  Kept kept = a_kept(method, 0);
  kept.content.pop_back();
  const Result<void> added = refinement.add(kept);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, ErrorCode::corrupt);
}

TEST_F(DraftOfMarks, TwiceTheSameRunIsRefinedTheSame) {
  add(12);
  pieces();
  RunRefinement<RefiningMarks> again{method};
  for (std::uint32_t i = 0; i < 12; ++i) ASSERT_TRUE(again.add(a_kept(method, i)));
  while (again.piece()) {
  }
  const RunAmendments one = refinement.amendments();
  const RunAmendments other = again.amendments();
  ASSERT_EQ(one.places.size(), other.places.size());
  for (std::size_t i = 0; i < one.places.size(); ++i) EXPECT_EQ(one.places[i].content, other.places[i].content);
}

}  // namespace
}  // namespace weft::agents
