#include "core/network/change.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/network/codec.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

using support::BatchPlan;
using testing::HasSubstr;
using testing::IsEmpty;

/// Arranges one experience of five places in the map, and a batch that begins a second one with stitches to it.
struct Fixture {
  Random random{21};
  BatchPlan old_plan{ExperienceId{100}, support::random_id<RobotId>(random), 1, 5, 0, "marks"};
  BatchPlan plan{ExperienceId{200}, support::random_id<RobotId>(random), 1, 4, 0, "marks"};
  Snapshot snapshot = with(Snapshot{}, support::make_batch(random, Snapshot{}, old_plan));
  Batch batch = support::make_batch(random, snapshot, plan);

  Fixture() {
    for (const std::uint32_t i : {0U, 2U}) {
      batch.edges.push_back(support::make_stitch(random, {ExperienceId{100}, i}, {ExperienceId{200}, i}, "marks"));
    }
  }
};

TEST(Batch, OneThatFitsHasNoIssues) {
  const Fixture f{};
  EXPECT_THAT(check(f.snapshot, f.batch), IsEmpty());
}

TEST(Batch, RandomOnesFit) {
  Random random(22);
  for (int round = 0; round < 20; ++round) {
    const Snapshot snapshot = support::make_network(random, 3, 2, 4, 3);
    const BatchPlan plan{
        snapshot.experiences().begin()->first, snapshot.experiences().begin()->second->robot, 3, 4, 4, "marks"};
    const Batch batch = support::make_batch(random, snapshot, plan);
    EXPECT_THAT(check(snapshot, batch), IsEmpty());
  }
}

struct Malformed {
  const char* what;
  std::function<void(Batch&)> damage;
  ErrorCode code;
  const char* named;
};

const PlaceId kNew1{ExperienceId{200}, 1};

const std::vector<Malformed> kMalformed{
    {"no experience", [](Batch& b) { b.experience = {}; }, ErrorCode::invalid, "no experience id"},
    {"no robot", [](Batch& b) { b.robot = {}; }, ErrorCode::invalid, "no robot id"},
    {"sequence 0", [](Batch& b) { b.sequence = 0; }, ErrorCode::invalid, "sequence is 0"},
    {"long name", [](Batch& b) { b.name.assign(65, 'x'); }, ErrorCode::invalid, "name has 65 bytes"},
    {"control character", [](Batch& b) { b.name = "a\nb"; }, ErrorCode::invalid, "printable"},
    {"no method", [](Batch& b) { b.method = ""; }, ErrorCode::invalid, "method has 0 bytes"},
    {"long reason", [](Batch& b) { b.seal_reason.assign(257, 'x'); }, ErrorCode::invalid, "seal reason"},
    {"too many places", [](Batch& b) { b.places.resize(kBatchPlaces + 1); }, ErrorCode::invalid, "1001 places"},
    {"too many edges", [](Batch& b) { b.edges.resize(kBatchEdges + 1); }, ErrorCode::invalid, "8001 edges"},
    {"gap in places", [](Batch& b) { b.places.erase(b.places.begin() + 1); }, ErrorCode::invalid, "leaves a gap"},
    {"does not start at 0", [](Batch& b) { b.places.erase(b.places.begin()); }, ErrorCode::invalid, "leaves a gap"},
    {"wrong experience", [](Batch& b) { b.places[1].id.experience = {300}; }, ErrorCode::invalid,
     "is of another experience"},
    {"place of another robot", [](Batch& b) { b.places[1].robot.bytes[0] ^= 1U; }, ErrorCode::invalid,
     "of another robot"},
    {"place of another method", [](Batch& b) { b.places[1].method = "floor"; }, ErrorCode::invalid, "another method"},
    {"place version 0", [](Batch& b) { b.places[1].entity_version = 0; }, ErrorCode::invalid, "entity version"},
    {"no content", [](Batch& b) { b.places[1].content.hash = {}; }, ErrorCode::invalid, "no content hash"},
    {"empty content", [](Batch& b) { b.places[1].content.size = 0; }, ErrorCode::invalid, "content size 0"},
    {"huge content", [](Batch& b) { b.places[1].content.size = kLargestContent + 1; }, ErrorCode::invalid,
     "content size"},
    {"gap in odometry", [](Batch& b) { b.edges.erase(b.edges.begin()); }, ErrorCode::invalid, "gap in odometry"},
    {"cycle backwards", [](Batch& b) { std::swap(b.edges[0].id.a, b.edges[0].id.b); }, ErrorCode::invalid, "cycle"},
    {"cycle by a skip", [](Batch& b) { b.edges[0].id.b.index = 3; }, ErrorCode::invalid, "cycle"},
    {"odometry to elsewhere",
     [](Batch& b) {
       b.edges[0].id.a = {ExperienceId{100}, 0};
     },
     ErrorCode::invalid, "leaves the experience"},
    {"edge to nowhere", [](Batch& b) { b.edges.back().id.a.index = 99; }, ErrorCode::not_found, "does not exist"},
    {"edge to an unknown experience", [](Batch& b) { b.edges.back().id.a.experience = {7}; }, ErrorCode::not_found,
     "does not exist"},
    {"edge past the batch", [](Batch& b) { b.edges.back().id.b.index = 4; }, ErrorCode::not_found, "does not exist"},
    {"self edge", [](Batch& b) { b.edges.back().id.a = b.edges.back().id.b; }, ErrorCode::invalid, "to itself"},
    {"pair twice", [](Batch& b) { b.edges.push_back(b.edges.back()); }, ErrorCode::invalid, "twice"},
    {"pair twice, turned",
     [](Batch& b) {
       b.edges.push_back(b.edges.back());
       std::swap(b.edges.back().id.a, b.edges.back().id.b);
     },
     ErrorCode::invalid, "twice"},
    {"NaN relation", [](Batch& b) { std::get<Metric2>(b.edges[0].a_from_b).a_from_b.x = NAN; }, ErrorCode::invalid,
     "not finite"},
    {"negative covariance", [](Batch& b) { std::get<Metric2>(b.edges[0].a_from_b).covariance(1, 1) = -1.0; },
     ErrorCode::invalid, "negative eigenvalue"},
    {"overlap", [](Batch& b) { b.edges.back().overlap = 1.5F; }, ErrorCode::invalid, "overlap"},
    {"overlap NaN", [](Batch& b) { b.edges.back().overlap = NAN; }, ErrorCode::invalid, "overlap"},
    {"edge version 0", [](Batch& b) { b.edges[0].entity_version = 0; }, ErrorCode::invalid, "entity version"},
    {"edge without method", [](Batch& b) { b.edges[0].method = ""; }, ErrorCode::invalid, "method has 0"},
    {"unknown origin", [](Batch& b) { b.edges[0].origin = static_cast<Origin>(9); }, ErrorCode::invalid, "origin"},
    {"unknown drivable", [](Batch& b) { b.edges[0].drivable = static_cast<Drivable>(4); }, ErrorCode::invalid,
     "drivable"},
    {"stitch of others",
     [](Batch& b) {
       b.edges.back().id = {{ExperienceId{100}, 0}, {ExperienceId{100}, 4}};
     },
     ErrorCode::invalid, "batch's experience"},
    {"stitch beside odometry",
     [](Batch& b) {
       b.edges.back().id = {kNew1, {ExperienceId{200}, 2}};
     },
     ErrorCode::invalid, "odometry does not join"},
    {"stitch forwards",
     [](Batch& b) {
       b.edges.back().id = {{ExperienceId{200}, 3}, kNew1};
     },
     ErrorCode::invalid, "older place"},
};

TEST(Batch, EveryMalformedKindIsNamed) {
  for (const Malformed& kind : kMalformed) {
    Fixture f;
    kind.damage(f.batch);
    const std::vector<Error> errors = check(f.snapshot, f.batch);
    EXPECT_THAT(errors, testing::Contains(testing::AllOf(testing::Field(&Error::code, kind.code),
                                                         testing::Field(&Error::message, HasSubstr(kind.named)))))
        << kind.what << (errors.empty() ? "" : ": " + errors.front().message);
  }
}

TEST(Batch, EveryIssueIsNamedNotOnlyTheFirst) {
  Fixture f;
  f.batch.places[1].content.hash = {};
  f.batch.edges[2].entity_version = 0;
  f.batch.edges.back().overlap = 2.0F;
  EXPECT_EQ(check(f.snapshot, f.batch).size(), 3U);
}

/// Returns place `index` of the first experience as the batch's robot knows it better.
Place learned_by(const Fixture& f, std::uint32_t index, std::uint32_t version = 2) {
  Place place = *f.snapshot.place({ExperienceId{100}, index});
  place.entity_version = version;
  place.content.hash.bytes[5] ^= 1U;
  place.robot = f.batch.robot;
  return place;
}

TEST(Batch, PlacesOfOthersCanBeKnownBetter) {
  Fixture f;
  f.batch.learned = {learned_by(f, 1), learned_by(f, 3)};
  EXPECT_THAT(check(f.snapshot, f.batch), IsEmpty());
  Batch lessons = f.batch;
  lessons.places.clear();
  lessons.edges.clear();
  EXPECT_THAT(check(f.snapshot, lessons), IsEmpty()) << "without any place of its own";
  const Snapshot joined = with(f.snapshot, f.batch);
  EXPECT_EQ(*joined.place({ExperienceId{100}, 1}), f.batch.learned[0]);
  EXPECT_EQ(*joined.place({ExperienceId{100}, 2}), *f.snapshot.place({ExperienceId{100}, 2}));
  EXPECT_EQ(*joined.place({ExperienceId{100}, 3}), f.batch.learned[1]);
  EXPECT_EQ(joined.place_count(), 9U);
  EXPECT_EQ(f.snapshot.place({ExperienceId{100}, 1})->entity_version, 1U) << "the old snapshot stays as it is";
}

TEST(Batch, WhatIsLearnedWronglyIsNamed) {
  const std::vector<Malformed> malformed{
      {"first version", [](Batch& b) { b.learned[0].entity_version = 1; }, ErrorCode::invalid, "at least the second"},
      {"own experience", [](Batch& b) { b.learned[0].id = kNew1; }, ErrorCode::invalid, "the batch's own experience"},
      {"nowhere", [](Batch& b) { b.learned[0].id.index = 99; }, ErrorCode::not_found, "does not exist"},
      {"twice", [](Batch& b) { b.learned.push_back(b.learned[0]); }, ErrorCode::invalid, "is there twice"},
      {"method", [](Batch& b) { b.learned[0].method = "floor"; }, ErrorCode::invalid, "has method marks, not floor"},
      {"robot", [](Batch& b) { b.learned[0].robot.bytes[0] ^= 1U; }, ErrorCode::invalid, "of another robot"},
      {"content", [](Batch& b) { b.learned[0].content.size = 0; }, ErrorCode::invalid, "content size 0"},
      {"too many", [](Batch& b) { b.learned.resize(kBatchPlaces); }, ErrorCode::invalid, "1004 places"},
  };
  for (const Malformed& kind : malformed) {
    Fixture f;
    f.batch.learned = {learned_by(f, 1)};
    kind.damage(f.batch);
    EXPECT_THAT(check(f.snapshot, f.batch),
                testing::Contains(testing::AllOf(testing::Field(&Error::code, kind.code),
                                                 testing::Field(&Error::message, HasSubstr(kind.named)))))
        << kind.what;
  }
}

TEST(Batch, OfTwoWhoLearnBesideEachOtherTheFirstCounts) {
  Fixture f;
  f.batch.learned = {learned_by(f, 1), learned_by(f, 3)};
  const Snapshot meanwhile = with(f.snapshot, in_time(f.snapshot, f.batch));
  Batch late = f.batch;
  late.learned = {learned_by(f, 1), learned_by(f, 2), learned_by(f, 4, 3)};
  const Batch rest = in_time(meanwhile, late);
  ASSERT_EQ(rest.learned.size(), 1U);
  EXPECT_EQ(rest.learned.front().id.index, 2U);
}

TEST(Batch, WhatIsLearnedTravelsBehindItsPlaces) {
  Fixture f;
  f.batch.learned = {learned_by(f, 1), learned_by(f, 3)};
  const Result<Batch> back = decode_batch(encode(f.batch));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->places, f.batch.places);
  EXPECT_EQ(back->learned, f.batch.learned);
  Batch other = f.batch;
  other.learned.pop_back();
  EXPECT_NE(hash(other), hash(f.batch));
}

TEST(Batch, WhatContradictsTheMapIsAConflict) {
  Fixture f;
  const Snapshot joined = with(f.snapshot, f.batch);
  BatchPlan next = f.plan;
  next.sequence = 2;
  const Batch good = support::make_batch(f.random, joined, next);
  ASSERT_THAT(check(joined, good), IsEmpty());
  const auto expect_conflict = [&](const Snapshot& snapshot, const Batch& batch, const char* named) {
    EXPECT_THAT(check(snapshot, batch),
                testing::Contains(testing::AllOf(testing::Field(&Error::code, ErrorCode::conflict),
                                                 testing::Field(&Error::message, HasSubstr(named)))));
  };
  expect_conflict(with_seal(joined, ExperienceId{200}, "done"), good, "sealed: done");
  Batch other = good;
  other.robot.bytes[0] ^= 1U;
  expect_conflict(joined, other, "another robot");
  other = good;
  other.method = "floor";
  expect_conflict(joined, other, "has method marks");
  other = good;
  other.edges.push_back(f.batch.edges.back());
  expect_conflict(joined, other, "joined already");
  other = good;
  other.edges.push_back(f.batch.edges.front());
  expect_conflict(joined, other, "joined already");
}

TEST(With, JoinsPlacesChainAndStitches) {
  const Fixture f{};
  const Snapshot joined = with(f.snapshot, f.batch);
  EXPECT_EQ(joined.revision().value, f.snapshot.revision().value + 1);
  EXPECT_EQ(joined.place_count(), 9U);
  EXPECT_EQ(joined.stitch_count(), 2U);
  const Experience* const experience = joined.experience(ExperienceId{200});
  ASSERT_NE(experience, nullptr);
  EXPECT_EQ(experience->robot, f.plan.robot);
  EXPECT_EQ(experience->chain.size(), 3U);
  EXPECT_EQ(experience->stitches.size(), 2U);
  EXPECT_EQ(joined.experience(ExperienceId{100})->stitches.size(), 2U);
  EXPECT_EQ(joined.place({ExperienceId{200}, 4}), nullptr);
  // The snapshot it was made from is as it was.
  EXPECT_EQ(f.snapshot.place_count(), 5U);
  EXPECT_EQ(f.snapshot.stitch_count(), 0U);
}

TEST(With, EdgesOfAPlaceAreFoundFromBothEndsOdometryFirst) {
  Random random(23);
  const Snapshot snapshot = support::make_network(random, 4, 4, 5, 4);
  std::vector<Edge> all;
  for (const auto& [id, experience] : snapshot.experiences()) {
    all.insert(all.end(), experience->chain.begin(), experience->chain.end());
    for (const Edge& edge : experience->stitches) {
      if (edge.id.a.experience == id) all.push_back(edge);
    }
  }
  EXPECT_GT(snapshot.stitch_count(), 20U);
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) {
      std::vector<EdgeId> odometry;
      std::vector<EdgeId> stitches;
      for (const Edge& edge : all) {
        if (edge.id.a != place.id && edge.id.b != place.id) continue;
        (edge.origin == Origin::stitch ? stitches : odometry).push_back(edge.id);
      }
      std::sort(odometry.begin(), odometry.end());
      std::sort(stitches.begin(), stitches.end());
      odometry.insert(odometry.end(), stitches.begin(), stitches.end());
      std::vector<EdgeId> visited;
      snapshot.for_each_edge(place.id, [&](const Edge& edge) { visited.push_back(edge.id); });
      EXPECT_EQ(visited, odometry);
    }
  }
}

TEST(With, SharesWhatItDoesNotTouch) {
  Random random(24);
  const Snapshot before = support::make_network(random, 3, 2, 4, 0);
  const auto& [touched, experience] = *before.experiences().begin();
  const Snapshot after =
      with(before, support::make_batch(random, before, {touched, experience->robot, 3, 2, 0, "marks"}));
  for (const auto& [id, shared] : before.experiences()) {
    EXPECT_EQ(after.experiences().at(id) == shared, id != touched);
  }
}

TEST(With, TheSameBatchesGiveTheSameNetworkInOneOrInMany) {
  const Fixture f{};
  Batch first = f.batch;
  Batch second = f.batch;
  second.sequence = 2;
  first.places.resize(2);
  second.places.erase(second.places.begin(), second.places.begin() + 2);
  std::erase_if(first.edges, [](const Edge& edge) { return edge.id.b.index >= 2; });
  std::erase_if(second.edges, [](const Edge& edge) { return edge.id.b.index < 2; });
  const Snapshot whole = with(f.snapshot, f.batch);
  const Snapshot halves = with(with(f.snapshot, first), second);
  const Experience& a = *whole.experience(ExperienceId{200});
  const Experience& b = *halves.experience(ExperienceId{200});
  EXPECT_EQ(a.places, b.places);
  ASSERT_EQ(a.chain.size(), b.chain.size());
  for (std::size_t i = 0; i < a.chain.size(); ++i) EXPECT_EQ(encode(a.chain[i]), encode(b.chain[i]));
  EXPECT_EQ(a.stitch_ends, b.stitch_ends);
}

TEST(With, LabelsMoveAndSealsHold) {
  const Fixture f{};
  const PlaceId here{ExperienceId{100}, 1};
  const PlaceId there{ExperienceId{100}, 3};
  const Snapshot first = with_label(f.snapshot, "dock", here);
  const Snapshot moved = with_label(first, "dock", there);
  EXPECT_EQ(first.labels().at("dock"), here);
  EXPECT_EQ(moved.labels().at("dock"), there);
  EXPECT_EQ(moved.revision().value, f.snapshot.revision().value + 2);
  const Snapshot sealed = with_seal(moved, ExperienceId{100}, "vanished");
  EXPECT_TRUE(sealed.experience(ExperienceId{100})->sealed);
  EXPECT_EQ(sealed.experience(ExperienceId{100})->seal_reason, "vanished");
  EXPECT_FALSE(moved.experience(ExperienceId{100})->sealed);
  EXPECT_EQ(sealed.labels().at("dock"), there);
  Batch batch = f.batch;
  batch.seal = true;
  batch.seal_reason = "taught";
  EXPECT_EQ(with(f.snapshot, batch).experience(ExperienceId{200})->seal_reason, "taught");
}

}  // namespace
}  // namespace weft
