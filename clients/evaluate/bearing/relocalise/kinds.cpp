#include "clients/evaluate/bearing/relocalise/kinds.hpp"

namespace weft::evaluate::bearing {

const std::vector<LookAlikes>& look_alikes() {
  using Where = LookAlikes::Where;
  static const std::vector<LookAlikes> all = {
      {"other-loads", "each rack its own loads", Loads::other, Where::taught, 0.8},
      {"other-loads-anywhere", "the same, put down anywhere, at any heading", Loads::other, Where::anywhere, 0.0},
      {"other-loads-not-taught", "the same, in the aisle that nobody taught", Loads::other, Where::not_taught, 0.0},
      {"one-side", "on the right all aisles hold the same", Loads::one_side, Where::taught, 0.7},
      {"one-side-not-taught", "the same, in the aisle that nobody taught", Loads::one_side, Where::not_taught, 0.0},
      {"same-loads", "all aisles hold the same", Loads::same, Where::taught, 0.0},
      {"same-loads-not-taught", "the same, in the aisle that nobody taught", Loads::same, Where::not_taught, 0.0,
       false},
  };
  return all;
}

const char* name_of(Loads loads) {
  switch (loads) {
    case Loads::other:
      return "other-loads";
    case Loads::one_side:
      return "one-side";
    case Loads::same:
      break;
  }
  return "same-loads";
}

const std::vector<OtherLight>& other_lights() {
  static const std::vector<OtherLight> all = {
      {"same", [](agents::sim::Site&) {}},
      {"half", [](agents::sim::Site& site) { site.change.lamps_failed = 0.5; }},
  };
  return all;
}

}  // namespace weft::evaluate::bearing
