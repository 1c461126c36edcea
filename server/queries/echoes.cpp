#include "server/queries/echoes.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {

void Echoes::on_echo(const msg::Echo& echo, SteadyTime now) {
  budget_ = std::min(kBurstBytes, budget_ + kBytesPerSecond * std::max(seconds(now - refilled_), 0.0));
  refilled_ = now;
  const double costs = kBytesBeside + static_cast<double>(echo.load.size());
  if (costs > budget_) {
    ++context_.counters["echo: beyond the budget of all clients, not answered"];
    return;
  }
  budget_ -= costs;
  msg::Echo back = echo;
  back.to = echo.header.sender;
  context_.out.send(std::move(back));
}

}  // namespace weft::server
