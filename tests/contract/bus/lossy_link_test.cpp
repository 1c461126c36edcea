#include <set>

#include "tests/contract/bus/lab_fleet.hpp"

namespace weft::contract {
namespace {

struct LossyLink : LabTest {};

/// Returns whether chunks arrive. A writer says nothing of readers that it does not know yet: a first chunk is sent
/// until it is heard, and sent on until heartbeats have followed it. Cyclone DDS takes another vendor's data before a
/// heartbeat, and what is incomplete when the first one comes it takes for sent before it began to listen: that is
/// never asked for again.
bool chunks_arrive(bus::Link& from, bus::Link& to, msg::Chunk first) {
  constexpr int kHeard = 5;  // 100 ms apart or more, as heartbeats are
  first.offset = first.total;
  int turns = 0, heard = 0;
  return until([&] {
    if (turns++ % 50 == 0) std::ignore = from.send(first);
    const std::optional<msg::Message> message = to.take();
    if (message && std::holds_alternative<msg::Chunk>(*message)) ++heard;
    return heard == kHeard;
  });
}

TEST_P(LossyLink, ContentsTakeAtMostFiveTimesTheirBytesAtTenPercentLoss) {
  const auto server = start_server();
  const auto robot = start_robot();
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  ASSERT_TRUE(hears(*server, kRobotId));
  constexpr std::size_t kContents = 1'000'000;
  msg::Chunk chunk{header_of(kRobotId), kServerId, msg::ContentKind::cloud, msg::Coding::raw, {}, kContents, 0, {}};
  chunk.hash.bytes.fill(7);
  ASSERT_TRUE(chunks_arrive(*robot, *server, chunk));
  if (const auto loses = lab->lose(10); !loses) GTEST_SKIP() << "SKIPPED: " << loses.error().message;
  const std::uint64_t bytes_before = lab->sent_bytes(Lab::At::robot) + lab->sent_bytes(Lab::At::server);
  std::set<std::uint64_t> came;
  std::size_t came_bytes = 0;
  int turns = 0;
  ASSERT_TRUE(until([&] {
    // A server that greets is heard: silence alone would make the robot open its link anew.
    if (turns++ % 500 == 0) std::ignore = server->send(hello_of(kServerId, msg::Role::server));
    if (chunk.offset < kContents) {
      chunk.data.assign(std::min<std::size_t>(msg::kChunkBytes, kContents - chunk.offset), 0x5a);
      if (robot->send(chunk)) chunk.offset += chunk.data.size();
    }
    const std::optional<msg::Message> message = server->take();
    const auto* const got = message ? std::get_if<msg::Chunk>(&*message) : nullptr;
    if (got != nullptr && got->offset < kContents && came.insert(got->offset).second) came_bytes += got->data.size();
    return came_bytes == kContents;
  })) << came_bytes
      << " bytes came of " << kContents;
  const std::uint64_t on_the_wire = lab->sent_bytes(Lab::At::robot) + lab->sent_bytes(Lab::At::server) - bytes_before;
  RecordProperty("bytes_on_the_wire", std::to_string(on_the_wire));
  EXPECT_LE(on_the_wire, 5 * kContents);
  EXPECT_EQ(lab->fragments(Lab::At::robot) + lab->fragments(Lab::At::server), 0U) << "one lost fragment loses all";
}

WEFT_ON_EACH_DDS_PAIRING(LossyLink);

}  // namespace
}  // namespace weft::contract
