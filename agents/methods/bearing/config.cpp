#include "agents/methods/bearing/config.hpp"

#include <tuple>

namespace weft::agents {
namespace {

struct Number {
  const char* name;
  double BearingConfig::*value;
  double low, high;
};
constexpr Number kNumbers[] = {
    {"focal_px", &BearingConfig::focal_px, 100.0, 2000.0},
    {"vote_sigma_rad", &BearingConfig::vote_sigma_rad, 1e-4, 0.2},
    {"wheel_distance_share", &BearingConfig::wheel_distance_share, 1e-3, 1.0},
    {"wheel_heading_share", &BearingConfig::wheel_heading_share, 1e-3, 1.0},
    {"command_distance_share", &BearingConfig::command_distance_share, 1e-3, 1.0},
    {"command_heading_share", &BearingConfig::command_heading_share, 1e-3, 1.0},
    {"neighbours_m", &BearingConfig::neighbours_m, 0.0, 3.0},
    {"along_sigma_m", &BearingConfig::along_sigma_m, 0.01, 2.0},
    {"unknown_along_sigma_m", &BearingConfig::unknown_along_sigma_m, 0.05, 10.0},
};

}  // namespace

std::vector<std::string> check(const BearingConfig& config) {
  std::vector<std::string> issues;
  const auto within = [&](const std::string& name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      issues.push_back("bearing." + name + " is not within [" + std::to_string(low) + ", " + std::to_string(high) +
                       "]");
  };
  for (const Number& number : kNumbers) within(number.name, config.*number.value, number.low, number.high);
  within("width_px", config.width_px, 64, 4096);
  within("most_neighbours", config.most_neighbours, 1, 21);
  within("features.count", config.features.count, 20, 2000);
  within("features.cell_widths", config.features.cell_widths, 0.005, 0.05);
  within("features.smoothing_cells", config.features.smoothing_cells, 0.02, 1.0);
  within("vote.most_shift", config.vote.most_shift, 0.01, 1.0);
  within("vote.most_rise", config.vote.most_rise, 0.001, 1.0);
  within("vote.spread", config.vote.spread, 0.001, 0.2);
  within("vote.fewest_features", config.vote.fewest_features, 1, 1000);
  within("vote.above_chance", config.vote.above_chance, 0.0, 20.0);
  return issues;
}

BearingConfig read_bearing_config(const config::Table& table) {
  BearingConfig config;
  for (const Number& number : kNumbers)
    config.*number.value = table.number(number.name, config.*number.value, number.low, number.high);
  config.width_px = static_cast<int>(table.integer("width_px", config.width_px, 64, 4096));
  config.most_neighbours = static_cast<int>(table.integer("most_neighbours", config.most_neighbours, 1, 21));
  config.features.count = static_cast<int>(table.integer("features", config.features.count, 20, 2000));
  config.features.description = table.choice("description", "gradients", {"gradients", "brief"}) == "brief"
                                    ? Description::brief
                                    : Description::gradients;
  config.vote.above_chance = table.number("above_chance", config.vote.above_chance, 0.0, 20.0);
  return config;
}

}  // namespace weft::agents
