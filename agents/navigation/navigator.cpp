#include "agents/navigation/navigator.hpp"

#include "agents/navigation/run_refiner.hpp"

namespace weft::agents {

std::unique_ptr<RunRefiner> Navigator::refiner(std::string_view /*method*/) const {
  return nullptr;
}

}  // namespace weft::agents
