#include "clients/evaluate/disturbances/switches.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace weft::evaluate {
namespace {

using agents::sim::Disturbances;
using Field = double Disturbances::*;

/// Switches together what belongs together. The band of the vibration is no disturbance by itself.
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

/// Names a disturbance that is off by default, and the size at which it is studied.
struct Harder {
  const char* name;
  Field field;
  double size;
};
constexpr std::array kHarder = {
    Harder{"floor uneven by 2 mm", &Disturbances::unevenness_m, 0.002},
    Harder{"rolling shutter 20 ms", &Disturbances::rolling_shutter_s, 0.02},
    Harder{"stamps 10 ms late", &Disturbances::time_offset_s, 0.01},
};

Disturbances with(Disturbances into, const Switch& which, const Disturbances& from) {
  for (const Field field : which.fields) {
    if (field != nullptr) into.*field = from.*field;
  }
  return into;
}

/// Turns all disturbances off. The vibration's band stays: without height and angle it shapes nothing.
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
  for (const Harder& each : kHarder) none.*each.field = 0.0;
  return none;
}

Disturbances with(Disturbances into, const Harder& which) {
  into.*which.field = which.size;
  return into;
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
    case Variant::Kind::with:
      return "with " + variant.disturbance;
    case Variant::Kind::only:
      break;
  }
  return "only " + variant.disturbance;
}

std::vector<std::string> disturbance_names() {
  std::vector<std::string> names;
  for (const Switch& each : kSwitches) names.emplace_back(each.name);
  for (const Harder& each : kHarder) names.emplace_back(each.name);
  return names;
}

std::vector<Variant> variants_of(const Disturbances& site) {
  const Disturbances none = none_of(site);
  std::vector<Variant> variants = {{Variant::Kind::none, "", none}, {Variant::Kind::all, "", site}};
  for (const Switch& each : kSwitches) {
    variants.push_back({Variant::Kind::without, each.name, with(site, each, none)});
    variants.push_back({Variant::Kind::only, each.name, with(none, each, site)});
  }
  for (const Harder& each : kHarder) {
    variants.push_back({Variant::Kind::with, each.name, with(site, each)});
    variants.push_back({Variant::Kind::only, each.name, with(none, each)});
  }
  return variants;
}

Result<std::vector<Variant>> named(const std::vector<Variant>& all, const std::vector<std::string>& names) {
  if (names.empty()) return all;
  const auto means = [](const std::string& name, const Variant& variant) {
    return name == name_of(variant) || (!name.empty() && name == variant.disturbance);
  };
  for (const std::string& name : names) {
    if (std::any_of(all.begin(), all.end(), [&](const Variant& variant) { return means(name, variant); })) continue;
    std::string there;
    for (const std::string& each : disturbance_names()) there += ", '" + each + "'";
    return fail(ErrorCode::invalid, "--only: there is no '" + name + "'; there are 'none', 'all'" + there +
                                        ", and each of these after 'only', 'without' or 'with'");
  }
  std::vector<Variant> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), [&](const Variant& variant) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return means(name, variant); });
  });
  return some;
}

}  // namespace weft::evaluate
