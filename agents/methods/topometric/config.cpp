#include "agents/methods/topometric/config.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>

#include "agents/methods/topometric/each_setting.hpp"

namespace weft::agents {
namespace {

struct ConfigConflict {
  std::string_view part;
  std::string message;
};

/// Returns what does not go together, though each by itself is within its bounds.
std::vector<ConfigConflict> conflicts(const TopometricConfig& config) {
  std::vector<ConfigConflict> all;
  const auto take_one = [&](std::string_view part, const Result<void>& sound) {
    if (!sound) all.push_back({part, sound.error().message});
  };
  const auto take = [&](std::string_view part, const std::vector<Error>& errors) {
    for (const Error& error : errors) all.push_back({part, error.message});
  };
  take_one("odometry", check(config.open.seeing));
  take_one("disparity", check(config.disparity));
  take("scan", check(config.scan));
  take("rays", check(config.rays));
  take("filter", check(config.filter));
  take("costmap", check(config.costmap));
  take("local", check(config.local));
  if (config.window.least_frames > config.window.frames) all.push_back({"window", "least_frames exceeds frames"});
  if (config.place.fewest_features > config.place.features)
    all.push_back({"place", "fewest_features exceeds features"});
  if (config.place.fewest_points > config.place.most_points)
    all.push_back({"place", "fewest_points exceeds most_points"});
  if (config.relate.fewest_inliers > config.place.features)
    all.push_back({"relate", "fewest_inliers exceeds place.features"});
  return all;
}

/// Returns the table of that dotted name.
config::Table sub_table(const config::Table& table, std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return table.table(name);
  return sub_table(table.table(name.substr(0, dot)), name.substr(dot + 1));
}

/// Puts what the table says into a setting; the setting's own value is the default.
auto reader_of(const config::Table& table) {
  return [table](const char* name, auto& value, Low kind, double low, double high) {
    using Value = std::remove_reference_t<decltype(value)>;
    constexpr double above_open = 1e-6;
    if constexpr (std::is_same_v<Value, bool>) {
      value = table.boolean(name, value);
    } else if constexpr (std::is_integral_v<Value>) {
      value = static_cast<Value>(
          table.integer(name, static_cast<std::int64_t>(value), std::llround(low), std::llround(high)));
    } else {
      value = table.number(name, value, kind == Low::open ? low + above_open : low, high);
    }
  };
}

}  // namespace

std::vector<std::string> check(const TopometricConfig& config) {
  OutOfBounds out("topometric");
  each_topometric_setting(config, [&](const char* part) { return out.section(part); });
  std::vector<std::string> issues;
  for (const Error& error : out.issues) issues.push_back(error.message);
  if (!issues.empty()) return issues;
  for (const auto& [part, message] : conflicts(config))
    issues.push_back("topometric." + std::string(part) + ": " + message);
  return issues;
}

TopometricConfig read_topometric_config(const config::Table& table) {
  TopometricConfig config;
  each_topometric_setting(config, [&](const char* part) { return reader_of(sub_table(table, part)); });
  for (const auto& [part, message] : conflicts(config)) table.refuse(part, message);
  return config;
}

}  // namespace weft::agents
