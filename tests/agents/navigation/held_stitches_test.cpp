#include "agents/navigation/held_stitches.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

constexpr ExperienceId kRunBefore{1};
constexpr ExperienceId kRunNow{2};

Edge stitch(std::uint32_t index) {
  Edge edge;
  edge.id = {PlaceId{kRunBefore, index}, PlaceId{kRunNow, index}};
  edge.origin = Origin::stitch;
  return edge;
}

/// Returns what a place shows that is stitched to another run, or that something speaks against.
HeldStitches::AtPlace found(std::vector<Edge> stitches, double contradiction = 0.0) {
  return {true, std::move(stitches), {{kRunBefore, contradiction}}};
}

TEST(HeldStitches, AShortWayBesideOthersIsHeldUntilTheRunEnds) {
  HeldStitches held{StitchConfig{}};
  for (std::uint32_t i = 0; i < 10; ++i) {
    held.take(found({stitch(i)}), 0.5 * i);
    EXPECT_TRUE(held.proven(0.5 * i).empty());
  }
  EXPECT_EQ(held.beside(), (PlaceId{kRunBefore, 9}));
  EXPECT_EQ(held.rest().size(), 10U);
  EXPECT_TRUE(held.rest().empty()) << "each is handed in once";
  EXPECT_FALSE(held.beside());
}

TEST(HeldStitches, ALongOneIsProvenOnTheWay) {
  HeldStitches held{StitchConfig{}};
  std::size_t handed_in = 0;
  for (std::uint32_t i = 0; i <= 130; ++i) {
    held.take(found({stitch(i)}), 0.5 * i);
    handed_in += held.proven(0.5 * i).size();
    EXPECT_EQ(handed_in, 0.5 * i > 60.0 ? i + 1U : 0U);
  }
  held.take(found({}, 100.0), 66.0);
  EXPECT_FALSE(held.disproved()) << "it is proven";
}

TEST(HeldStitches, AWayOnWhichNothingWasRecognisedProvesLittle) {
  HeldStitches held{StitchConfig{}};
  held.take(found({stitch(0)}), 0.0);
  for (double at_m = 1.0; at_m < 61.0; at_m += 1.0) held.take(found({}), at_m);
  held.take(found({stitch(1)}), 61.0);
  EXPECT_TRUE(held.proven(61.0).empty());
}

TEST(HeldStitches, WhereTheWayPartsTheyAreHandedInAndItIsProvenAnew) {
  HeldStitches held{StitchConfig{}};
  for (std::uint32_t i = 0; i <= 130; ++i) {
    held.take(found({stitch(i)}), 0.5 * i);
    held.proven(0.5 * i);
  }
  held.take(found({stitch(131)}), 65.5);
  held.take({}, 75.4);
  EXPECT_EQ(held.proven(75.4).size(), 1U);
  held.take({}, 77.0);
  held.take(found({stitch(132)}), 100.0);
  EXPECT_TRUE(held.proven(100.0).empty());
  held.take({}, 109.0);
  EXPECT_TRUE(held.proven(109.0).empty());
  held.take({}, 110.1);
  EXPECT_EQ(held.proven(110.1).size(), 1U);
}

TEST(HeldStitches, WhatLiesWithinReachIsNotPartedFrom) {
  HeldStitches held{StitchConfig{}};
  held.take(found({stitch(0)}), 0.0);
  for (double at_m = 1.0; at_m < 30.0; at_m += 1.0) {
    held.take(found({}), at_m);
    EXPECT_TRUE(held.proven(at_m).empty()) << at_m;
  }
}

TEST(HeldStitches, WhatIsContradictedIsGivenUpForGood) {
  HeldStitches held{StitchConfig{}};
  held.take(found({stitch(0)}, 100.0), 0.0);
  EXPECT_FALSE(held.disproved()) << "one place is not enough";
  held.take(found({stitch(1)}), 0.5);
  EXPECT_FALSE(held.disproved()) << "no more than the bound";
  held.take(found({}, 1.0), 1.0);
  const std::optional<Refusal> refusal = held.disproved();
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, "told_apart");
  EXPECT_DOUBLE_EQ(refusal->measured, 9.0);
  EXPECT_EQ(held.elsewhere(), std::set<ExperienceId>{kRunBefore});
  EXPECT_TRUE(held.rest().empty());
  EXPECT_FALSE(held.disproved());
}

TEST(HeldStitches, CrossingsFarApartAreNotAddedUp) {
  HeldStitches held{StitchConfig{}};
  for (double at_m = 0.0; at_m < 300.0; at_m += 50.0) {
    held.take(found({}, 7.0), at_m);
    EXPECT_FALSE(held.disproved()) << at_m;
  }
}

TEST(HeldStitches, ARunThatIsJoinedAlreadyIsNotLeftOutWhereItSeemsToBeOnceMore) {
  HeldStitches held{StitchConfig{}};
  held.take(found({stitch(0)}), 0.0);
  held.take({}, 10.1);
  EXPECT_EQ(held.proven(10.1).size(), 1U);
  held.take(found({stitch(1)}, 7.0), 50.0);
  held.take(found({stitch(2)}, 7.0), 50.5);
  EXPECT_TRUE(held.disproved());
  EXPECT_TRUE(held.elsewhere().empty());
  EXPECT_TRUE(held.rest().empty());
}

/// Sees marks, and is told what speaks against two places being one.
class ToldWhatContradicts : public MarksMethod {
 public:
  explicit ToldWhatContradicts(std::function<double()> contradicts) : contradicts_(std::move(contradicts)) {}
  double contradiction(const Content&, const Content&, const Relation&) const { return contradicts_(); }

 private:
  std::function<double()> contradicts_;
};
static_assert(Contradicts<ToldWhatContradicts>);
static_assert(!Contradicts<MarksMethod>);

class TwoRunsOnOneWay : public MarksFleet {
 protected:
  std::unique_ptr<Navigator> navigator() const override {
    return make_navigator(ToldWhatContradicts([this] { return asked++ < after ? 0.0 : contradicts; }), navigation);
  }
  void teach_both() {
    const std::vector<Pose2> way = Course({5, 5, 0}).straight(6.0).poses;
    teach(first, way);
    asked = 0;
    NavigatedRobot robot = robot_at(way.front(), 2);
    robot.teach(server, second, way, truth);
    refusals = robot.refusals;
    told_apart = robot.navigator().told_apart();
  }
  std::size_t stitches() const {
    std::size_t count = 0;
    for (const Edge& edge : server.snapshot().experience(second)->stitches) count += edge.id.a.experience == first;
    return count;
  }

  mutable int asked = 0;
  int after = 0;
  double contradicts = 0.0;
  std::map<std::string, int> refusals;
  std::set<ExperienceId> told_apart;
};

TEST_F(TwoRunsOnOneWay, AreStitchedWhereNothingSpeaksAgainst) {
  teach_both();
  EXPECT_GT(asked, 10);
  EXPECT_GT(stitches(), 10U);
  EXPECT_TRUE(told_apart.empty());
}

TEST_F(TwoRunsOnOneWay, NothingIsHandedInBeforeTheEndAndAllThen) {
  const std::vector<Pose2> way = Course({5, 5, 0}).straight(6.0).poses;
  teach(first, way);
  NavigatedRobot robot = robot_at(way.front(), 2);
  robot.navigator().begin_teach({second, RobotId{{2}}});
  std::size_t kept = 0;
  const auto to_another = [](const std::vector<Kept>& places) {
    std::size_t count = 0;
    for (const Kept& place : places)
      for (const Edge& edge : place.edges) count += edge.id.a.experience == first;
    return count;
  };
  robot.hand(way, [&] {
    const Navigated navigated = robot.step(server.map(), true);
    server.take(second, RobotId{{2}}, "marks", navigated.kept);
    kept += navigated.kept.size();
    EXPECT_EQ(to_another(navigated.kept), 0U);
  });
  ASSERT_TRUE(robot.navigator().beside());
  EXPECT_EQ(robot.navigator().beside()->experience, first);
  std::vector<Kept> last = robot.navigator().end_teach(server.map());
  for (; robot.navigator().is_taught(); last = robot.navigator().end_teach(server.map()))
    robot.step(server.map(), true);
  EXPECT_GT(to_another(last), kept / 2);
  EXPECT_FALSE(robot.navigator().beside());
}

TEST_F(TwoRunsOnOneWay, ALostRobotIsFoundWhereNothingSpeaksAgainstAlone) {
  teach(first, Course({5, 5, 0}).straight(6.0).poses);
  for (const double against : {0.0, 5.0}) {
    contradicts = against;
    NavigatedRobot robot = robot_at({7.0, 5.0, 0.0}, 3);
    robot.navigator().seek(std::nullopt);
    run(robot, 60);
    EXPECT_EQ(robot.navigator().estimate().has_value(), against == 0.0);
    EXPECT_EQ(robot.refusals["contradicted"] > 0, against > 0.0);
  }
}

TEST_F(TwoRunsOnOneWay, AreNotStitchedAtAllWhereEnoughSpeaksAgainstInTheEnd) {
  after = 20;
  contradicts = 10.0;
  teach_both();
  EXPECT_EQ(stitches(), 0U);
  EXPECT_EQ(refusals["told_apart"], 1);
  EXPECT_EQ(told_apart, std::set<ExperienceId>{first});
}

}  // namespace
}  // namespace weft::agents
