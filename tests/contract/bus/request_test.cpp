#include <map>

#include "tests/contract/bus/contract.hpp"

namespace weft::contract {
namespace {

using msg::Role;
using RequestContract = BusContract;

msg::OperatorRequest request(const PeerId& client, std::uint64_t number) {
  msg::OperatorRequest made;
  made.header = header_of(client);
  made.request = number;
  made.kind = msg::OperatorRequest::Kind::stop;
  return made;
}

/// Answers each request, and does each once; has bad ears for the first two times.
class Desk {
 public:
  explicit Desk(Fleet& fleet) : fleet_(fleet) {}
  void work() {
    for (; seen_ < fleet_.got.size(); ++seen_) {
      const auto* const asked = std::get_if<msg::OperatorRequest>(&fleet_.got[seen_]);
      if (asked == nullptr || ++heard[asked->request] <= 2) continue;
      if (!answers_.contains(asked->request)) answers_[asked->request] = ++done;
      msg::OperatorReply reply;
      reply.header = header_of(kServerId);
      reply.to = asked->header.sender;
      reply.request = asked->request;
      reply.message = "done as number " + std::to_string(answers_[asked->request]);
      EXPECT_TRUE(fleet_.server().send(reply));
    }
  }
  std::map<std::uint64_t, int> heard;
  std::uint64_t done = 0;

 private:
  Fleet& fleet_;
  std::size_t seen_ = 0;
  std::map<std::uint64_t, std::uint64_t> answers_;
};

/// Sends a request, perhaps again. A link whose queue is full says so, and who asked tries again later.
void ask(Peer& client, std::uint64_t number) {
  const auto sent = client.link.send(request(client.id, number));
  EXPECT_TRUE(sent || sent.error().code == ErrorCode::unavailable);
}

TEST_P(RequestContract, RetriesGetOneAnswerThatIsTheSame) {
  Peer& client = fleet.start_peer(Role::client, peer_id(2));
  fleet.set_loss(0.3);
  Desk desk(fleet);
  for (std::uint64_t number = 1; number <= 10; ++number) {
    int turns = 0;
    ASSERT_TRUE(fleet.until([&] {
      constexpr int kRetry = 25;  // turns of 2 ms
      if (turns++ % kRetry == 0) {
        ask(client, number);
      }
      desk.work();
      const auto replies = Fleet::all<msg::OperatorReply>(client.got);
      return !replies.empty() && replies.back().request == number;
    })) << "request "
        << number;
  }
  EXPECT_EQ(desk.done, 10U);
  std::map<std::uint64_t, std::string> texts;
  for (const auto& reply : Fleet::all<msg::OperatorReply>(client.got)) {
    EXPECT_EQ(texts.try_emplace(reply.request, reply.message).first->second, reply.message);
  }
  EXPECT_EQ(texts.size(), 10U);
}

TEST_P(RequestContract, RepliesReachTheAskerAlone) {
  Peer& asker = fleet.start_peer(Role::client, peer_id(2));
  Peer& other = fleet.start_peer(Role::client, peer_id(3));
  ASSERT_TRUE(other.link.send(hello_of(other.id, Role::client)));
  Desk desk(fleet);
  int turns = 0;
  ASSERT_TRUE(fleet.until([&] {
    if (turns++ % 25 == 0) {
      ask(asker, 1);
    }
    desk.work();
    return !asker.got.empty();
  }));
  EXPECT_TRUE(Fleet::all<msg::OperatorReply>(other.got).empty());
}

WEFT_ON_EACH_PAIRING(RequestContract);

}  // namespace
}  // namespace weft::contract
