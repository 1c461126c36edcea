#include "process/metrics/metrics_server.hpp"

#include <httplib.h>
#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>
#include <sys/socket.h>

#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

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
class PublishedMetrics {
 public:
  std::string text() const {
    std::shared_ptr<const Metrics> metrics;
    {
      const std::lock_guard lock(mutex_);
      metrics = metrics_;
    }
    std::vector<prometheus::MetricFamily> families;
    for (const Metric& metric : *metrics) {
      if (fault_of(metric).empty()) families.push_back(family_of(metric));
    }
    return prometheus::TextSerializer().Serialize(families);
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
  Parts() {
    constexpr std::size_t kServedAtOnce = 8;
    constexpr std::size_t kLongestBody = 4096;
    http.new_task_queue = [] { return new httplib::ThreadPool(kServedAtOnce); };  // the library deletes it
    http.set_socket_options([](int socket) {  // else the library shares the port with whoever has it
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http.set_keep_alive_max_count(1);
    http.set_keep_alive_timeout(1);
    http.set_read_timeout(1);
    http.set_write_timeout(1);
    http.set_payload_max_length(kLongestBody);
    http.Get("/metrics", [this](const httplib::Request& /*request*/, httplib::Response& response) {
      response.set_content(published.text(), "text/plain; version=0.0.4; charset=utf-8");
    });
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() {
    http.stop();
    if (listening.joinable()) listening.join();
  }

  PublishedMetrics published;
  httplib::Server http;
  std::thread listening;
};

// prometheus-cpp has a server of its own. Its threads have stacks of 100 KB, of which the thread-local data of DDS
// and the like leave too little: it crashes the program at the first request that is none.
Result<MetricsServer> MetricsServer::open(std::uint16_t port) {
  auto parts = std::make_unique<Parts>();
  if (!parts->http.bind_to_port("127.0.0.1", port)) {  // says no more than that it failed
    return fail(ErrorCode::unavailable, "metrics cannot be served at 127.0.0.1:" + std::to_string(port) +
                                            ": the port is taken, or below 1024 and not allowed; name another with "
                                            "--metrics");
  }
  parts->listening = std::thread([&http = parts->http] { http.listen_after_bind(); });
  while (!parts->http.is_running()) std::this_thread::yield();  // else it could not be stopped
  return MetricsServer(std::move(parts));
}

MetricsServer::MetricsServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MetricsServer::MetricsServer(MetricsServer&&) noexcept = default;
MetricsServer& MetricsServer::operator=(MetricsServer&&) noexcept = default;
MetricsServer::~MetricsServer() = default;

void MetricsServer::publish(Metrics metrics) {
  parts_->published.set(std::move(metrics));
}

}  // namespace weft::process
