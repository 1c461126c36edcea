#pragma once
#include <memory>
#include <string>

#include "tests/agents/methods/tiny/roamer.hpp"
#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {

/// Arranges robots that find their own way.
class RoamerFleet : public MarksFleet {
 protected:
  std::unique_ptr<Navigator> navigator() const override { return make_navigator(tiny::Roamer(noted), navigation); }
  std::string method() const override { return "roamer"; }

  std::shared_ptr<tiny::Roamer::Noted> noted = std::make_shared<tiny::Roamer::Noted>();
};

}  // namespace weft::agents
