#include "clients/cli/echo_probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

/// Describes a stage: how many echoes, how large, how far apart.
struct Stage {
  std::size_t count = 0;
  std::size_t load_bytes = 0;
  Duration between{};
};
constexpr std::size_t kReaching = 0, kSmall = 1, kLarge = 2, kFlow = 3;
constexpr std::size_t kSmallBytes = 100;
constexpr std::size_t kLargeBytes = 8'000;  // six packets
constexpr std::array kStages = {
    Stage{0, kSmallBytes, 200ms},  // until one returns
    Stage{200, kSmallBytes, 50ms},
    Stage{40, kLargeBytes, 50ms},
    Stage{180, kLargeBytes, 17ms},
};

double seconds_of(const Stage& stage) {
  return static_cast<double>(stage.count) * seconds(stage.between);
}

}  // namespace

double EchoCounts::loss() const {
  return sent == 0 ? 0.0 : 1.0 - static_cast<double>(returned) / static_cast<double>(sent);
}

double EchoCounts::delay_s(double share) const {
  if (delays_s.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(delays_s.size())));
  return delays_s[std::clamp<std::size_t>(rank, 1, delays_s.size()) - 1];
}

double EchoReport::offered_bytes_s() const {
  return flow_s > 0.0 ? static_cast<double>(flow.sent * flow.load_bytes) / flow_s : 0.0;
}

double EchoReport::returned_bytes_s() const {
  return flow_s > 0.0 ? static_cast<double>(flow.returned * flow.load_bytes) / flow_s : 0.0;
}

EchoProbe::EchoProbe(std::uint64_t request, SteadyTime now) : request_(request), next_(now) {}

std::optional<msg::Echo> EchoProbe::due(SteadyTime now) {
  if (is_over_ || now < next_) return std::nullopt;
  if (stage_ == kReaching && reaches_) stage_ = kSmall;
  const Stage& stage = kStages.at(stage_);
  msg::Echo echo;
  echo.request = request_;
  echo.number = ++number_;
  echo.load.assign(stage.load_bytes, std::uint8_t{0x55});
  sent_[number_] = {stage_, now, std::nullopt};
  if (stage_ == kFlow) (sent_of_stage_ == 0 ? flow_began_ : flow_ended_) = now;
  next_ = now + stage.between;
  if (stage_ == kReaching || ++sent_of_stage_ < stage.count) return echo;
  sent_of_stage_ = 0;
  is_over_ = ++stage_ == kStages.size();
  if (is_over_) next_ = now + kLateAtMost;
  return echo;
}

void EchoProbe::hear(const msg::Echo& echo, SteadyTime now) {
  const auto found = sent_.find(echo.number);
  if (echo.request != request_ || found == sent_.end() || found->second.delay_s) return;
  const Duration took = now - found->second.at;
  reaches_ = true;
  if (took <= kLateAtMost) found->second.delay_s = seconds(took);
}

bool EchoProbe::done(SteadyTime now) const {
  return is_over_ && now >= next_;
}

Duration EchoProbe::lasts() {
  double all_s = seconds(kLateAtMost);
  for (const Stage& stage : kStages) all_s += seconds_of(stage);
  return from_seconds(all_s);
}

EchoReport EchoProbe::report() const {
  EchoReport report;
  std::array<EchoCounts*, kStages.size()> of = {nullptr, &report.small, &report.large, &report.flow};
  for (const auto& [number, sent] : sent_) {
    EchoCounts* const counts = of.at(sent.stage);
    if (counts == nullptr) continue;
    ++counts->sent;
    if (!sent.delay_s) continue;
    ++counts->returned;
    counts->delays_s.push_back(*sent.delay_s);
  }
  for (std::size_t stage = kSmall; stage < kStages.size(); ++stage) {
    of.at(stage)->load_bytes = kStages.at(stage).load_bytes;
    std::ranges::sort(of.at(stage)->delays_s);
  }
  if (flow_ended_ > flow_began_) report.flow_s = seconds(flow_ended_ - flow_began_ + kStages.at(kFlow).between);
  return report;
}

}  // namespace weft::cli
