#pragma once
#include <memory>
#include <span>

#include "idl/bus/bus.hpp"
#include "idl/bus/topics.hpp"

/// What bus::open chooses from. Tests give a table of their own to send what the real one refuses.
namespace weft::bus {

using TopicTable = std::span<const Topic, kTopics>;

Result<std::unique_ptr<Bus>> open_fastdds(const BusConfig& config, TopicTable table);
Result<std::unique_ptr<Bus>> open_cyclonedds(const BusConfig& config, TopicTable table);
std::string fastdds_version();
std::string cyclonedds_version();

/// Both vendors know a participant as gone after this much silence, and say that they are there this often.
inline constexpr Duration kParticipantLease = std::chrono::seconds(5);
inline constexpr Duration kAnnouncementPeriod = std::chrono::seconds(1);
/// How long publish may block: for a place in the queue of an `ordered` topic, and at all.
inline constexpr Duration kOrderedBlocking = std::chrono::milliseconds(20);
inline constexpr Duration kBlocking = std::chrono::milliseconds(100);
/// Receive and send buffers of sockets, where the system allows it.
inline constexpr std::uint32_t kSocketBytes = 4U << 20U;

}  // namespace weft::bus
