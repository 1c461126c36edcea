#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agents/methods/dead_reckoning.hpp"
#include "core/camera/camera_file.hpp"
#include "core/config/config.hpp"

/// Checks and reads the settings of methods that list them once: name, member, bounds.
namespace weft::agents {

template <class Config, class T>
struct Setting {
  std::string_view name;
  T Config::*member;
  T low;
  T high;
};

/// Adds an issue for each setting that breaks its bound; `of` is the method's name.
template <class Config, class T, std::size_t N>
void check_settings(std::string_view of, const std::array<Setting<Config, T>, N>& settings, const Config& config,
                    std::vector<std::string>& issues) {
  for (const auto& [name, member, low, high] : settings) {
    const T value = config.*member;
    if (value >= low && value <= high) continue;
    issues.push_back(std::string(of) + "." + std::string(name) + " = " + std::to_string(value) + " is not within [" +
                     std::to_string(low) + ", " + std::to_string(high) + "]");
  }
}

/// Takes settings from a table, which collects what is wrong with them.
template <class Config, std::size_t N>
void read_settings(const config::Table& table, const std::array<Setting<Config, int>, N>& settings, Config& config) {
  for (const auto& [name, member, low, high] : settings)
    config.*member = static_cast<int>(table.integer(name, config.*member, low, high));
}
template <class Config, std::size_t N>
void read_settings(const config::Table& table, const std::array<Setting<Config, double>, N>& settings,
                   Config& config) {
  for (const auto& [name, member, low, high] : settings)
    config.*member = table.number(name, config.*member, low, high);
}

inline constexpr auto kBlindShares = std::to_array<std::pair<std::string_view, double DeadReckoningConfig::*>>({
    {"wheel_distance_share", &DeadReckoningConfig::wheel_distance_share},
    {"wheel_heading_share", &DeadReckoningConfig::wheel_heading_share},
    {"command_distance_share", &DeadReckoningConfig::command_distance_share},
    {"command_heading_share", &DeadReckoningConfig::command_heading_share},
});

/// Adds an issue for each share that is none.
inline void check_blind(std::string_view of, const DeadReckoningConfig& blind, std::vector<std::string>& issues) {
  for (const auto& [name, member] : kBlindShares)
    if (!(blind.*member > 0.0 && blind.*member <= 1.0))
      issues.push_back(std::string(of) + ".blind." + std::string(name) + " is not within (0, 1]");
}

/// Takes the shares from a method's table `blind`.
inline void read_blind(const config::Table& table, DeadReckoningConfig& blind) {
  const config::Table shares = table.table("blind");
  for (const auto& [name, member] : kBlindShares) blind.*member = shares.number(name, blind.*member, 1e-6, 1.0);
}

/// Names what a calibration may state of itself, the setting that it stands for, and its bounds there.
template <class Config>
struct Stated {
  std::optional<double> CalibrationSigma::*sigma;
  double Config::*setting;
  double least;
  double most;
};

/// Returns the settings with what a calibration states in place of those that were not set.
template <class Config, std::size_t N>
Config with_stated(Config config, const CalibrationSigma& known, const std::array<Stated<Config>, N>& all) {
  const Config unset;
  for (const auto& [sigma, setting, least, most] : all) {
    const std::optional<double>& stated = known.*sigma;
    if (stated.has_value() && config.*setting == unset.*setting) config.*setting = std::clamp(*stated, least, most);
  }
  return config;
}

}  // namespace weft::agents
