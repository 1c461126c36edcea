#include "clients/evaluate/ceiling/navigators.hpp"

#include <utility>

#include "agents/navigation/method_settings.hpp"
#include "agents/navigation/navigator_of.hpp"

namespace weft::evaluate::ceiling {

using namespace agents;

floor::MakeNavigator ceiling_navigator(const CeilingConfig& settings, Look look) {
  return [settings, look = std::move(look)](
             const CameraModel& camera, std::shared_ptr<floor::SeenStep> seen) -> Result<std::unique_ptr<Navigator>> {
    Result<Ceiling> method = Ceiling::make(settings, camera);
    if (!method) return fail(method.error());
    return make_navigator(floor::Watched<Ceiling>(std::move(*method), std::move(seen), look),
                          navigation_defaults<Ceiling>());
  };
}

CeilingConfig one_plane(CeilingConfig settings) {
  settings.heights_tilt_rad = 1e-4;  // its lower bound: no mount's tilt is ever known so well
  return settings;
}

}  // namespace weft::evaluate::ceiling
