#include "idl/bus/fastdds/qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include "idl/bus/backends.hpp"

namespace weft::bus::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

eprosima::fastrtps::Duration_t duration(Duration d) {
  constexpr Duration::rep kSecond = 1'000'000'000;
  return {static_cast<std::int32_t>(d.count() / kSecond), static_cast<std::uint32_t>(d.count() % kSecond)};
}

rtps::Locator_t locator(const std::string& ipv4, std::uint16_t port) {
  rtps::Locator_t made;
  rtps::IPLocator::setIPv4(made, ipv4);
  made.port = port;
  return made;
}

template <class Qos>
void apply(Qos& qos, const Topic& topic) {
  const bool once = topic.delivering == Delivering::once;
  qos.reliability().kind = once ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
  const bool keeps = topic.delivering == Delivering::state || topic.lifespan > Duration{};
  qos.durability().kind = keeps ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.resource_limits().max_samples = 0;  // 0: no limit
  qos.resource_limits().max_instances = 0;
  qos.resource_limits().max_samples_per_instance = 0;
  qos.resource_limits().allocated_samples = 0;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace

dds::DomainParticipantQos participant_qos(const BusConfig& config, const Addresses& addresses) {
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.name("weft");
  auto& builtin = qos.wire_protocol().builtin;
  builtin.discovery_config.leaseDuration = duration(kParticipantLease);
  builtin.discovery_config.leaseDuration_announcementperiod = duration(kAnnouncementPeriod);
  builtin.typelookup_config.use_client = false;
  builtin.avoid_builtin_multicast = true;
  builtin.metatrafficUnicastLocatorList.push_back(locator(addresses.listen, addresses.own.discovery));
  qos.wire_protocol().default_unicast_locator_list.push_back(locator(addresses.listen, addresses.own.data));
  // A server's ports are as announced or not at all; others may move on to the next one.
  if (config.role == msg::Role::server) builtin.mutation_tries = 1;
  for (const ServerAddress& server : addresses.servers) {
    builtin.initialPeersList.push_back(locator(server.ipv4, server.discovery_port));
  }
  if (addresses.servers.empty()) {  // none to announce to; without an entry Fast DDS would take to multicast
    builtin.initialPeersList.push_back(locator(addresses.listen, addresses.own.discovery));
  }
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {addresses.listen};
  udp->sendBufferSize = udp->receiveBufferSize = kSocketBytes;
  udp->maxMessageSize = largest_datagram(addresses);
  qos.transport().user_transports.push_back(udp);
  return qos;
}

dds::DataWriterQos writer_qos(const Topic& topic) {
  dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
  apply(qos, topic);
  if (topic.delivering == Delivering::ordered) {
    qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
    qos.resource_limits().max_instances = 1;
    qos.resource_limits().max_samples = static_cast<std::int32_t>(topic.depth);
    qos.resource_limits().max_samples_per_instance = static_cast<std::int32_t>(topic.depth);
  } else {
    qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = static_cast<std::int32_t>(topic.depth);
  }
  if (topic.lifespan > Duration{}) qos.lifespan().duration = duration(topic.lifespan);
  const bool ordered = topic.delivering == Delivering::ordered;
  qos.reliability().max_blocking_time = duration(ordered ? kOrderedBlocking : kBlocking);
  qos.reliable_writer_qos().times.heartbeatPeriod = duration(std::chrono::milliseconds(100));
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  return qos;
}

dds::DataReaderQos reader_qos(const Topic& topic) {
  dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
  apply(qos, topic);
  const bool state = topic.delivering == Delivering::state;
  qos.history().kind = state ? dds::KEEP_LAST_HISTORY_QOS : dds::KEEP_ALL_HISTORY_QOS;
  qos.history().depth = 1;
  return qos;
}

}  // namespace weft::bus::fastdds
