#include <gtest/gtest.h>

#include <set>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

/// Teaches for so long, ten places a second, and ends it.
void teach(Rig& rig, Duration duration) {
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(duration);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(1s);
}

/// Expects that the server has every place once, in order, and the run sealed at its end.
void expect_whole(const Rig& rig, ExperienceId experience, std::uint32_t places) {
  const Experience* const found = rig.server.snapshot.experience(experience);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->places.size(), places);
  EXPECT_EQ(found->chain.size(), places - 1);
  EXPECT_EQ(rig.server.times_joined.at(experience), static_cast<int>(places));
  EXPECT_TRUE(found->sealed);
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST(Spooling, WhatIsTaughtArrivesWholeAndLeavesTheDisk) {
  Rig rig;
  teach(rig, 3s);
  ASSERT_EQ(rig.script->taught.size(), 1U);
  expect_whole(rig, rig.script->taught.front().experience, rig.script->index);
  std::uint32_t acknowledged = 0;
  for (const AckRecord& ack : rig.seen.acks) {
    EXPECT_EQ(ack.first, acknowledged);
    acknowledged += ack.places;
  }
  EXPECT_EQ(acknowledged, rig.script->index);
}

TEST(Spooling, SeveralMethodsHandInAnExperienceEach) {
  Rig rig;
  rig.script->teaches = {"marks", "more"};
  rig.run(4s);
  msg::AgentCommand start = rig.command(Kind::teach_start, 1);
  start.name = "aisle";
  rig.tell(start);
  rig.run(3s);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(2s);
  const TeachStart& taught = rig.script->taught.front();
  ASSERT_EQ(taught.others.size(), 1U);
  expect_whole(rig, taught.experience, rig.script->index);
  expect_whole(rig, taught.others.front(), rig.script->index);
  EXPECT_EQ(rig.server.snapshot.experience(taught.experience)->name, "aisle");
  EXPECT_EQ(rig.server.snapshot.experience(taught.others.front())->name, "aisle-more");
  EXPECT_EQ(rig.server.snapshot.experience(taught.others.front())->method, "more");
}

/// Expects a run by two methods whole, each place of the second joined to one of the first: all joins arrive, those
/// of the last places too, whoever was heard first.
void expect_joined(const Rig& rig) {
  const TeachStart& taught = rig.script->taught.front();
  expect_whole(rig, taught.experience, rig.script->index);
  expect_whole(rig, taught.others.front(), rig.script->index);
  EXPECT_EQ(rig.server.snapshot.stitch_count(), rig.script->index);
}

TEST(Spooling, WhatJoinsTwoExperiencesWaitsUntilBothAreThere) {
  Rig rig;
  rig.script->teaches = {"marks", "more"};
  std::optional<ExperienceId> late;
  rig.lost_up = [&](const msg::Message& message) {  // what the first one hands in, for its first ten seconds
    const auto* const batch = std::get_if<msg::ExperienceBatch>(&message);
    return batch != nullptr && late == batch->batch.experience;
  };
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(500ms);
  late = rig.script->taught.front().experience;
  rig.run(10s);
  late.reset();
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(20s);
  expect_joined(rig);
}

TEST(Spooling, WhatWasTaughtOutOfReachArrivesWithItsJoins) {
  Rig rig;
  rig.script->teaches = {"marks", "more"};
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.connected = false;
  rig.run(6s);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(1s);
  rig.connected = true;
  rig.run(30s);
  expect_joined(rig);
}

TEST(Spooling, NoJoinIsOnDiskBeforeWhatItJoins) {
  Rig rig;
  rig.script->teaches = {"marks", "more"};
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.connected = false;
  for (int i = 0; i < 30; ++i) {
    rig.run(Rig::kFrame);
    std::set<PlaceId> on_disk;
    for (const storage::SpoolRecord& record : rig.disk->records)
      for (const Place& place : record.batch.places) on_disk.insert(place.id);
    for (const storage::SpoolRecord& record : rig.disk->records)
      for (const Edge& edge : record.batch.edges) ASSERT_TRUE(on_disk.contains(edge.id.a)) << to_string(edge.id.a);
  }
}

TEST(Spooling, ANameThatIsTooLongForTheSecondMethodIsRefused) {
  Rig rig;
  rig.script->teaches = {"marks", "more"};
  rig.run(4s);
  msg::AgentCommand start = rig.command(Kind::teach_start, 1);
  start.name = std::string(60, 'a');
  rig.tell(start);
  rig.run(1s);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply);
  EXPECT_FALSE(reply->done);
  EXPECT_NE(reply->reason.find("-more"), std::string::npos) << reply->reason;
  EXPECT_TRUE(rig.script->taught.empty());
}

TEST(Spooling, BatchesAreOnDiskBeforeTheyAreSent) {
  Rig rig;
  rig.run(4s);
  std::uint64_t on_disk = 0;
  std::uint64_t batches = 0;
  rig.lost_up = [&](const msg::Message& message) {
    const auto* const batch = std::get_if<msg::ExperienceBatch>(&message);
    if (batch == nullptr) return false;
    ++batches;
    for (const storage::SpoolRecord& record : rig.disk->records)
      on_disk += record.batch.sequence == batch->batch.sequence;
    return false;
  };
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(3s);
  EXPECT_GE(batches, 4U);
  EXPECT_EQ(on_disk, batches);
}

TEST(Spooling, LostBatchesAndAcknowledgementsAreRepeatedUntilDurable) {
  Rig rig;
  Random random(5);
  rig.doubled = true;
  rig.lost_up = [&](const msg::Message&) { return random.chance(0.5); };
  rig.lost_down = [&](const msg::Message&) { return random.chance(0.5); };
  rig.run(5s);
  for (std::uint64_t number = 1; rig.script->taught.empty(); ++number) rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(3s);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(120s);
  expect_whole(rig, rig.script->taught.front().experience, rig.script->index);
}

TEST(Spooling, MissingContentsAreSentWhenAskedFor) {
  Rig rig;
  rig.script->content_bytes = 3 * msg::kChunkBytes;
  std::set<ContentHash> lost_once;
  rig.lost_up = [&](const msg::Message& message) {  // The first try of every content fails.
    const auto* const chunk = std::get_if<msg::Chunk>(&message);
    if (chunk == nullptr) return false;
    if (chunk->offset + chunk->data.size() == chunk->total) return lost_once.insert(chunk->hash).second;
    return !lost_once.contains(chunk->hash);
  };
  teach(rig, 2s);
  rig.run(60s);
  expect_whole(rig, rig.script->taught.front().experience, rig.script->index);
}

TEST(Spooling, RestartedAgentSendsItsSpoolAndSealsWhatItLeftOpen) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  const ExperienceId experience = rig.script->taught.front().experience;
  rig.connected = false;
  rig.run(3s);
  const std::uint64_t spooled = rig.disk->records.size();
  ASSERT_GE(spooled, 5U);
  rig.restart_agent();
  rig.connected = true;
  rig.run(30s);
  const Experience* const found = rig.server.snapshot.experience(experience);
  ASSERT_NE(found, nullptr);
  EXPECT_TRUE(found->sealed);
  EXPECT_NE(found->seal_reason.find("restarted"), std::string::npos);
  EXPECT_EQ(rig.server.times_joined.at(experience), static_cast<int>(found->places.size()));
  EXPECT_TRUE(rig.disk->records.empty());
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::idle);
}

TEST(Spooling, CrashWithEverythingAcknowledgedStillSeals) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(2s);
  const ExperienceId experience = rig.script->taught.front().experience;
  EXPECT_EQ(rig.disk->records.size(), 1U);  // All acknowledged; the last one is kept to know of the open experience.
  rig.restart_agent();
  rig.run(10s);
  EXPECT_EQ(rig.server.sealed, std::vector<ExperienceId>{experience});
}

TEST(Spooling, RestartedServerGetsWhatItDidNotAcknowledge) {
  Rig rig;
  rig.server.acknowledges = false;
  teach(rig, 2s);
  rig.server.restart();
  rig.server.acknowledges = true;
  rig.tell(rig.server.hello());
  rig.run(10s);
  expect_whole(rig, rig.script->taught.front().experience, rig.script->index);
}

TEST(Spooling, RefusedBatchEndsTeachingWithItsReason) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  msg::BatchAck refusal;
  refusal.experience = rig.script->taught.front().experience;
  refusal.durable_through = rig.server.durable_through[refusal.experience];
  refusal.refused_sequence = refusal.durable_through + 1;
  refusal.refusal = "places are not contiguous";
  rig.tell(rig.server.say(refusal));
  rig.run(1s);
  EXPECT_FALSE(rig.script->teaching);
  EXPECT_GE(rig.hand_stops, 1);
  const auto state = rig.last<msg::RobotState>();
  EXPECT_EQ(state->mode, msg::RobotMode::idle);
  EXPECT_NE(state->reason.find("not contiguous"), std::string::npos);
}

TEST(Spooling, FullDiskEndsTeachingWithItsReason) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.disk->faults.full = true;
  rig.run(2s);
  const auto state = rig.last<msg::RobotState>();
  EXPECT_EQ(state->mode, msg::RobotMode::idle);
  EXPECT_NE(state->reason.find("teaching ended"), std::string::npos);
  EXPECT_GE(rig.script->forgot_taught, 1) << "the server will never hear of those places";
}

TEST(Spooling, RunThatTheDiskCutShortIsSealedOnceThereIsRoom) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.disk->faults.full = true;
  rig.run(3s);
  const Experience* cut_short = rig.server.snapshot.experience(rig.script->taught.front().experience);
  ASSERT_NE(cut_short, nullptr);
  EXPECT_FALSE(cut_short->sealed);
  rig.disk->faults.full = false;
  rig.run(3s);
  cut_short = rig.server.snapshot.experience(rig.script->taught.front().experience);
  EXPECT_TRUE(cut_short->sealed) << "labels that wait for its other places would wait for ever";
  EXPECT_EQ(cut_short->seal_reason, "its robot's disk took no more of it");
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST(Spooling, ARobotWhoseDiskIsFullSaysSoUntilThereIsRoom) {
  Rig rig;
  rig.run(4s);
  EXPECT_EQ(rig.last<msg::RobotState>()->spool_refuses, "");
  EXPECT_EQ(rig.agent->trouble(), "");
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.disk->faults.full = true;
  rig.run(20s);
  EXPECT_NE(rig.last<msg::RobotState>()->spool_refuses.find("full"), std::string::npos);
  EXPECT_NE(rig.agent->trouble().find("its spool refuses"), std::string::npos);
  rig.disk->faults.full = false;
  rig.run(10s);
  EXPECT_EQ(rig.last<msg::RobotState>()->spool_refuses, "") << "though nobody teaches";
  EXPECT_EQ(rig.agent->trouble(), "");
}

TEST(Spooling, DiskThatIsFullAtTheEndForgetsWhatTheServerWillNotHearOf) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.disk->faults.full = true;
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(1s);
  EXPECT_GE(rig.script->forgot_taught, 1);
}

TEST(Spooling, DiskThatIsFullWhenTheBodyFailsForgetsToo) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  EXPECT_EQ(rig.script->forgot_taught, 0);
  rig.disk->faults.full = true;
  rig.take(rig.agent->body_failed({ErrorCode::unavailable, "no base"}, rig.now));
  EXPECT_GE(rig.script->forgot_taught, 1);
}

}  // namespace
}  // namespace weft::agents::test
