#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/agents/agent/rig.hpp"

/// Tests that what a robot has come to know better of the map's places on a drive is handed in when the drive ends.
namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct Learning : Rig {
  Learning() : laid(lay_out(70, 10)) {
    script->estimate = Estimate{{laid, 0}, Relation{}, 0.0};
    tell(server.hello());
    run(4s);
    tell(order(a_route(laid, 10, 1)));
    script->answer.following = Following::driving;
    run(1s);
  }
  LearnedPlace learned_place(std::uint32_t index, std::uint64_t seed) const {
    const Place& known = *agent->window().place({laid, index});
    return {known.id, known.content.hash, 2, some_content(seed, 150)};
  }
  void learn(const std::vector<LearnedPlace>& learned_places) {
    script->answer.learned_places = learned_places;
    run(kFrame);
    script->answer.learned_places.clear();
  }
  void arrive() {
    script->answer.following = Following::arrived;
    run(2s);
  }
  const Place& known(std::uint32_t index) const { return *server.snapshot.place({laid, index}); }

  ExperienceId laid;
};

TEST(PlaceLearner, AreHandedInTogetherWhenTheDriveEnds) {
  Learning rig;
  const LearnedPlace first = rig.learned_place(2, 1);
  rig.learn({first});
  rig.run(5s);
  EXPECT_TRUE(rig.sent<msg::ExperienceBatch>().empty()) << "one drive is one revision";
  const LearnedPlace again = rig.learned_place(2, 2);
  const LearnedPlace second = rig.learned_place(3, 3);
  rig.learn({again, second});
  rig.arrive();
  EXPECT_EQ(rig.known(2).content.hash, hash_bytes(again.content)) << "the newer of two learned_places";
  EXPECT_EQ(rig.known(2).content.size, again.content.size());
  EXPECT_EQ(rig.known(2).content_format, 2U);
  EXPECT_EQ(rig.known(2).entity_version, 2U);
  EXPECT_EQ(rig.known(2).robot, rig.robot) << "who has seen it so";
  EXPECT_EQ(rig.known(3).content.hash, hash_bytes(second.content));
  EXPECT_EQ(rig.known(4).entity_version, 1U);
  EXPECT_EQ(rig.server.contents.at(hash_bytes(second.content)), second.content);
  const auto batches = rig.sent<msg::ExperienceBatch>();
  ASSERT_FALSE(batches.empty());
  EXPECT_EQ(batches.front().batch.learned.size(), 2U);
  EXPECT_TRUE(batches.front().batch.places.empty());
}

TEST(PlaceLearner, UponWhatTheMapDoesNotHaveAnyMoreAreVoid) {
  Learning rig;
  LearnedPlace old = rig.learned_place(2, 1);
  old.made_of.bytes[0] ^= 1U;
  LearnedPlace gone = rig.learned_place(3, 2);
  gone.place.index = 50;
  rig.learn({old, gone});
  rig.arrive();
  EXPECT_TRUE(rig.sent<msg::ExperienceBatch>().empty());
}

TEST(PlaceLearner, OfLaterDrivesGoOnInTheSameExperience) {
  Learning rig;
  rig.learn({rig.learned_place(2, 1)});
  rig.arrive();
  rig.script->answer.following = Following::driving;
  rig.tell(rig.order(a_route(rig.laid, 10, 2)));
  rig.run(35s);  // until the window is asked for again
  rig.learn({rig.learned_place(2, 5)});
  rig.arrive();
  EXPECT_EQ(rig.known(2).entity_version, 3U);
  const auto batches = rig.sent<msg::ExperienceBatch>();
  EXPECT_EQ(batches.front().batch.experience, batches.back().batch.experience);
  EXPECT_EQ(batches.back().batch.sequence, 2U);
}

TEST(PlaceLearner, SurviveARestartAndAreSealedByIt) {
  Learning rig;
  rig.lost_up = [](const msg::Message& message) { return std::holds_alternative<msg::ExperienceBatch>(message); };
  const LearnedPlace learned_place = rig.learned_place(2, 1);
  rig.learn({learned_place});
  rig.arrive();
  EXPECT_EQ(rig.known(2).entity_version, 1U);
  rig.lost_up = [](const auto&) { return false; };
  rig.restart_agent();
  rig.run(5s);
  EXPECT_EQ(rig.known(2).content.hash, hash_bytes(learned_place.content));
  EXPECT_EQ(rig.server.sealed.size(), 1U);
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST(PlaceLearner, ThatAreRefusedAreLetGoAndTeachingKnowsNothingOfIt) {
  Learning rig;
  rig.server.acknowledges = false;
  rig.learn({rig.learned_place(2, 1)});
  rig.arrive();
  const auto batches = rig.sent<msg::ExperienceBatch>();
  ASSERT_FALSE(batches.empty());
  msg::BatchAck ack;
  ack.experience = batches.front().batch.experience;
  ack.refused_sequence = 1;
  ack.refusal = "for this test";
  rig.tell(rig.server.say(ack));
  EXPECT_EQ(rig.script->forgot_taught, 0);
  EXPECT_TRUE(rig.disk->records.empty());
  rig.server.acknowledges = true;
  rig.learn({rig.learned_place(3, 2)});
  rig.run(2s);
  EXPECT_NE(rig.last<msg::ExperienceBatch>()->batch.experience, ack.experience) << "the next ones begin anew";
}

}  // namespace
}  // namespace weft::agents::test
