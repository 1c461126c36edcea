#pragma once
#include <memory>
#include <span>

#include "idl/bus/addresses.hpp"
#include "idl/bus/bus.hpp"
#include "idl/bus/participant.hpp"
#include "idl/bus/topics.hpp"

/// Holds what bus::open chooses from. Tests give a table of their own to send what the real one refuses.
namespace weft::bus {

using TopicTable = std::span<const Topic, kTopics>;

/// Opens a bus over a table of topics. Otherwise as bus::open.
Result<std::unique_ptr<Bus>> open(Vendor vendor, const BusConfig& config, TopicTable table);
Result<std::unique_ptr<Participant>> join_fastdds(const BusConfig& config, TopicTable table, const Addresses& at,
                                                  Inbox& inbox);
Result<std::unique_ptr<Participant>> join_cyclonedds(const BusConfig& config, TopicTable table, const Addresses& at,
                                                     Inbox& inbox);
std::string fastdds_version();
std::string cyclonedds_version();

/// Bounds the silence after which both vendors take a participant for gone, and sets how often they say it is there.
inline constexpr Duration kParticipantLease = std::chrono::seconds(5);
inline constexpr Duration kAnnouncementPeriod = std::chrono::seconds(1);
/// Bounds how long publish may block: for a place in the queue of an `ordered` topic, and at all.
inline constexpr Duration kOrderedBlocking = std::chrono::milliseconds(20);
inline constexpr Duration kBlocking = std::chrono::milliseconds(100);
/// Sets the receive and send buffers of sockets, where the system allows it.
inline constexpr std::uint32_t kSocketBytes = 4U << 20U;
/// Bounds a datagram. On wires it fits into one frame, also of WireGuard (1,420 bytes less 28 for IP and UDP): of a
/// larger one each lost frame loses all. On loopback nothing is lost, and large ones give ten times the throughput.
inline constexpr std::uint32_t kDatagramOnWires = 1392;
inline constexpr std::uint32_t kDatagramOnLoopback = 65'500;
inline std::uint32_t largest_datagram(const Addresses& addresses) {
  return addresses.listen.starts_with("127.") ? kDatagramOnLoopback : kDatagramOnWires;
}

}  // namespace weft::bus
