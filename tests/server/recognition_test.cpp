#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::size_t kNumbers = 64;

/// Signs a content with its bytes themselves; none: there are too few.
std::optional<agents::Signature> sign_bytes(ByteView content) {
  if (content.size() < kNumbers) return std::nullopt;
  return agents::Signature(content.begin(), content.begin() + kNumbers);
}

struct RecognitionRoom : testing::Test {
  RecognitionRoom() {
    site.arrive(r1, std::nullopt);
    const Handed handed = run.next(40);
    contents = handed.contents;
    site.hand_in(r1, handed);
    site.hush();
  }
  msg::Recognise question(std::size_t place) {
    msg::Recognise asked;
    asked.header = r1.header();
    asked.request = ++request;
    asked.method = "marks";
    asked.content_format = 1;
    asked.seen = *sign_bytes(contents[place]);
    asked.most = 8;
    return asked;
  }
  msg::Recognised ask(const msg::Recognise& asked) {
    site.hush();
    site.say(asked);
    site.pass(100ms);
    const auto answers = site.heard<msg::Recognised>();
    EXPECT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers.back().request, asked.request);
    EXPECT_EQ(answers.back().to, r1.id);
    return answers.back();
  }

  Site site{std::make_shared<storage::MemoryDisk>(), Signers{{{"marks", 1}, sign_bytes}}};
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  std::vector<Bytes> contents;
  std::uint64_t request = 0;
};

TEST_F(RecognitionRoom, ThePlaceThatLooksLikeThatComesFirst) {
  site.pass(1s);
  for (const std::uint32_t place : {0U, 17U, 39U}) {
    const msg::Recognised answer = ask(question(place));
    EXPECT_EQ(answer.outcome, msg::Outcome::done);
    ASSERT_EQ(answer.places.size(), 8U);
    EXPECT_EQ(answer.places.front(), run.place(place));
    EXPECT_EQ(answer.signed_places, 40U);
    EXPECT_EQ(answer.unsigned_places, 0U);
  }
  EXPECT_EQ(site.counted("recognise: places signed"), 40U);
}

TEST_F(RecognitionRoom, PlacesBehindTheFirstAreOthers) {
  site.pass(1s);
  const msg::Recognised first = ask(question(17));
  msg::Recognise behind = question(17);
  behind.after = static_cast<std::uint32_t>(first.places.size());
  const msg::Recognised second = ask(behind);
  EXPECT_FALSE(second.places.empty());
  for (const PlaceId& place : second.places) EXPECT_THAT(first.places, Not(Contains(place)));
}

TEST_F(RecognitionRoom, AfterAStartItSaysHowManyAreNotSignedYet) {
  site.restart();
  site.arrive(r1, std::nullopt);
  const msg::Recognise asked = question(17);
  site.hush();
  site.say(asked);
  site.pass(1ms);
  const msg::Recognised early = site.last<msg::Recognised>().value();
  EXPECT_EQ(early.outcome, msg::Outcome::done);
  EXPECT_GT(early.unsigned_places, 0U);
  EXPECT_EQ(early.signed_places + early.unsigned_places, 40U);
  site.pass(1s);
  EXPECT_EQ(ask(question(17)).places.front(), run.place(17));
  EXPECT_EQ(ask(question(17)).unsigned_places, 0U);
}

TEST_F(RecognitionRoom, WhatIsTaughtLaterIsSignedToo) {
  site.pass(1s);
  const Handed more = run.next(10);
  contents.insert(contents.end(), more.contents.begin(), more.contents.end());
  site.hand_in(r1, more);
  site.pass(1s);
  const msg::Recognised answer = ask(question(45));
  EXPECT_EQ(answer.places.front(), run.place(45));
  EXPECT_EQ(answer.signed_places, 50U);
}

TEST_F(RecognitionRoom, PlacesThatAreTakenOutAreNotProposedUntilTheyAreBack) {
  site.pass(1s);
  msg::OperatorRequest quarantine = site.request(msg::OperatorRequest::Kind::quarantine);
  quarantine.work.what.places = {{run.id(), 15, 20}};
  const msg::OperatorReply done = site.ask(quarantine);
  ASSERT_EQ(done.outcome, msg::Outcome::done) << done.message;
  site.pass(1s);
  const msg::Recognised without = ask(question(17));
  EXPECT_EQ(without.signed_places, 34U);
  for (const PlaceId& place : without.places) EXPECT_FALSE(place.index >= 15 && place.index <= 20);
  msg::OperatorRequest undo = site.request(msg::OperatorRequest::Kind::undo);
  undo.work.revision = done.revision;
  ASSERT_EQ(site.ask(undo).outcome, msg::Outcome::done);
  site.pass(1s);
  const msg::Recognised again = ask(question(17));
  EXPECT_EQ(again.places.front(), run.place(17));
  EXPECT_EQ(again.signed_places, 40U);
}

TEST_F(RecognitionRoom, WhatItCannotCompareIsRefusedInWords) {
  site.pass(1s);
  msg::Recognise other = question(3);
  other.method = "ceiling";
  const msg::Recognised unknown = ask(other);
  EXPECT_EQ(unknown.outcome, msg::Outcome::refused);
  EXPECT_THAT(unknown.message, HasSubstr("'ceiling' of format 1"));
  EXPECT_THAT(unknown.places, IsEmpty());
  msg::Recognise shorter = question(3);
  shorter.seen.pop_back();
  const msg::Recognised malformed = ask(shorter);
  EXPECT_EQ(malformed.outcome, msg::Outcome::refused);
  EXPECT_THAT(malformed.message, AllOf(HasSubstr("64 numbers"), HasSubstr("not 63")));
}

TEST_F(RecognitionRoom, ContentsWithoutASignatureAreCountedAndPassedOver) {
  const Handed small = run.next(5, 10);
  site.hand_in(r1, small);
  site.pass(1s);
  EXPECT_EQ(site.counted("recognise: contents without a signature"), 5U);
  const msg::Recognised answer = ask(question(17));
  EXPECT_EQ(answer.signed_places, 40U);
  EXPECT_EQ(answer.unsigned_places, 0U);
}

TEST_F(RecognitionRoom, ARobotThatAsksAgainIsAnsweredOnce) {
  site.pass(1s);
  site.hush();
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  msg::Recognise of_other = question(30);
  of_other.header = r2.header();
  site.say(question(3));
  site.say(of_other);
  const msg::Recognise last = question(5);
  site.say(last);
  site.pass(100ms);
  const auto answers = site.heard<msg::Recognised>();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_THAT(answers, Contains(testing::Field(&msg::Recognised::request, last.request)));
  EXPECT_THAT(answers, Contains(testing::Field(&msg::Recognised::to, r2.id)));
}

}  // namespace
}  // namespace weft::server::test
