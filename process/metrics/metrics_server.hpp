#pragma once
#include <cstdint>
#include <memory>

#include "core/result.hpp"
#include "process/metrics/metric.hpp"

namespace weft::process {

/// Serves metrics to Prometheus: http://127.0.0.1:PORT/metrics, in text exposition format 0.0.4, from threads of its
/// own. It shows what was published last, so that neither a slow nor a hostile client keeps the main loop waiting:
/// who says nothing for a second is cut off, eight are served at a time, and one request is served a connection.
class MetricsServer {
 public:
  /// Opens the port, 1 to 65535, on the loopback interface alone. unavailable: it is taken, or not allowed.
  static Result<MetricsServer> open(std::uint16_t port);
  MetricsServer(MetricsServer&&) noexcept;
  MetricsServer& operator=(MetricsServer&&) noexcept;
  /// Ends within two seconds, whatever clients do.
  ~MetricsServer();

  /// Shows these from now on. Metrics that are not sound (`fault_of`) are left out; those without a series are named.
  void publish(Metrics metrics);

 private:
  struct Parts;
  explicit MetricsServer(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace weft::process
