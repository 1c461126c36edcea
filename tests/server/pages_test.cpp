#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/page.hpp"
#include "tests/server/arranged_site.hpp"

/// Tests the network, whole and as it was, page by page, as clients read it.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

struct Pages : testing::Test {
  Pages() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(30));
    site.hand_in(r1, other.next(5));
  }
  /// Answers whose parts are one.
  msg::QueryReply ask(Revision at, Revision apart_from, const PlaceId& after = {}) {
    msg::Query query;
    query.header = site.client.header();
    query.request = 5;
    query.kind = msg::Query::Kind::network;
    query.at = at;
    query.apart_from = apart_from;
    query.after = after;
    site.hush();
    site.say(query);
    EXPECT_THAT(site.heard<msg::QueryReply>(), SizeIs(1));
    return site.last<msg::QueryReply>().value_or(msg::QueryReply{});
  }
  Window read(Revision at = {}, Revision apart_from = {}) {
    PagedNetwork paged;
    while (!paged.is_whole()) {
      msg::QueryReply reply = ask(at, apart_from, paged.after());
      if (!paged.add(std::move(reply.network))) break;
      at = paged.revision();
    }
    return paged.take();
  }
  Revision now() { return site.service().snapshot().revision(); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  TaughtRun other{r1, 20};
};

TEST_F(Pages, ShowTheNetworkAsItIs) {
  site.label("dock", run.place(1));
  const Window read_now = read();
  EXPECT_EQ(digest(read_now), digest(make_window(site.service().snapshot(), {})));
  EXPECT_THAT(read_now.places, SizeIs(35));
  EXPECT_THAT(read_now.labels, SizeIs(1));
}

TEST_F(Pages, ShowItAsItWasAfterARestartToo) {
  const Revision then = now();
  const Digest was = digest(make_window(site.service().snapshot(), {}));
  site.hand_in(r1, run.next(3));
  EXPECT_EQ(digest(read(then)), was);
  site.restart();
  EXPECT_EQ(digest(read(then)), was) << "from the store";
  EXPECT_EQ(read(then).revision, then);
}

TEST_F(Pages, OfOneReadingStayOfOneRevisionWhileTheMapChanges) {
  site.restart();
  PagedNetwork paged;
  ASSERT_TRUE(paged.add(ask({}, {}).network));
  const Revision begun = paged.revision();
  site.hand_in(r1, other.next(3));
  ASSERT_GT(now(), begun);
  EXPECT_EQ(ask(begun, {}, run.place(3)).network.revision, begun);
}

TEST_F(Pages, ApartFromAnotherRevisionShowWhatDiffers) {
  const Revision then = now();
  site.hand_in(r1, other.next(3));
  for (const bool is_restarted : {false, true}) {
    if (is_restarted) site.restart();
    EXPECT_THAT(read(then, now()).places, SizeIs(5)) << is_restarted;
    EXPECT_THAT(read(now(), then).places, SizeIs(8)) << is_restarted;
    EXPECT_THAT(read(then, then).places, SizeIs(0)) << is_restarted;
  }
}

TEST_F(Pages, OfARevisionThatIsNotThereAreRefusedNamingTheNewest) {
  const msg::QueryReply reply = ask({now().value + 5}, {});
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr("its newest is " + std::to_string(now().value)));
  EXPECT_EQ(ask({}, {now().value + 5}).outcome, msg::Outcome::refused);
}

TEST_F(Pages, ThePastIsLetGoWhenNobodyReadsIt) {
  const Revision then = now();
  site.hand_in(r1, run.next(3));
  EXPECT_THAT(read(then).places, SizeIs(35));
  const SteadyTime soon = site.now.steady + 60s;
  site.pass(60s);
  EXPECT_GE(*site.service().next_tick(), soon) << "nothing is held whose end is waited for";
}

TEST_F(Pages, QueriesForARobotThatIsUnknownAreRefused) {
  msg::Query query;
  query.header = site.client.header();
  query.kind = msg::Query::Kind::events;
  query.robot = "r9";
  site.say(query);
  EXPECT_EQ(site.last<msg::QueryReply>()->outcome, msg::Outcome::refused);
  EXPECT_THAT(site.last<msg::QueryReply>()->message, HasSubstr("r9"));
}

}  // namespace
}  // namespace weft::server::test
