#include <gtest/gtest.h>

#include <algorithm>

#include "core/network/codec.hpp"
#include "storage/clouds/cloud.hpp"
#include "storage/content_coder.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::storage {
namespace {

using MapStoreContract = StoreTest;

TEST_P(MapStoreContract, EveryOpeningIsAnEpoch) {
  EXPECT_EQ(stored_.epoch, Epoch{1});
  EXPECT_EQ(stored_.snapshot.revision(), Revision{0});
  EXPECT_EQ(stored_.snapshot.place_count(), 0U);
  restart();
  EXPECT_EQ(stored_.epoch, Epoch{2});
  restart();
  EXPECT_EQ(stored_.epoch, Epoch{3});
}

TEST_P(MapStoreContract, BatchesComeBackAsTheNetworkThatTheyMake) {
  sample::Run first(0x11, 1);
  sample::Run second(0xffff'ffff'0000'0001, 2);
  Snapshot expected;
  std::vector<Bytes> contents;
  for (int round = 0; round < 4; ++round) {
    for (sample::Run* run : {&first, &second}) {
      sample::Delivery delivery = run->next(5);
      if (run == &second) {
        const PlaceId newer = delivery.batch.places.back().id;
        delivery.batch.edges.push_back(sample::stitch({first.experience(), newer.index}, newer));
      }
      commit(sample::transaction(delivery));
      expected = with(expected, delivery.batch);
      contents.insert(contents.end(), delivery.contents.begin(), delivery.contents.end());
    }
  }
  commit({{PutLabel{"dock", {first.experience(), 3}}}});
  expected = with_label(expected, "dock", {first.experience(), 3});

  restart();
  EXPECT_EQ(sample::describe(stored_.snapshot), sample::describe(expected));
  EXPECT_EQ(stored_.durable_through.at(first.experience()), 4U);
  EXPECT_TRUE(stored_.quarantined.empty());
  for (const Bytes& bytes : contents) {
    ASSERT_TRUE(store_->has_content(hash_bytes(bytes)));
    auto read = store_->content(hash_bytes(bytes));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, bytes);
  }
}

TEST_P(MapStoreContract, RevisionCountsTransactionsThatChangeTheNetwork) {
  sample::Run run(0x21, 3);
  const auto first = run.next(2);
  const auto second = run.next(2);
  Transaction both = sample::transaction(first);
  const Transaction later = sample::transaction(second);
  both.changes.insert(both.changes.end(), later.changes.begin(), later.changes.end());
  EXPECT_EQ(commit(both), Revision{1});
  EXPECT_EQ(commit({{PutGoal{sample::goal(1, {run.experience(), 1})}}}), Revision{1});
  EXPECT_EQ(commit({{PutRobot{sample::robot(1), "r1"}, PutEvent{}}}), Revision{1});
  EXPECT_EQ(commit({{PutLabel{"dock", {run.experience(), 1}}}}), Revision{2});
  EXPECT_EQ(commit({{SealExperience{run.experience(), "silent"}}}), Revision{3});
  EXPECT_EQ(commit({}), Revision{3});
  restart();
  EXPECT_EQ(stored_.snapshot.revision(), Revision{3});
}

TEST_P(MapStoreContract, RepeatedBatchIsHarmless) {
  sample::Run run(0x31, 4);
  const auto first = run.next(3);
  const auto second = run.next(3);
  commit(sample::transaction(first));
  EXPECT_EQ(commit(sample::transaction(second)), Revision{2});
  restart();
  const auto before = sample::describe(stored_);
  EXPECT_EQ(commit(sample::transaction(first)), Revision{2});
  EXPECT_EQ(commit({{AppendBatch{second.batch, hash(second.batch)}}}), Revision{2});
  EXPECT_EQ(store_->batch_hash(run.experience(), 2), hash(second.batch));
  EXPECT_EQ(store_->batch_hash(run.experience(), 3), std::nullopt);
  restart();
  EXPECT_EQ(sample::describe(stored_), before);
}

TEST_P(MapStoreContract, RepeatedBatchTwiceInOneTransactionIsOnce) {
  sample::Run run(0x32, 4);
  const auto first = run.next(3);
  Transaction twice = sample::transaction(first);
  twice.changes.emplace_back(AppendBatch{first.batch, hash(first.batch)});
  EXPECT_EQ(commit(twice), Revision{1});
  restart();
  EXPECT_EQ(stored_.snapshot.place_count(), 3U);
}

TEST_P(MapStoreContract, RefusedTransactionLeavesNothing) {
  sample::Run run(0x41, 5);
  commit(sample::transaction(run.next(3)));
  restart();
  const auto before = sample::describe(stored_);
  const auto second = run.next(3);
  const auto third = run.next(3);

  Transaction gap = sample::transaction(third);
  gap.changes.insert(gap.changes.begin(), PutGoal{sample::goal(7, {run.experience(), 0})});
  EXPECT_EQ(refusal(gap), ErrorCode::conflict);

  auto altered = sample::Run(0x41, 6).next(3);
  EXPECT_EQ(refusal(sample::transaction(altered)), ErrorCode::conflict) << "sequence 1 with another hash";

  Transaction without = sample::transaction(second);
  without.changes.erase(without.changes.begin());
  EXPECT_EQ(refusal(without), ErrorCode::conflict) << "a content is missing";

  Transaction wrong = sample::transaction(second);
  std::get<PutContent>(wrong.changes.front()).bytes.front() ^= 1U;
  EXPECT_EQ(refusal(wrong), ErrorCode::invalid) << "a content that is not its hash";

  auto jump = second;
  jump.batch.places.back().id.index += 1;
  EXPECT_EQ(refusal(sample::transaction(jump)), ErrorCode::conflict) << "places with a gap";

  auto foreign = second;
  foreign.batch.places.back().id.experience = {0x42};
  EXPECT_EQ(refusal(sample::transaction(foreign)), ErrorCode::invalid) << "a place of another experience";

  auto zero = second;
  zero.batch.sequence = 0;
  EXPECT_EQ(refusal(sample::transaction(zero)), ErrorCode::invalid) << "sequence 0";

  EXPECT_EQ(refusal({{PutLabel{"dock", {run.experience(), 3}}}}), ErrorCode::conflict) << "no such place";
  EXPECT_EQ(refusal({{SealExperience{{0x43}, "silent"}}}), ErrorCode::conflict) << "no such experience";

  for (const Bytes& bytes : second.contents) EXPECT_FALSE(store_->has_content(hash_bytes(bytes)));
  EXPECT_EQ(store_->size().contents, 3U);
  restart();
  EXPECT_EQ(sample::describe(stored_), before);
  EXPECT_EQ(commit(sample::transaction(second)), Revision{2}) << "what fits still goes in";
}

TEST_P(MapStoreContract, ContentsMayComeBeforeTheirBatch) {
  sample::Run run(0x51, 7);
  const auto first = run.next(2);
  for (const Bytes& bytes : first.contents) {
    EXPECT_EQ(commit({{PutContent{hash_bytes(bytes), msg::ContentKind::cloud, bytes}}}), Revision{0});
  }
  restart();
  EXPECT_EQ(commit({{AppendBatch{first.batch, hash(first.batch)}}}), Revision{1});
}

TEST_P(MapStoreContract, ContentIsStoredOnceHoweverOftenItComes) {
  Random random(8);
  const Bytes bytes = sample::content(random, 5000);
  const Transaction put{{PutContent{hash_bytes(bytes), msg::ContentKind::content, bytes},
                         PutContent{hash_bytes(bytes), msg::ContentKind::content, bytes}}};
  commit(put);
  commit(put);
  EXPECT_EQ(store_->size().contents, 1U);
  EXPECT_EQ(store_->size().content_bytes, 5000U);
  restart();
  commit(put);
  EXPECT_EQ(store_->size().contents, 1U);
  EXPECT_GT(store_->size().disk_free_bytes, 0U);
}

TEST_P(MapStoreContract, ContentsOfAnySizeComeBack) {
  Random random(9);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{5'000'000}}) {
    Bytes bytes(size);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());  // does not compress
    const ContentHash hash = hash_bytes(bytes);
    commit({{PutContent{hash, msg::ContentKind::content, bytes}}});
    auto read = store_->content(hash);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, bytes);
  }
}

TEST_P(MapStoreContract, StoredContentsDecodeToTheContent) {
  Random random(15);
  ContentCoder coder;
  const Bytes shrinks = sample::content(random, 20'000);
  Bytes random_bytes(20'000);
  for (auto& byte : random_bytes) byte = static_cast<std::uint8_t>(random.next());
  clouds::Cloud cloud;
  for (int point = 0; point < 2000; ++point) {
    cloud.points.emplace_back(static_cast<float>(random.uniform()), static_cast<float>(random.uniform()), 0.0F);
  }
  const Bytes canonical = clouds::canonical_bytes(cloud, clouds::kFineQuantum_um).value();
  const std::vector<std::pair<Coding, Bytes>> forms = {
      {Coding::zstd, shrinks}, {Coding::raw, random_bytes}, {Coding::raw, Bytes{7}},
      {Coding::raw, Bytes{}},  {Coding::cloud, canonical},  {Coding::cloud, clouds::sample::place_content(16, 4000)}};
  for (const auto& [coding, bytes] : forms) {
    const ContentHash hash = hash_bytes(bytes);
    commit({{PutContent{hash, msg::ContentKind::content, bytes}}});
    restart();
    const auto stored = store_->stored_content(hash);
    ASSERT_TRUE(stored) << stored.error().message;
    EXPECT_EQ(stored->coding, coding);
    EXPECT_EQ(stored->size, bytes.size());
    if (coding == Coding::raw) {
      EXPECT_EQ(stored->bytes, bytes);
    } else {
      EXPECT_LT(stored->bytes.size(), bytes.size() * 6 / 10);
    }
    EXPECT_EQ(coder.decode(stored->coding, stored->bytes, stored->size).value(), bytes);
  }
}

TEST_P(MapStoreContract, CloudsComeBackToTheByteCanonicalOrNot) {
  Random random(14);
  clouds::Cloud cloud;
  for (int point = 0; point < 5000; ++point) {
    cloud.points.emplace_back(static_cast<float>(random.uniform(0.0, 4.0)),
                              static_cast<float>(random.uniform(0.0, 4.0)),
                              static_cast<float>(random.normal(0.0, 0.01)));
    cloud.values.push_back(static_cast<std::uint16_t>(random.below(60'000)));
  }
  const Bytes canonical = clouds::canonical_bytes(cloud, clouds::kFineQuantum_um).value();
  Bytes unsorted = canonical;
  std::reverse(unsorted.begin() + 40, unsorted.begin() + 4040);  // begins as one, and is none
  Bytes cut = canonical;
  cut.resize(cut.size() - 3);
  const Bytes with_features = clouds::sample::place_content(17, 4000);
  Bytes longer = with_features;
  longer.push_back(0);
  for (const Bytes& bytes : {canonical, unsorted, cut, with_features, longer}) {
    for (const msg::ContentKind kind : {msg::ContentKind::cloud, msg::ContentKind::content}) {
      const ContentHash hash = hash_bytes(bytes);
      commit({{PutContent{hash, kind, bytes}}});
      restart();
      const auto read = store_->content(hash);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(*read, bytes);
    }
  }
}

TEST_P(MapStoreContract, UnknownContentIsNotFound) {
  const ContentHash unknown = hash_bytes(Bytes{1, 2, 3});
  EXPECT_FALSE(store_->has_content(unknown));
  auto read = store_->content(unknown);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::not_found);
  EXPECT_NE(read.error().message.find(to_string(unknown)), std::string::npos);
  const auto stored = store_->stored_content(unknown);
  ASSERT_FALSE(stored);
  EXPECT_EQ(stored.error().code, ErrorCode::not_found);
  EXPECT_NE(stored.error().message.find(to_string(unknown)), std::string::npos);
}

TEST_P(MapStoreContract, StoreOpenedEarlierIsStale) {
  sample::Run run(0x61, 10);
  commit(sample::transaction(run.next(2)));
  auto second = medium_->start_beside();
  ASSERT_TRUE(second) << second.error().message;
  auto opened = (*second)->open();
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->epoch, Epoch{2});

  const auto next = sample::transaction(run.next(2));
  EXPECT_EQ(refusal(next), ErrorCode::stale);
  EXPECT_EQ(refusal({{PutGoal{sample::goal(1, {run.experience(), 0})}}}), ErrorCode::stale);
  auto committed = (*second)->commit(next);
  ASSERT_TRUE(committed) << committed.error().message;
  EXPECT_EQ(committed->revision, Revision{2});
}

TEST_P(MapStoreContract, LabelsMoveAndSealsKeepTheirReason) {
  sample::Run run(0x71, 11);
  sample::Run other(0x72, 12);
  commit(sample::transaction(run.next(3)));
  auto last = other.next(2);
  last.batch.seal = true;
  last.batch.seal_reason = "taught";
  commit(sample::transaction(last));
  commit({{PutLabel{"dock", {run.experience(), 0}}, PutLabel{"gate", {run.experience(), 1}}}});
  commit({{PutLabel{"dock", {run.experience(), 2}}, SealExperience{run.experience(), "silent for a day"}}});
  restart();
  const Snapshot& snapshot = stored_.snapshot;
  EXPECT_EQ(snapshot.labels().size(), 2U);
  EXPECT_EQ(snapshot.labels().at("dock"), (PlaceId{run.experience(), 2}));
  EXPECT_TRUE(snapshot.experience(run.experience())->sealed);
  EXPECT_EQ(snapshot.experience(run.experience())->seal_reason, "silent for a day");
  EXPECT_EQ(snapshot.experience(other.experience())->seal_reason, "taught");
}

TEST_P(MapStoreContract, GoalsRoutesOccupanciesAndRobotsAreKeptAsTheyWereLast) {
  sample::Run run(0x81, 13);
  const PlaceId from{run.experience(), 0};
  const PlaceId to{run.experience(), 1};
  commit(sample::transaction(run.next(2)));
  Goal goal = sample::goal(1, to);
  Route route = sample::route(1, from, to);
  commit({{PutGoal{goal}, PutRoute{route}, PutOccupancy{sample::robot(1), route, 0, 1},
           PutOccupancy{sample::robot(2), route, 1, 1}, PutRobot{sample::robot(1), "r1"}}});
  goal.state = GoalState::executing;
  goal.history.push_back({WallTime(std::chrono::seconds(2)), GoalState::executing, "robot drives", "r1"});
  route.version = 2;
  commit({{PutGoal{goal}, PutRoute{route}, PutOccupancy{sample::robot(2), {}, 0, 0},
           PutRobot{sample::robot(1), "forklift"}, PutGoal{sample::goal(2, from)}}});
  restart();
  ASSERT_EQ(stored_.goals.size(), 2U);
  EXPECT_EQ(encode(stored_.goals.at(goal.id)), encode(goal));
  ASSERT_EQ(stored_.routes.size(), 1U);
  EXPECT_EQ(stored_.routes.at(goal.id).version, 2U);
  ASSERT_EQ(stored_.occupancies.size(), 1U);
  EXPECT_EQ(stored_.occupancies.at(sample::robot(1)).to, 1U);
  EXPECT_EQ(stored_.occupancies.at(sample::robot(1)).held.places, route.places);
  EXPECT_EQ(stored_.robots, (std::map<RobotId, std::string>{{sample::robot(1), "forklift"}}));
}

TEST_P(MapStoreContract, EventsAreFilteredNewestLast) {
  Transaction transaction;
  for (std::int64_t second = 0; second < 12; ++second) {
    msg::Event event;
    event.at = WallTime(std::chrono::seconds(second));
    event.kind = "goal.assigned";
    if (second % 2 == 0) event.goal = sample::goal_id(1);
    if (second % 3 == 0) event.robot = sample::robot(1);
    event.cause = "cause " + std::to_string(second);
    event.who = "tests";
    transaction.changes.emplace_back(PutEvent{event});
  }
  commit(transaction);
  restart();
  const auto causes = [&](const GoalId& goal, const RobotId& robot, std::size_t limit) {
    std::vector<std::string> found;
    auto page = store_->events({.goal = goal, .robot = robot}, limit);
    EXPECT_TRUE(page) << page.error().message;
    for (const auto& event : page->events) found.push_back(event.cause.substr(6));
    return found;
  };
  EXPECT_EQ(causes({}, {}, 3), (std::vector<std::string>{"9", "10", "11"}));
  EXPECT_EQ(causes(sample::goal_id(1), {}, 2), (std::vector<std::string>{"8", "10"}));
  EXPECT_EQ(causes({}, sample::robot(1), 100), (std::vector<std::string>{"0", "3", "6", "9"}));
  EXPECT_EQ(causes(sample::goal_id(1), sample::robot(1), 100), (std::vector<std::string>{"0", "6"}));
  EXPECT_EQ(causes(sample::goal_id(9), {}, 100), (std::vector<std::string>{}));
  const msg::Event event = store_->events({}, 1)->events.back();
  EXPECT_EQ(event.at, WallTime(std::chrono::seconds(11)));
  EXPECT_EQ(event.kind, "goal.assigned");
  EXPECT_EQ(event.who, "tests");
}

TEST_P(MapStoreContract, EventsAreReadOnFromANumberATimeAndByKind) {
  Transaction transaction;
  for (const std::int64_t second : {1, 2, 3, 4, 5, 6}) {
    msg::Event event;
    event.at = WallTime(std::chrono::seconds(second));
    event.kind = second % 2 == 0 ? "robot.lost" : second == 5 ? "robotics.x" : "robot";
    if (second > 3) event.robot = sample::robot(1);
    transaction.changes.emplace_back(PutEvent{event});
  }
  const auto none = store_->events({}, 10);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->oldest, 0U);
  EXPECT_EQ(none->newest, 0U);
  commit(transaction);
  restart();
  const auto numbers = [&](const EventFilter& filter, std::size_t limit) {
    std::vector<std::uint64_t> found;
    const auto page = store_->events(filter, limit);
    EXPECT_TRUE(page) << page.error().message;
    EXPECT_EQ(page->oldest, 1U);
    EXPECT_EQ(page->newest, 6U);
    for (const msg::Event& event : page->events) found.push_back(event.number);
    return found;
  };
  using Numbers = std::vector<std::uint64_t>;
  EXPECT_EQ(numbers({}, 2), (Numbers{5, 6}));
  EXPECT_EQ(numbers({.after = 2}, 2), (Numbers{3, 4})) << "the first behind it";
  EXPECT_EQ(numbers({.after = 6}, 2), Numbers{});
  EXPECT_EQ(numbers({.since = WallTime(std::chrono::seconds(4))}, 2), (Numbers{4, 5}));
  EXPECT_EQ(numbers({.kind = "robot"}, 9), (Numbers{1, 2, 3, 4, 6})) << "up to a dot";
  EXPECT_EQ(numbers({.kind = "robot.lost"}, 9), (Numbers{2, 4, 6}));
  EXPECT_EQ(numbers({.robot = sample::robot(1), .kind = "robot", .after = 4}, 9), (Numbers{6}));
  EXPECT_EQ(numbers({.kind = "goal"}, 9), Numbers{});
}

INSTANTIATE_TEST_SUITE_P(Engines, MapStoreContract, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
