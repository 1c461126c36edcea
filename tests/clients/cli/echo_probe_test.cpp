#include "clients/cli/echo_probe.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <functional>

#include "clients/cli/findings.hpp"

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr std::uint64_t kRequest = 5;

/// Runs a measurement in virtual time; `way` says when an echo returns, none: it is lost.
struct Measured {
  using Way = std::function<std::optional<Duration>(const msg::Echo&)>;
  explicit Measured(const Way& way) {
    EchoProbe probe(kRequest, SteadyTime{});
    struct Back {
      SteadyTime at;
      msg::Echo echo;
    };
    std::deque<Back> under_way;
    for (now = SteadyTime{}; !probe.done(now); now += 1ms) {
      while (const std::optional<msg::Echo> echo = probe.due(now)) {
        bytes += echo->load.size();
        if (const std::optional<Duration> took = way(*echo)) under_way.push_back({now + *took, *echo});
      }
      for (const Back& back : under_way) {
        if (back.at == now) probe.hear(back.echo, now);
      }
      if (now > SteadyTime(60s)) break;
    }
    reaches = probe.reaches();
    report = probe.report();
  }
  SteadyTime now;
  std::size_t bytes = 0;
  bool reaches = false;
  EchoReport report;
};

TEST(EchoProbe, AnEvenNetworkLosesNothing) {
  const Measured measured([](const msg::Echo&) { return 20ms; });
  const EchoReport& report = measured.report;
  EXPECT_EQ(report.small.sent, 200U);
  EXPECT_EQ(report.small.returned, 200U);
  EXPECT_EQ(report.small.loss(), 0.0);
  EXPECT_DOUBLE_EQ(report.small.delay_s(0.5), 0.02);
  EXPECT_DOUBLE_EQ(report.small.delay_s(0.99), 0.02);
  EXPECT_EQ(report.large.loss(), 0.0);
  EXPECT_DOUBLE_EQ(report.offered_bytes_s(), report.returned_bytes_s());
  for (const Finding& finding : findings_of(report)) EXPECT_TRUE(finding.good) << finding.what << finding.detail;
}

TEST(EchoProbe, StaysWithinHalfAMegabyteASecondAndEndsWhenItSays) {
  const Measured measured([](const msg::Echo&) { return 20ms; });
  EXPECT_LE(measured.report.offered_bytes_s(), 0.5e6);
  EXPECT_LE(static_cast<double>(measured.bytes), 0.5e6 * seconds(EchoProbe::lasts()));
  EXPECT_LE(measured.now - SteadyTime{}, EchoProbe::lasts() + 500ms);
}

TEST(EchoProbe, ABeginningWithoutAnswersSendsLittleAndReachesNobody) {
  const Measured measured([](const msg::Echo&) { return std::optional<Duration>(); });
  EXPECT_FALSE(measured.reaches);
  EXPECT_LE(measured.bytes, 60U * 5U * 100U + 100U);
}

TEST(EchoProbe, LossAndLateOnesAreCounted) {
  const Measured measured([](const msg::Echo& echo) -> std::optional<Duration> {
    if (echo.number % 10 == 0) return std::nullopt;
    return echo.number % 10 == 1 ? 1200ms : 30ms;  // later than counts
  });
  EXPECT_NEAR(measured.report.small.loss(), 0.2, 0.011);
  EXPECT_DOUBLE_EQ(measured.report.small.delay_s(1.0), 0.03);
  const std::vector<Finding> found = findings_of(measured.report);
  EXPECT_FALSE(found.front().good);
  EXPECT_NE(found.front().detail.find("% there and back"), std::string::npos) << found.front().detail;
}

TEST(EchoProbe, APathThatCarriesNoLargePacketsIsNamed) {
  const Measured measured(
      [](const msg::Echo& echo) { return echo.load.size() < 1'000 ? std::optional<Duration>(5ms) : std::nullopt; });
  EXPECT_EQ(measured.report.small.loss(), 0.0);
  bool is_named = false;
  for (const Finding& finding : findings_of(measured.report)) {
    if (finding.what == "packets") is_named = !finding.good && finding.detail.find("MTU") != std::string::npos;
  }
  EXPECT_TRUE(is_named);
}

TEST(EchoProbe, SlowNetworksAreNamed) {
  const Measured measured([](const msg::Echo&) { return 300ms; });
  for (const Finding& finding : findings_of(measured.report)) {
    if (finding.what == "delay") {
      EXPECT_FALSE(finding.good) << finding.detail;
    }
    if (finding.what == "loss") {
      EXPECT_TRUE(finding.good) << finding.detail;
    }
  }
}

TEST(EchoProbe, EchoesOfOthersAndRepeatsDoNotCount) {
  EchoProbe probe(kRequest, SteadyTime{});
  msg::Echo echo = probe.due(SteadyTime{}).value();
  echo.request = kRequest + 1;
  probe.hear(echo, SteadyTime(1ms));
  EXPECT_FALSE(probe.reaches());
  echo.request = kRequest;
  echo.number = 77;  // was never sent
  probe.hear(echo, SteadyTime(1ms));
  EXPECT_FALSE(probe.reaches());
}

}  // namespace
}  // namespace weft::cli
