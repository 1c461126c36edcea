#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

struct Windows : testing::Test {
  Windows() {
    site.arrive(r1, std::nullopt);
    site.arrive(r2, std::nullopt);
    site.hand_in(r1, run.next(3));
    site.pass(2s);
    site.hush();
  }
  void ask(Revision held, const Digest& held_digest, std::uint64_t id = 1, WindowDefinition definition = {}) {
    site.say(msg::WindowRequest{.header = r2.header(),
                                .definition_id = id,
                                .definition = std::move(definition),
                                .held = held,
                                .held_digest = held_digest});
  }
  void ask() { ask(window.revision, digest(window)); }
  /// Takes the patches that were said to r2 as an agent would; true if all fitted.
  bool follow() {
    bool fitted = true;
    for (const msg::WindowPatch& patch : site.heard<msg::WindowPatch>()) {
      if (patch.to != r2.id) continue;
      EXPECT_EQ(patch.parts, 1U);
      const bool from_nothing = patch.patch.base == Revision{};
      Result<Window> next = apply(from_nothing ? Window{} : window, patch.patch);
      fitted = fitted && next;
      if (next) window = *std::move(next);
    }
    site.hush();
    return fitted;
  }
  bool is_up_to_date() { return digest(window) == digest(make_window(site.service().snapshot(), {})); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
  Window window;
};

TEST_F(Windows, FirstRequestGetsTheWholeWindow) {
  ask();
  ASSERT_THAT(site.heard<msg::WindowPatch>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::WindowPatch>()->patch.base, Revision{});
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

TEST_F(Windows, ChangesComeUnaskedAsDifferences) {
  ask();
  follow();
  site.pass(1s);
  site.hand_in(r1, run.next(2));
  site.pass(1s);
  ASSERT_THAT(site.heard<msg::WindowPatch>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::WindowPatch>()->patch.base, window.revision);
  EXPECT_THAT(site.last<msg::WindowPatch>()->patch.added, SizeIs(2));
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

TEST_F(Windows, AtMostTwoPatchesASecond) {
  ask();
  follow();
  site.pass(1s);
  for (int i = 0; i < 40; ++i) {
    site.hand_in(r1, run.next(1));
    site.pass(50ms);
  }
  EXPECT_LE(site.heard<msg::WindowPatch>().size(), 5U);
  EXPECT_GE(site.heard<msg::WindowPatch>().size(), 3U);
  site.pass(1s);
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

TEST_F(Windows, NothingIsSaidWhileTheWindowStaysTheSame) {
  WindowDefinition around;
  around.centre = run.place(0);
  around.hops = 1;
  ask({}, {}, 1, around);
  ASSERT_THAT(site.heard<msg::WindowPatch>(), SizeIs(1));
  site.hush();
  site.hand_in(r1, run.next(4));  // all further away than one hop
  site.pass(3s);
  EXPECT_THAT(site.heard<msg::WindowPatch>(), IsEmpty());
}

TEST_F(Windows, LostPatchIsMadeGoodOnRequest) {
  ask();
  follow();
  site.pass(1s);
  site.hand_in(r1, run.next(2));
  site.pass(1s);
  site.hush();  // lost on the way
  ask();
  site.pass(1s);
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

TEST_F(Windows, LostFirstPatchIsMadeGoodOnRequest) {
  ask();
  site.hush();
  site.pass(1s);
  ask();
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

TEST_F(Windows, UnknownBaseGetsAFreshWindow) {
  ask();
  follow();
  site.pass(1s);
  Digest wrong;
  wrong.bytes[5] = 9;
  ask(window.revision, wrong);
  site.pass(1s);
  ASSERT_THAT(site.heard<msg::WindowPatch>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::WindowPatch>()->patch.base, Revision{});
}

TEST_F(Windows, ARobotsWindowIsCurrentWhenItSaysTheDigestOfTheNewest) {
  const auto is_current = [&] {
    msg::RobotState state = site.state(r2, std::nullopt);
    state.window_digest = digest(window);
    site.say(state);
    return site.row("r2").is_window_current;
  };
  EXPECT_FALSE(is_current()) << "it has asked for none";
  ask();
  follow();
  EXPECT_TRUE(is_current());
  site.hand_in(r1, run.next(2));
  site.pass(1s);
  EXPECT_FALSE(is_current()) << "a patch is on its way";
  follow();
  EXPECT_TRUE(is_current());
  window.places.erase_all({window.places.begin()->first});
  EXPECT_FALSE(is_current());
}

TEST_F(Windows, AnotherDefinitionIsAnsweredEvenWhenItGivesTheSameWindow) {
  ask();
  follow();
  site.pass(1s);
  WindowDefinition all;
  all.cap = 5000;
  ask(window.revision, digest(window), 2, all);
  ASSERT_THAT(site.heard<msg::WindowPatch>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::WindowPatch>()->definition_id, 2U);
  EXPECT_EQ(site.last<msg::WindowPatch>()->patch.base, window.revision);
  EXPECT_TRUE(follow());
}

TEST_F(Windows, WindowSurvivesARestartOfTheServer) {
  ask();
  follow();
  site.restart();
  ask();
  EXPECT_TRUE(follow());
  site.pass(1s);
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(2));
  site.pass(1s);
  EXPECT_TRUE(follow());
  EXPECT_TRUE(is_up_to_date());
}

}  // namespace
}  // namespace weft::server::test
