#include "idl/bus/cyclonedds/qos.hpp"

#include "idl/bus/backends.hpp"

namespace weft::bus::cyclonedds {
namespace {

/// Bounds the bytes of a datagram that RTPS's own headers may take: what is left is a fragment's.
constexpr std::uint32_t kHeaders = 160;
/// Bounds the unacknowledged bytes, beyond which a writer waits: that many of the largest chunks.
constexpr std::uint32_t kUnacknowledged = 8U << 20U;

Qos base_qos(const Topic& topic) {
  Qos qos(dds_create_qos(), dds_delete_qos);
  const bool ordered = topic.delivering == Delivering::ordered;
  const bool once = topic.delivering == Delivering::once;
  dds_qset_reliability(qos.get(), once ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       (ordered ? kOrderedBlocking : kBlocking).count());
  const bool keeps = topic.delivering == Delivering::state || topic.lifespan > Duration{};
  dds_qset_durability(qos.get(), keeps ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  return qos;
}

std::string element(std::string_view name, const std::string& text) {
  return "<" + std::string(name) + ">" + text + "</" + std::string(name) + ">";
}

}  // namespace

std::string domain_xml(const BusConfig& config, const Addresses& addresses) {
  const auto ms = [](Duration d) {
    return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(d).count()) + "ms";
  };
  const auto bytes = [](std::uint32_t count) { return std::to_string(count) + "B"; };
  const std::uint32_t datagram = largest_datagram(addresses);
  const bool server = config.role == msg::Role::server;
  std::string peers;
  for (const ServerAddress& address : addresses.servers) {
    peers += "<Peer address=\"" + address.ipv4 + ":" + std::to_string(address.discovery_port) + "\"/>";
  }
  const std::string general =
      "<Interfaces><NetworkInterface address=\"" + addresses.listen + "\" multicast=\"false\"/></Interfaces>" +
      element("AllowMulticast", "false") + element("MaxMessageSize", bytes(datagram)) +
      element("MaxRexmitMessageSize", bytes(datagram)) + element("FragmentSize", bytes(datagram - kHeaders));
  const std::string discovery = element("ParticipantIndex", server ? std::to_string(config.server_index) : "none") +
                                element("SPDPInterval", ms(kAnnouncementPeriod)) +
                                element("LeaseDuration", ms(kParticipantLease)) +
                                (peers.empty() ? std::string() : element("Peers", peers));
  // A thread of its own for a socket is ended by a datagram to itself, which comes never once the address is gone.
  const std::string internal = element("MultipleReceiveThreads", "false") +
                               "<SocketReceiveBufferSize min=\"default\" max=\"" + bytes(kSocketBytes) + "\"/>" +
                               element("Watermarks", element("WhcHigh", bytes(kUnacknowledged)));
  return element("CycloneDDS", element("Domain", element("General", general) + element("Discovery", discovery) +
                                                     element("Internal", internal)));
}

Qos writer_qos(const Topic& topic) {
  Qos qos = base_qos(topic);
  const bool ordered = topic.delivering == Delivering::ordered;
  const dds_history_kind_t history = ordered ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST;
  const auto depth = static_cast<std::int32_t>(topic.depth);
  dds_qset_history(qos.get(), history, depth);
  dds_qset_durability_service(qos.get(), 0, history, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  if (topic.lifespan > Duration{}) dds_qset_lifespan(qos.get(), topic.lifespan.count());
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

Qos reader_qos(const Topic& topic) {
  Qos qos = base_qos(topic);
  const bool state = topic.delivering == Delivering::state;
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);
  dds_qset_history(qos.get(), state ? DDS_HISTORY_KEEP_LAST : DDS_HISTORY_KEEP_ALL, 1);
  return qos;
}

Qos partition_qos(const PeerId& peer) {
  Qos qos(dds_create_qos(), dds_delete_qos);
  dds_qset_partition1(qos.get(), to_string(peer).c_str());
  return qos;
}

}  // namespace weft::bus::cyclonedds
