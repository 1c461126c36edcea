#include "process/metrics/metrics_server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>

#include "process/metrics/durations.hpp"

namespace weft::process {
namespace {

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// Opens a server at a port that nobody has; another process may be quicker, so it tries again.
std::pair<Result<MetricsServer>, std::uint16_t> open_anywhere() {
  for (int i = 0;; ++i) {
    const int probe = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(probe, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size), 0);
    close(probe);
    const std::uint16_t port = ntohs(address.sin_port);
    Result<MetricsServer> server = MetricsServer::open(port);
    if (server || i == 20) return {std::move(server), port};
  }
}

std::string asked(std::uint16_t port, const std::string& request) {
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = loopback(port);
  EXPECT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(send(client, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  std::string answer;
  std::array<char, 4096> bytes{};
  for (ssize_t got = 1; got > 0;) {
    got = recv(client, bytes.data(), bytes.size(), 0);
    if (got > 0) answer.append(bytes.data(), static_cast<std::size_t>(got));
  }
  close(client);
  return answer;
}

std::string metrics_at(std::uint16_t port) {
  return asked(port, "GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n");
}

TEST(MetricsServer, ShowsWhatWasPublishedLast) {
  auto [server, port] = open_anywhere();
  ASSERT_TRUE(server) << server.error().message;
  EXPECT_NE(metrics_at(port).find("200 OK"), std::string::npos);
  Durations durations;
  durations.add(std::chrono::milliseconds(5));
  Metric named = gauge("weft_places", "Places", 1.0);
  named.series.front().labels = {{"robot", "a \"b\" \\ \n c"}};
  server->publish(
      {named, histogram("weft_handle_seconds", "Handled", durations), gauge("bad name", "Left out", 1.0)});
  std::string shown = metrics_at(port);
  EXPECT_NE(shown.find("text/plain"), std::string::npos) << shown;
  EXPECT_NE(shown.find("# TYPE weft_places gauge\nweft_places{robot=\"a \\\"b\\\" \\\\ \\n c\"} 1\n"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("weft_handle_seconds_bucket{le=\"0.003\"} 0\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("weft_handle_seconds_bucket{le=\"0.01\"} 1\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("weft_handle_seconds_bucket{le=\"+Inf\"} 1\n"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("bad name"), std::string::npos) << shown;
  server->publish({counter("weft_sent_total", "Sent", 7.0)});
  shown = metrics_at(port);
  EXPECT_NE(shown.find("weft_sent_total 7\n"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("weft_places"), std::string::npos) << shown;
}

TEST(MetricsServer, AnswersNothingElse) {
  const auto [server, port] = open_anywhere();
  ASSERT_TRUE(server) << server.error().message;
  EXPECT_NE(asked(port, "GET / HTTP/1.1\r\n\r\n").find("404"), std::string::npos);
  EXPECT_NE(asked(port, "GET /../../etc/passwd HTTP/1.1\r\n\r\n").find(" 40"), std::string::npos);
  EXPECT_NE(asked(port, "nonsense\r\n\r\n").find("400"), std::string::npos);
}

TEST(MetricsServer, APortThatIsTakenIsRefusedByName) {
  const auto [first, port] = open_anywhere();
  ASSERT_TRUE(first) << first.error().message;
  const Result<MetricsServer> second = MetricsServer::open(port);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::unavailable);
  EXPECT_NE(second.error().message.find("127.0.0.1:" + std::to_string(port)), std::string::npos);
}

}  // namespace
}  // namespace weft::process
