#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/echo_probe.hpp"
#include "clients/cli/findings.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

constexpr double kSlow_s = 0.1;        // of the median: orders and progress come late
constexpr double kVerySlow_s = 0.5;    // of one in a hundred
constexpr double kNarrow = 100'000.0;  // bytes a second: a window's contents take minutes

std::string in_percent(double share) {
  return fixed(100.0 * share, 1) + " %";
}

std::string milliseconds(double delay_s) {
  return fixed(1000.0 * delay_s, 1) + " ms";
}

std::string back_of(const EchoCounts& counts) {
  return std::to_string(counts.returned) + " of " + std::to_string(counts.sent) + " came back";
}

Finding of_loss(const EchoReport& report) {
  const bool good = report.small.loss() <= kLossy;
  return {
      "loss", good,
      in_percent(report.small.loss()) + " there and back: " + back_of(report.small) +
          (good ? "" : ": look for a weak signal, a full channel, or a cable; messages are repeated and come late")};
}

Finding of_delay(const EchoReport& report) {
  const double median_s = report.small.delay_s(0.5), late_s = report.small.delay_s(0.99);
  const bool good = median_s <= kSlow_s && late_s <= kVerySlow_s;
  return {
      "delay", good,
      "there and back median " + milliseconds(median_s) + ", 99 % within " + milliseconds(late_s) +
          (good ? "" : ": robots wait for their next piece of way that long; look for power saving of the radio")};
}

/// Says what becomes of messages of several packets, which are as long as the path has to carry.
Finding of_packets(const EchoReport& report) {
  const std::string sizes = std::to_string(report.large.load_bytes) + " bytes, packets of up to 1,420: ";
  if (report.large.returned == 0) {
    return {"packets", false,
            sizes + "none came back: the path's MTU is too small (a VPN?), or something drops large packets; " +
                "ping -M do -s 1392 SERVER has to pass"};
  }
  const bool good = report.large.loss() <= std::max(kLossy, 6.0 * report.small.loss() + kLossy);
  return {"packets", good,
          sizes + back_of(report.large) + (good ? "" : ": more are lost than of small ones; look at MTU and queues")};
}

Finding of_throughput(const EchoReport& report) {
  const double offered = report.offered_bytes_s(), returned = report.returned_bytes_s();
  const bool is_all = returned >= 0.95 * offered;
  const bool good = returned >= kNarrow;
  return {"throughput", good,
          std::string(is_all ? "at least " : "") + fixed(returned / 1000.0, 0) + " kB/s each way at once, of " +
              fixed(offered / 1000.0, 0) + " kB/s that were tried, which is the most that is" +
              (good ? "" : ": contents of a window will take minutes")};
}

nlohmann::json document_of(const EchoCounts& counts) {
  return {{"load_bytes", counts.load_bytes},       {"sent", counts.sent},
          {"returned", counts.returned},           {"loss", counts.loss()},
          {"delay_median_s", counts.delay_s(0.5)}, {"delay_99_s", counts.delay_s(0.99)},
          {"delay_most_s", counts.delay_s(1.0)}};
}

}  // namespace

std::vector<Finding> findings_of(const EchoReport& report) {
  if (report.small.returned == 0) {
    return {{"loss", false, "nothing came back after the first: the network, or the server, has gone"}};
  }
  return {of_loss(report), of_delay(report), of_packets(report), of_throughput(report)};
}

Exit run_network(Session& session, const Invocation& invocation, const Output& output) {
  const Result<EchoReport> report = session.measure(patience(invocation));
  if (!report) return cli::report(report.error(), invocation.json, output);
  nlohmann::json network = {{"small", document_of(report->small)},
                            {"large", document_of(report->large)},
                            {"flow", document_of(report->flow)},
                            {"offered_bytes_per_second", report->offered_bytes_s()},
                            {"returned_bytes_per_second", report->returned_bytes_s()}};
  return show(findings_of(*report), {{"network", std::move(network)}}, invocation.json, output);
}

}  // namespace weft::cli
