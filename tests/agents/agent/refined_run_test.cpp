#include "agents/agent/refined_run.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/network/codec.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {

constexpr ExperienceId kDraft{1};

std::vector<Batch> a_draft() {
  std::vector<Batch> batches(2);
  for (std::uint32_t i = 0; i < 4; ++i) {
    Batch& batch = batches[i / 2];
    batch.experience = kDraft;
    batch.sequence = i / 2 + 1;
    batch.places.push_back(a_place(kDraft, i, {}, some_content(i, 50)));
    if (i > 0) batch.edges.push_back(an_edge({kDraft, i - 1}, {kDraft, i}));
  }
  batches.back().seal = true;
  batches.back().seal_reason = "for now";
  return batches;
}

Relation moved(double x) {
  return Metric2{Pose2{x, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4};
}

RunAmendments one_edge(std::uint32_t from, const Relation& a_from_b) {
  RunAmendments amendments;
  amendments.edges.push_back({{{kDraft, from}, {kDraft, from + 1}}, a_from_b});
  return amendments;
}

std::string refusal_of(RunAmendments amendments) {
  const Result<RefinedRun> run = make_refined_run(a_draft(), std::move(amendments), "done");
  EXPECT_FALSE(run);
  if (run) return {};
  EXPECT_EQ(run.error().code, ErrorCode::invalid);
  return run.error().message;
}

TEST(RefinedRun, HasTheSameBatchesWithWhatWasAmended) {
  RunAmendments amendments = one_edge(2, moved(1.5));
  amendments.places.push_back({{kDraft, 1}, some_content(77, 60)});
  const Result<RefinedRun> run = make_refined_run(a_draft(), std::move(amendments), "done");
  ASSERT_TRUE(run) << run.error().message;
  std::vector<Batch> expected = a_draft();
  expected[1].edges.back().a_from_b = moved(1.5);
  expected[1].seal_reason = "done";
  expected[0].places[1].content = {hash_bytes(some_content(77, 60)), 60};
  ASSERT_EQ(run->batches.size(), 2U);
  EXPECT_EQ(hash(run->batches[0]), hash(expected[0]));
  EXPECT_EQ(hash(run->batches[1]), hash(expected[1]));
  EXPECT_EQ(run->contents, std::vector<Bytes>{some_content(77, 60)});
}

TEST(RefinedRun, WithoutAmendmentsIsTheDraftButForItsSeal) {
  const Result<RefinedRun> run = make_refined_run(a_draft(), {}, "done");
  ASSERT_TRUE(run);
  EXPECT_EQ(hash(run->batches[0]), hash(a_draft()[0]));
  EXPECT_EQ(run->batches[1].seal_reason, "done");
  EXPECT_TRUE(run->contents.empty());
}

TEST(RefinedRun, RefusesWhatTheServerWouldRefuse) {
  EXPECT_NE(refusal_of(one_edge(3, moved(1.0))).find("has no edge"), std::string::npos);
  EXPECT_NE(refusal_of(one_edge(1, moved(std::numeric_limits<double>::infinity()))).find("not finite"),
            std::string::npos);
  EXPECT_NE(refusal_of(one_edge(1, Metric3{{}, Matrix6d(Matrix6d::Identity() * 1e-4)})).find("another kind"),
            std::string::npos);
  RunAmendments elsewhere;
  elsewhere.places.push_back({{kDraft, 9}, some_content(1, 10)});
  EXPECT_NE(refusal_of(std::move(elsewhere)).find("has no place"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
