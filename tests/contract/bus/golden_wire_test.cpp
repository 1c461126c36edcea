#include <algorithm>

#include "idl/bus/topics.hpp"
#include "tests/contract/bus/contract.hpp"
#include "tests/idl/examples.hpp"
#include "tests/idl/golden_files.hpp"

namespace weft::contract {
namespace {

using bus::Delivery;
using msg::Role;
using GoldenContract = BusContract;

/// Shows what the server sent (or was sent) of each golden message, byte by byte, through real writers and readers.
class Exchange {
 public:
  Exchange(Fleet& fleet, bus::Bus& from, bus::Bus& to) : fleet_(fleet), from_(from), to_(to) {}

  void check(const bus::Example& example) {
    const Bytes golden = bus::read_golden(example.name);
    ASSERT_FALSE(golden.empty()) << example.name;
    const bus::Encoded encoded = bus::encode(example.message, example.sender).value();
    std::optional<Bytes> came;
    const bool arrived = fleet_.until([&] {
      EXPECT_TRUE(from_.publish(encoded.topic, encoded.to, golden)) << example.name;
      for (int i = 0; i < 10 && !came; ++i) {
        fleet_.let_flow();
        while (std::optional<Delivery> delivery = to_.take()) {
          if (delivery->topic == encoded.topic) came = delivery->cdr;
        }
      }
      return came.has_value();
    });
    ASSERT_TRUE(arrived) << example.name;
    EXPECT_EQ(bus::hex_text(*came), bus::hex_text(golden)) << example.name;
  }

 private:
  Fleet& fleet_;
  bus::Bus& from_;
  bus::Bus& to_;
};

void exchange_all(Fleet& fleet, Role role) {
  Peer& peer = fleet.start_peer(role, bus::example_addressee());
  bus::Bus& server = fleet.server().bus();
  for (const bus::Example& example : bus::examples()) {
    const bus::Topic& topic = bus::topic(bus::encode(example.message, example.sender).value().topic);
    if (example.sender == Role::server && topic.readers.has(role)) {
      Exchange(fleet, server, peer.link.bus()).check(example);
    } else if (topic.writers.has(role) && topic.readers.has(Role::server)) {
      Exchange(fleet, peer.link.bus(), server).check(example);
    }
  }
}

TEST_P(GoldenContract, EachMessageAnAgentWritesOrReadsArrivesAsItIs) {
  exchange_all(fleet, Role::agent);
}

TEST_P(GoldenContract, EachMessageAClientWritesOrReadsArrivesAsItIs) {
  exchange_all(fleet, Role::client);
}

WEFT_ON_EACH_PAIRING(GoldenContract);

}  // namespace
}  // namespace weft::contract
