#include "agents/agent/process/simulated/simulated_body.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "agents/agent/process/options.hpp"
#include "agents/bodies/sim/sim_body.hpp"

namespace weft::agents {

Result<std::unique_ptr<Body>> make_simulated_body(const Options& options, const Warn& warn) {
  std::ifstream in(options.site, std::ios::binary);
  if (!in) return fail(ErrorCode::not_found, options.site + ": no such site file; deploy/sites has some");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  Result<sim::Site> site = sim::parse_site(text, options.site);
  if (!site) return fail(site.error());
  sim::SimBodyConfig config;
  config.site = std::move(*site);
  config.robot = options.name;
  config.seed = options.seed;
  config.day = options.day;
  config.floors_dir = options.floors;
  config.hall_dir = options.hall;
  config.truth_path = options.truth;
  config.warn = warn;
  return sim::make_sim_body(config);
}

}  // namespace weft::agents
