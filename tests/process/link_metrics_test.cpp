#include "process/link/link_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "core/random.hpp"
#include "idl/bus/inprocess/net.hpp"

namespace weft::process {
namespace {

PeerId peer_of(std::uint8_t number) {
  PeerId id;
  id.bytes.fill(number);
  return id;
}

double value_of(const Metrics& metrics, const std::string& name, const MetricLabels& labels) {
  const auto metric = std::ranges::find(metrics, name, &Metric::name);
  if (metric == metrics.end()) return -1.0;
  const auto series = std::ranges::find(metric->series, labels, &MetricSeries::labels);
  return series == metric->series.end() ? 0.0 : series->value;
}

TEST(LinkMetrics, CountMessagesAndBytesByTopicAndDirection) {
  bus::InProcessNet net{Random(3)};
  bus::Link server{net.attach(msg::Role::server, peer_of(1))};
  bus::Link client{net.attach(msg::Role::client, peer_of(2))};
  msg::Query query;
  query.header.sender = peer_of(2);
  for (query.request = 1; query.request <= 3; ++query.request) ASSERT_TRUE(client.send(query));
  net.deliver_until(SteadyTime(std::chrono::seconds(1)));
  while (server.take()) {
  }
  const MetricLabels sent = {{"topic", "weft/1/query"}, {"direction", "sent"}};
  const MetricLabels received = {{"topic", "weft/1/query"}, {"direction", "received"}};
  const Metrics of_client = link_metrics(client);
  const Metrics of_server = link_metrics(server);
  EXPECT_EQ(value_of(of_client, "weft_link_messages_total", sent), 3.0);
  EXPECT_EQ(value_of(of_client, "weft_link_messages_total", received), 0.0);
  EXPECT_EQ(value_of(of_server, "weft_link_messages_total", received), 3.0);
  EXPECT_GT(value_of(of_server, "weft_link_message_bytes_total", received), 90.0);
  EXPECT_EQ(value_of(of_server, "weft_link_message_bytes_total", received),
            value_of(of_client, "weft_link_message_bytes_total", sent));
  EXPECT_EQ(value_of(of_server, "weft_link_open", {}), 1.0);
  for (const Metric& metric : of_server) EXPECT_EQ(fault_of(metric), "");
}

}  // namespace
}  // namespace weft::process
