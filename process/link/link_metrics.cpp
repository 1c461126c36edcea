#include "process/link/link_metrics.hpp"

#include <map>
#include <string>
#include <utility>

#include "idl/bus/topics.hpp"

namespace weft::process {
namespace {

using Traffic = std::map<bus::TopicId, bus::TopicTraffic>;

/// Adds a series a topic to the counters of messages and of bytes.
void add_traffic(const Traffic& traffic, const char* direction, Metric& messages, Metric& bytes) {
  for (const auto& [topic, counted] : traffic) {
    const MetricLabels labels = {{"topic", std::string(bus::topic(topic).name)}, {"direction", direction}};
    messages.series.push_back({labels, static_cast<double>(counted.messages)});
    bytes.series.push_back({labels, static_cast<double>(counted.bytes)});
  }
}

}  // namespace

Metrics link_metrics(bus::Link& link) {
  Metric messages = {"weft_link_messages_total",
                     "Messages sent, and those that came and were valid, by topic",
                     MetricKind::counter,
                     {}};
  Metric bytes = {
      "weft_link_message_bytes_total", "Their bytes, without what the transport adds", MetricKind::counter, {}};
  add_traffic(link.sent(), "sent", messages, bytes);
  add_traffic(link.received(), "received", messages, bytes);
  Metric refused = {
      "weft_link_refused_total", "Messages that were refused, by topic and reason", MetricKind::counter, {}};
  for (const auto& [reason, times] : link.refusals()) {
    refused.series.push_back({{{"reason", reason}}, static_cast<double>(times)});
  }
  const bus::Bus& bus = link.bus();
  const bus::BusCounters counters = bus.counters();
  const auto number = [](std::uint64_t value) { return static_cast<double>(value); };
  return {std::move(messages),
          std::move(bytes),
          std::move(refused),
          counter("weft_link_publish_failed_total", "Messages that were not sent: a queue was full, or the link shut",
                  number(counters.publish_failed)),
          counter("weft_link_inbox_dropped_total", "Messages dropped as the inbox was full",
                  number(counters.dropped_inbox)),
          gauge("weft_link_inbox_messages", "Messages that wait in the inbox", number(counters.waiting)),
          gauge("weft_link_peers", "Peers that can be written to", number(counters.peers)),
          gauge("weft_link_open", "1 while the link is open, 0 while it waits for its network",
                bus.is_open() ? 1.0 : 0.0)};
}

}  // namespace weft::process
