#include "agents/methods/bearing/config.hpp"

namespace weft::agents {
namespace {

/// Visits every setting but the description, with its bounds: visit(name, value, low, high).
template <class Config, class Visit>
void each_setting(Config& config, Visit&& visit) {
  visit("focal_px", config.focal_px, 100, 2000);
  visit("width_px", config.width_px, 64, 4096);
  visit("features", config.features.count, 20, 2000);
  visit("cell_widths", config.features.cell_widths, 0.005, 0.05);
  visit("smoothing_cells", config.features.smoothing_cells, 0.02, 1);
  visit("most_shift", config.vote.most_shift, 0.01, 1);
  visit("most_rise", config.vote.most_rise, 0.001, 1);
  visit("widest_rise", config.vote.widest_rise, 0.001, 1);
  visit("spread", config.vote.spread, 0.001, 0.2);
  visit("fewest_features", config.vote.fewest_features, 1, 1000);
  visit("above_chance", config.vote.above_chance, 0, 20);
  visit("noise_grey", config.exposure.noise_grey, 0.5, 50);
  visit("white_grey", config.exposure.white_grey, 128, 255);
  visit("hidden_slope", config.exposure.hidden_slope, 0.1, 10);
  visit("followed", config.exposure.followed, 0.05, 1);
  visit("most_blur_px", config.exposure.most_blur_px, 0.1, 50);
  visit("longest_time_s", config.exposure.longest_time_s, 1e-4, 0.5);
  visit("vote_sigma_rad", config.vote_sigma_rad, 1e-4, 0.2);
  visit("wheel_distance_share", config.wheel_distance_share, 1e-3, 1);
  visit("wheel_turn_rad_m", config.wheel_turn_rad_m, 1e-3, 1);
  visit("command_distance_share", config.command_distance_share, 1e-3, 1);
  visit("command_turn_rad_m", config.command_turn_rad_m, 1e-3, 1);
  visit("slip_m", config.slip_m, 1e-4, 0.5);
  visit("slip_rad", config.slip_rad, 1e-4, 0.5);
  visit("neighbours_m", config.neighbours_m, 0, 3);
  visit("most_neighbours", config.most_neighbours, 1, 21);
  visit("along_sigma_m", config.along_sigma_m, 0.001, 2);
  visit("focal_share", config.focal_share, 1e-4, 0.1);
  visit("anywhere_above_chance", config.anywhere_above_chance, 0, 50);
  visit("anywhere_runner_up", config.anywhere_runner_up, 0, 1);
  visit("anywhere_looming", config.anywhere_looming, 0.01, 2);
  visit("anywhere_inliers", config.anywhere_inliers, 0, 1000);
  visit("inlier_px", config.inlier_px, 0.1, 20);
  visit("anywhere_rival", config.anywhere_rival, 0, 1);
  visit("anywhere_rival_inliers", config.anywhere_rival_inliers, 0, 1000);
  visit("unknown_along_sigma_m", config.unknown_along_sigma_m, 0.05, 10);
  visit("learn_along_m", config.learn.along_m, 0.01, 0.5);
  visit("learn_along_sigma_m", config.learn.along_sigma_m, 0.005, 1);
  visit("learn_above_chance", config.learn.above_chance, 0, 50);
  visit("learn_heading_rad", config.learn.heading_rad, 0.001, 0.5);
  visit("learn_spread_rad", config.learn.spread_rad, 0.001, 0.2);
  visit("learn_moved_px", config.learn.moved_px, 0.5, 50);
  visit("learn_risen_px", config.learn.risen_px, 0.5, 50);
  visit("learn_features", config.learn.features, 20, 2000);
  visit("learn_newcomers", config.learn.newcomers, 0, 500);
  visit("learn_few_passes", config.learn.few_passes, 2, 100);
  visit("learn_hardly_ever", config.learn.hardly_ever, 0, 1);
  visit("learn_seldom", config.learn.seldom, 0, 1);
  visit("learn_fade_passes", config.learn.fade_passes, 4, 255);
  visit("learn_stays", config.learn.stays, 0, 1);
  visit("learn_worth", config.learn.worth, 0.01, 10);
}

/// Takes settings from a table, which collects what is wrong with them.
struct Taken {
  const config::Table& table;
  void operator()(const char* name, double& value, double low, double high) const {
    value = table.number(name, value, low, high);
  }
  void operator()(const char* name, int& value, double low, double high) const {
    value =
        static_cast<int>(table.integer(name, value, static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
  }
};

}  // namespace

std::vector<std::string> check(const BearingConfig& config) {
  std::vector<std::string> issues;
  each_setting(config, [&](const std::string& name, const auto& value, double low, double high) {
    const auto number = static_cast<double>(value);
    if (number >= low && number <= high) return;
    issues.push_back("bearing." + name + " is " + std::to_string(number) + "; it must be within [" +
                     std::to_string(low) + ", " + std::to_string(high) + "]");
  });
  return issues;
}

BearingConfig read_bearing_config(const config::Table& table) {
  BearingConfig config;
  each_setting(config, Taken{table});
  const std::string description = table.choice("description", "gradients", {"gradients", "brief"});
  config.features.description = description == "brief" ? Description::brief : Description::gradients;
  return config;
}

}  // namespace weft::agents
