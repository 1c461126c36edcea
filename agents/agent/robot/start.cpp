#include <utility>

#include "agents/agent/robot/robot_agent.hpp"
#include "core/names.hpp"

namespace weft::agents {
namespace {

Result<void> check_bounds(const AgentConfig& config) {
  if (Result<void> named = check_name("robot", config.name); !named) return named;
  if (!config.self) return fail(ErrorCode::invalid, "identity: is all zero; remove it and start again");
  if (!(config.footprint_radius_m > 0.0 && config.footprint_radius_m <= 5.0)) {
    return fail(ErrorCode::invalid,
                "footprint_radius_m " + std::to_string(config.footprint_radius_m) + ": must be in (0, 5]");
  }
  if (config.window_cap < 1 || config.window_cap > 1'000'000) {
    return fail(ErrorCode::invalid, "window_cap " + std::to_string(config.window_cap) + ": must be in [1, 1000000]");
  }
  if (config.bytes_per_second < msg::kChunkBytes) {
    return fail(ErrorCode::invalid, "bytes_per_second " + std::to_string(config.bytes_per_second) +
                                        ": must be at least one chunk, " + std::to_string(msg::kChunkBytes));
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<Agent>> start(const AgentConfig& config, std::unique_ptr<Navigator> navigator,
                                     storage::Spool& spool, Random random, SteadyTime now) {
  if (Result<void> bounds = check_bounds(config); !bounds) return fail(bounds.error());
  auto watched = std::make_unique<SpoolWatch>(spool);
  Result<Spooler> spooler = Spooler::open(*watched, SpoolerConfig{}, config.self, now);
  if (!spooler) return fail(spooler.error());
  return std::make_unique<RobotAgent>(config, std::move(navigator), std::move(watched), std::move(*spooler), random,
                                      now);
}

}  // namespace weft::agents
