#include "agents/agent/process/equip.hpp"

#include <fstream>
#include <iterator>
#include <utility>
#include <variant>

#include "agents/bodies/replay/replay_body.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator_of.hpp"

namespace weft::agents {
namespace {

/// Every method that an agent can run; chosen here and nowhere else.
using AnyMethod = std::variant<Floor>;

Result<AnyMethod> make_method(const Options& options, const Body& body) {
  const std::vector<CameraModel> cameras = body.cameras();
  if (cameras.empty()) return fail(ErrorCode::invalid, "method floor: the body has no camera");
  Result<Floor> floor = Floor::make(options.floor, cameras.front());
  if (!floor) return fail(floor.error());
  return AnyMethod(std::move(*floor));
}

Result<std::unique_ptr<Body>> make_sim(const Options& options, const std::function<void(const std::string&)>& warn) {
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
  config.truth_path = options.truth;
  config.warn = warn;
  return sim::make_sim_body(config);
}

}  // namespace

Result<std::unique_ptr<Body>> make_body(const Options& options, const std::function<void(const std::string&)>& warn) {
  if (options.body == "sim") return make_sim(options, warn);
  replay::ReplayBodyConfig config;
  config.folder = options.recording;
  config.camera = options.camera;
  config.warn = warn;
  return replay::make_replay_body(config);
}

Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const Body& body) {
  const NavigationConfig& config = options.navigation;
  if (const std::vector<Error> wrong = check(config); !wrong.empty()) return fail(wrong.front());
  Result<AnyMethod> method = make_method(options, body);
  if (!method) return fail(method.error());
  return std::visit(
      [&](auto&& chosen) -> Result<std::unique_ptr<Navigator>> {
        return agents::make_navigator(std::forward<decltype(chosen)>(chosen), config);
      },
      std::move(*method));
}

}  // namespace weft::agents
