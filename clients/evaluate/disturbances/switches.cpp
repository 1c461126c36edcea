#include "clients/evaluate/disturbances/switches.hpp"

#include <array>

namespace weft::evaluate {
namespace {

using agents::sim::Disturbances;
using Field = double Disturbances::*;

/// What belongs together is switched together. The band of the vibration is no disturbance by itself.
struct Switch {
  const char* name;
  std::array<Field, 3> fields;  ///< null: unused
};
constexpr std::array kSwitches = {
    Switch{"focal length", {&Disturbances::focal_error}},
    Switch{"principal point", {&Disturbances::centre_error_px}},
    Switch{"lens", {&Disturbances::distortion_error_px}},
    Switch{"mount position", {&Disturbances::mount_error_m}},
    Switch{"mount angle", {&Disturbances::mount_error_rad}},
    Switch{"vibration, angle", {&Disturbances::vibration_rad}},
    Switch{"vibration, height", {&Disturbances::vibration_m}},
    Switch{"blur", {&Disturbances::exposure_s}},
    Switch{"noise", {&Disturbances::noise_grey}},
    Switch{"vignetting", {&Disturbances::vignetting}},
    Switch{"exposure drift", {&Disturbances::exposure_drift}},
    Switch{"dropped frames", {&Disturbances::dropped_frames}},
    Switch{"time jitter", {&Disturbances::time_jitter_s}},
    Switch{"wheels and slip",
           {&Disturbances::wheel_scale_error, &Disturbances::wheel_asymmetry, &Disturbances::slip}},
    Switch{"light", {&Disturbances::light_change}},
    Switch{"own shadow", {&Disturbances::shadow}},
};

Disturbances with(Disturbances into, const Switch& which, const Disturbances& from) {
  for (const Field field : which.fields) {
    if (field != nullptr) into.*field = from.*field;
  }
  return into;
}

/// The band stays: it shapes a vibration of no height and angle.
Disturbances none_of(const Disturbances& site) {
  const Disturbances off = [] {
    Disturbances zero;
    for (const Switch& each : kSwitches) {
      for (const Field field : each.fields) {
        if (field != nullptr) zero.*field = 0.0;
      }
    }
    return zero;
  }();
  Disturbances none = site;
  for (const Switch& each : kSwitches) none = with(none, each, off);
  return none;
}

}  // namespace

std::string name_of(const Variant& variant) {
  switch (variant.kind) {
    case Variant::Kind::none:
      return "none";
    case Variant::Kind::all:
      return "all";
    case Variant::Kind::without:
      return "without " + variant.disturbance;
    case Variant::Kind::only:
      break;
  }
  return "only " + variant.disturbance;
}

std::vector<std::string> disturbance_names() {
  std::vector<std::string> names;
  for (const Switch& each : kSwitches) names.emplace_back(each.name);
  return names;
}

std::vector<Variant> variants_of(const Disturbances& site) {
  const Disturbances none = none_of(site);
  std::vector<Variant> variants = {{Variant::Kind::none, "", none}, {Variant::Kind::all, "", site}};
  for (const Switch& each : kSwitches) {
    variants.push_back({Variant::Kind::without, each.name, with(site, each, none)});
    variants.push_back({Variant::Kind::only, each.name, with(none, each, site)});
  }
  return variants;
}

}  // namespace weft::evaluate
