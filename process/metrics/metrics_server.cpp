#include "process/metrics/metrics_server.hpp"

#include <prometheus/collectable.h>
#include <prometheus/exposer.h>
#include <prometheus/metric_family.h>

#include <exception>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

namespace weft::process {
namespace {

prometheus::MetricType type_of(MetricKind kind) {
  if (kind == MetricKind::counter) return prometheus::MetricType::Counter;
  return kind == MetricKind::gauge ? prometheus::MetricType::Gauge : prometheus::MetricType::Histogram;
}

/// Returns the counts as Prometheus has them: of each bound with all below it.
prometheus::ClientMetric::Histogram shown(const DurationCounts& durations) {
  prometheus::ClientMetric::Histogram all;
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < durations.counts.size(); ++i) {
    below += durations.counts[i];
    const bool is_last = i >= durations.bounds_s.size();
    all.bucket.push_back({below, is_last ? std::numeric_limits<double>::infinity() : durations.bounds_s[i]});
  }
  all.sample_count = below;
  all.sample_sum = durations.sum_s;
  return all;
}

prometheus::MetricFamily family_of(const Metric& metric) {
  prometheus::MetricFamily family{metric.name, metric.help, type_of(metric.kind), {}};
  for (const MetricSeries& series : metric.series) {
    prometheus::ClientMetric& one = family.metric.emplace_back();
    for (const auto& [label, value] : series.labels) one.label.push_back({label, value});
    one.counter.value = one.gauge.value = series.value;
    if (metric.kind == MetricKind::histogram) one.histogram = shown(series.durations);
  }
  return family;
}

}  // namespace

/// Holds what was published last, for the threads that serve it.
class PublishedMetrics final : public prometheus::Collectable {
 public:
  std::vector<prometheus::MetricFamily> Collect() const override {
    std::shared_ptr<const Metrics> metrics;
    {
      const std::lock_guard lock(mutex_);
      metrics = metrics_;
    }
    std::vector<prometheus::MetricFamily> families;
    for (const Metric& metric : *metrics) {
      if (fault_of(metric).empty()) families.push_back(family_of(metric));
    }
    return families;
  }
  void set(Metrics metrics) {
    auto fresh = std::make_shared<const Metrics>(std::move(metrics));
    const std::lock_guard lock(mutex_);
    metrics_ = std::move(fresh);
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Metrics> metrics_ = std::make_shared<const Metrics>();  // shared
};

struct MetricsServer::Parts {
  explicit Parts(std::vector<std::string> options) : exposer(std::move(options)) {
    exposer.RegisterCollectable(published);
  }
  std::shared_ptr<PublishedMetrics> published = std::make_shared<PublishedMetrics>();
  prometheus::Exposer exposer;  // last member: its threads stop first
};

Result<MetricsServer> MetricsServer::open(std::uint16_t port) {
  const std::string address = "127.0.0.1:" + std::to_string(port);
  const std::vector<std::string> options = {
      "listening_ports",  address, "num_threads",      "8",  "request_timeout_ms", "1000", "enable_keep_alive", "no",
      "max_request_size", "4096",  "connection_queue", "16", "listen_backlog",     "16"};
  try {
    return MetricsServer(std::make_unique<Parts>(options));
  } catch (const std::exception&) {  // says no more than that it failed
    return fail(ErrorCode::unavailable, "metrics cannot be served at " + address +
                                            ": the port is taken, or below 1024 and not allowed; name another with "
                                            "--metrics");
  }
}

MetricsServer::MetricsServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MetricsServer::MetricsServer(MetricsServer&&) noexcept = default;
MetricsServer& MetricsServer::operator=(MetricsServer&&) noexcept = default;
MetricsServer::~MetricsServer() = default;

void MetricsServer::publish(Metrics metrics) {
  parts_->published->set(std::move(metrics));
}

}  // namespace weft::process
