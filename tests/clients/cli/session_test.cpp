#include "clients/cli/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr PeerId kSelf{{7}};

/// Stands in for a bus on which a server may be heard and answers nobody.
class UnansweredBus final : public bus::Bus {
 public:
  explicit UnansweredBus(const SteadyTime& now) : now_(now) {}

  Result<void> publish(bus::TopicId, const PeerId&, ByteView) override { return {}; }
  std::optional<bus::Delivery> take() override {
    if (to_come.empty()) return std::nullopt;
    bus::Delivery next = std::move(to_come.front());
    to_come.pop_front();
    return next;
  }
  bool wait(Duration) override { return false; }
  void wake() override {}
  std::string vendor() const override { return "stand-in"; }
  msg::Role role() const override { return msg::Role::client; }
  bus::BusCounters counters() const override { return {}; }
  void forget(const PeerId&) override {}
  void open_anew() override { anew_at.push_back(now_); }

  std::vector<SteadyTime> anew_at;
  std::deque<bus::Delivery> to_come;

 private:
  const SteadyTime& now_;
};

struct Unanswered : testing::Test {
  Unanswered() {
    auto made = std::make_unique<UnansweredBus>(now);
    stand_in = made.get();
    link.emplace(std::move(made));
    const auto wait = [this](Duration at_most) {
      now += at_most;
      if (meanwhile) meanwhile();
    };
    session.emplace(*link, World{[this] { return now; }, [] { return WallTime{}; }, wait}, Random(3), kSelf, "anna");
  }
  void say(const msg::Message& message) {
    const Result<bus::Encoded> encoded = bus::encode(message, msg::Role::server);
    ASSERT_TRUE(encoded) << encoded.error().message;
    stand_in->to_come.push_back({encoded->topic, encoded->cdr});
  }

  SteadyTime now{100s};
  std::function<void()> meanwhile;
  UnansweredBus* stand_in = nullptr;
  std::optional<bus::Link> link;
  std::optional<Session> session;
};

TEST_F(Unanswered, TheLinkIsOpenedAnewAfterTenSecondsAndThenMoreRarely) {
  const Result<msg::QueryReply> answer = session->query({}, 60s);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, ErrorCode::timed_out);
  EXPECT_THAT(stand_in->anew_at, ElementsAre(SteadyTime{110s}, SteadyTime{130s}));
}

TEST_F(Unanswered, AlsoWhereTheServerIsHeard) {
  meanwhile = [this] {
    msg::Hello hello;
    hello.peer.bytes[0] = 1;
    hello.incarnation = 1;
    hello.role = msg::Role::server;
    hello.epoch = {1};
    hello.name = "server";
    hello.software = "0.1.0";
    hello.vendor = "inprocess";
    say(hello);
  };
  EXPECT_FALSE(session->connect(15s));
  EXPECT_THAT(stand_in->anew_at, ElementsAre(SteadyTime{110s}));
}

TEST_F(Unanswered, NotWhereAnAnswerComesBitByBit) {
  msg::QueryReply part;
  part.to = kSelf;
  part.header.sender.bytes[0] = 1;
  part.header.incarnation = 1;
  part.parts = 1000;
  meanwhile = [this, part]() mutable {
    ++part.header.sequence;
    say(part);
  };
  EXPECT_FALSE(session->query({}, 60s));
  EXPECT_THAT(stand_in->anew_at, IsEmpty());
}

TEST_F(Unanswered, NotBeforeThat) {
  EXPECT_FALSE(session->query({}, 9s));
  EXPECT_THAT(stand_in->anew_at, IsEmpty());
}

}  // namespace
}  // namespace weft::cli::test
