#include "clients/cli/progress.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;
constexpr Duration kBetweenLines = 2s;
}  // namespace

ProgressLine::ProgressLine(std::ostream& out, std::function<SteadyTime()> now)
    : out_(out), now_(std::move(now)), began_(now_()), said_(began_) {}

void ProgressLine::rest(const msg::OperatorReply& reply) {
  for (const std::string& finding : reply.findings) {
    if (found_.insert(finding).second) out_ << finding << '\n';
  }
}

void ProgressLine::show(const msg::OperatorReply& reply) {
  rest(reply);
  const SteadyTime now = now_();
  if (now - said_ < kBetweenLines) return;
  said_ = now;
  const double rate = static_cast<double>(reply.done) / std::max(1e-3, seconds(now - began_));
  out_ << reply.done;
  if (reply.total > 0) out_ << " of " << reply.total;
  out_ << ' ' << reply.unit << ", " << std::llround(rate) << " a second";
  if (reply.total > reply.done && rate > 0.0) {
    out_ << ", " << std::llround(static_cast<double>(reply.total - reply.done) / rate) << " s remain";
  }
  out_ << std::endl;
}

}  // namespace weft::cli
