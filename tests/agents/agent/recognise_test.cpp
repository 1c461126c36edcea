#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/agents/agent/rig.hpp"

/// Tests a robot that does not know where it is, in a network that is larger than its window.
namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

class RecogniseOfAgent : public testing::Test {
 protected:
  RecogniseOfAgent() {
    rig.config.window_cap = 20;
    rig.restart_agent();
    laid = rig.lay_out(70, 100);
    rig.run(1s);
    request_candidates(1, 0);
  }
  /// Sets what the navigator wants to know from now on.
  void request_candidates(std::uint64_t number, std::uint32_t after) {
    rig.script->question =
        Question{.number = number, .seen = {0.5F, 0.25F}, .method = "marks", .content_format = 3, .after = after};
  }
  PlaceId place(std::uint32_t index) const { return {laid, index}; }
  void answer(const msg::Recognise& asked, const std::vector<PlaceId>& places) {
    msg::Recognised answer;
    answer.request = asked.request;
    answer.places = places;
    answer.signed_places = 90;
    answer.unsigned_places = 10;
    rig.tell(rig.server.say(answer));
  }
  std::vector<PlaceId> window() const {
    std::vector<PlaceId> ids;
    for (const auto& [id, at] : rig.agent->window().places) ids.push_back(id);
    return ids;
  }
  std::size_t fetched(const PlaceId& id) const {
    const ContentHash hash = rig.server.snapshot.place(id)->content.hash;
    std::size_t times = 0;
    for (const msg::ContentRequest& request : rig.sent<msg::ContentRequest>()) {
      times += static_cast<std::size_t>(std::count_if(request.items.begin(), request.items.end(),
                                                      [&](const auto& item) { return item.hash == hash; }));
    }
    return times;
  }

  Rig rig;
  ExperienceId laid;
};

TEST_F(RecogniseOfAgent, AsksTheServerAndHandsOnWhatItSays) {
  rig.run(500ms);
  ASSERT_EQ(rig.sent<msg::Recognise>().size(), 1U);
  const msg::Recognise asked = *rig.last<msg::Recognise>();
  EXPECT_EQ(asked.method, "marks");
  EXPECT_EQ(asked.content_format, 3U);
  EXPECT_EQ(asked.seen, (std::vector<float>{0.5F, 0.25F}));
  EXPECT_GE(asked.most, 1U);
  answer(asked, {place(80), place(55)});
  ASSERT_EQ(rig.script->proposed.size(), 1U);
  EXPECT_EQ(rig.script->proposed[0].first, 1U);
  EXPECT_EQ(rig.script->proposed[0].second, (std::vector<PlaceId>{place(80), place(55)}));
  EXPECT_THAT(rig.seen.notes, testing::Contains(HasSubstr("of 90 (10 more are not signed yet)")));
}

TEST_F(RecogniseOfAgent, AnUnansweredQuestionIsRepeatedLessAndLessOften) {
  rig.run(20s);
  const std::size_t asked = rig.sent<msg::Recognise>().size();
  EXPECT_GE(asked, 4U);
  EXPECT_LE(asked, 6U);
  for (const msg::Recognise& one : rig.sent<msg::Recognise>()) {
    EXPECT_EQ(one.request, rig.sent<msg::Recognise>().front().request);
  }
}

TEST_F(RecogniseOfAgent, ItsWindowIsMadeOfTheProposedPlacesAndOnlyTheirContentsAreFetched) {
  rig.run(500ms);
  answer(*rig.last<msg::Recognise>(), {place(80), place(55)});
  rig.run(2s);
  // The likeliest with what lies around it.
  EXPECT_EQ(window(), (std::vector<PlaceId>{place(55), place(77), place(78), place(79), place(80), place(81),
                                            place(82), place(83)}));
  EXPECT_GE(fetched(place(80)), 1U);
  EXPECT_GE(fetched(place(55)), 1U);
  EXPECT_EQ(fetched(place(40)), 0U);
  EXPECT_THAT(rig.last<msg::RobotState>()->reason, HasSubstr("among 2 places"));
}

TEST_F(RecogniseOfAgent, WhatLiesAroundASuspectedPlaceComes) {
  rig.run(500ms);
  answer(*rig.last<msg::Recognise>(), {place(80), place(55)});
  rig.run(2s);
  rig.script->question.reset();
  rig.script->suspected = place(55);
  rig.run(2s);
  EXPECT_EQ(window(), (std::vector<PlaceId>{place(52), place(53), place(54), place(55), place(56), place(57),
                                            place(58), place(80)}));
  EXPECT_GE(fetched(place(57)), 1U);
}

TEST_F(RecogniseOfAgent, FoundItsWindowIsAsUsualAroundIt) {
  rig.run(500ms);
  answer(*rig.last<msg::Recognise>(), {place(80), place(55)});
  rig.run(2s);
  rig.script->question.reset();
  rig.script->answer.fix = Fix{place(56), Relation{}, {}};
  rig.script->estimate = Estimate{place(56), Relation{}, 0.0};
  rig.run(3s);
  EXPECT_EQ(rig.agent->window().places.size(), rig.config.window_cap);
  EXPECT_NE(rig.agent->window().place(place(50)), nullptr);
  EXPECT_EQ(rig.agent->window().place(place(80)), nullptr);
}

TEST_F(RecogniseOfAgent, RefusedItSaysWhyAndKeepsTheWindowThatItHas) {
  rig.run(500ms);
  const std::vector<PlaceId> before = window();
  msg::Recognised refusal;
  refusal.request = rig.last<msg::Recognise>()->request;
  refusal.outcome = msg::Outcome::refused;
  refusal.message = "this server does not sign contents of 'marks'";
  rig.tell(rig.server.say(refusal));
  rig.run(2s);
  ASSERT_EQ(rig.script->proposed.size(), 1U);
  EXPECT_TRUE(rig.script->proposed[0].second.empty());
  EXPECT_EQ(window(), before);
  EXPECT_THAT(rig.seen.notes, testing::Contains(HasSubstr("does not sign contents of 'marks'")));
}

TEST_F(RecogniseOfAgent, AnswersToEarlierQuestionsAreLetGo) {
  rig.run(500ms);
  const msg::Recognise earlier = *rig.last<msg::Recognise>();
  request_candidates(2, 64);
  rig.run(2s);
  EXPECT_NE(rig.last<msg::Recognise>()->request, earlier.request);
  EXPECT_EQ(rig.last<msg::Recognise>()->after, 64U);
  answer(earlier, {place(80)});
  EXPECT_TRUE(rig.script->proposed.empty());
}

TEST_F(RecogniseOfAgent, ASeedMakesItForgetWhatWasProposed) {
  rig.run(500ms);
  answer(*rig.last<msg::Recognise>(), {place(80), place(55)});
  rig.run(2s);
  rig.script->question.reset();
  msg::AgentCommand command = rig.command(msg::AgentCommand::Kind::localise, 3);
  command.seed = place(10);
  rig.tell(command);
  rig.run(3s);
  EXPECT_EQ(rig.agent->window().places.size(), rig.config.window_cap);
  EXPECT_NE(rig.agent->window().place(place(10)), nullptr);
  EXPECT_EQ(rig.agent->window().place(place(80)), nullptr);
  ASSERT_FALSE(rig.script->sought.empty());
  EXPECT_EQ(rig.script->sought.back(), place(10));
}

TEST_F(RecogniseOfAgent, InVainItSaysAmongHowMany) {
  rig.script->question.reset();
  rig.tell(rig.command(msg::AgentCommand::Kind::localise, 3));
  request_candidates(1, 0);
  rig.run(500ms);
  answer(*rig.last<msg::Recognise>(), {place(80), place(55)});
  rig.script->question.reset();
  rig.run(90s);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply.has_value());
  EXPECT_FALSE(reply->done);
  EXPECT_THAT(reply->reason, HasSubstr("most like what it sees, of 90"));
}

}  // namespace
}  // namespace weft::agents::test
