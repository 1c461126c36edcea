#include "agents/perception/particles/likelihood_field.hpp"

#include <algorithm>
#include <cmath>

#include "agents/perception/particles/field_kernel.hpp"

namespace weft::agents {
namespace {

constexpr int kFarthest = 254;
constexpr std::uint8_t kUnknown = 255;
constexpr std::size_t kWidths = 32;             // of obstacles; then as many of edges of a floor
constexpr std::size_t kTwice = 5;               // so many widths farther it is twice as wide
constexpr double kWiderBy = 1.148698354997035;  // the fifth root of 2: the last width is 74 cells

double sigma_of(std::size_t width, double cell_m) {
  return cell_m * std::pow(kWiderBy, static_cast<double>(width));
}

/// Adds the log-likelihoods of ends of one kind and standard deviation: by code, that of unknown cells last.
void add_logs_of(const LikelihoodConfig& config, double share, double sigma_m, double by_metre,
                 std::vector<float>& logs) {
  for (int code = 0; code <= kFarthest; ++code) {
    const double off = code / by_metre / sigma_m;
    logs.push_back(static_cast<float>(std::log(1.0 - share + share * std::exp(-0.5 * off * off))));
  }
  logs.push_back(static_cast<float>((1.0 - config.neutral) * std::log(1.0 - share)));
}

}  // namespace

LikelihoodField::LikelihoodField(const LikelihoodConfig& config, const Raster& raster, std::span<const float> metres)
    : config_(config), raster_(raster) {
  const auto wide = static_cast<std::size_t>(raster.columns) + 2;
  codes_.assign(wide * (static_cast<std::size_t>(raster.rows) + 2) + 3, kUnknown);
  const double by_metre = kFarthest / config.most_m;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const auto distance_m = static_cast<double>(metres[raster.index({column, row})]);
      if (!(distance_m >= 0.0)) continue;
      const double code = std::min(std::round(distance_m * by_metre), static_cast<double>(kFarthest));
      codes_[(static_cast<std::size_t>(row) + 1) * wide + static_cast<std::size_t>(column) + 1] =
          static_cast<std::uint8_t>(code);
    }
  }
  for (const double share : {config.hit_share, config.edge_share})
    for (std::size_t width = 0; width < kWidths; ++width)
      add_logs_of(config, share, sigma_of(width, raster.cell_m), by_metre, logs_);
}

std::size_t LikelihoodField::width_of(const Beam& beam) const {
  const double steps = std::log(std::hypot(1.0, beam.sigma_m / raster_.cell_m)) / std::log(kWiderBy);
  const std::size_t width = std::min(static_cast<std::size_t>(std::lround(std::max(0.0, steps))), kWidths - 1);
  return beam.kind == Beam::Return::floor_edge ? kWidths + width : width;
}

std::vector<BeamEnd> LikelihoodField::ends_of(const Scan& scan) const {
  std::vector<const Beam*> returned;
  for (const Beam& beam : scan.beams)
    if (beam.kind != Beam::Return::none) returned.push_back(&beam);
  const std::size_t count = std::min(returned.size(), static_cast<std::size_t>(config_.beams));
  std::vector<BeamEnd> ends;
  ends.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Beam& beam = *returned[(2 * i + 1) * returned.size() / (2 * count)];
    const Eigen::Vector2d end = scan.robot_from_scan * Eigen::Vector2d(beam.range_m * std::cos(beam.bearing_rad),
                                                                       beam.range_m * std::sin(beam.bearing_rad));
    ends.push_back({static_cast<float>(end.x()), static_cast<float>(end.y()), width_of(beam)});
  }
  return ends;
}

bool LikelihoodField::knows(const Pose2& map_from_robot, const BeamEnd& end) const {
  const Cell cell = raster_.cell_at(map_from_robot * Eigen::Vector2d(double(end.x), double(end.y)));
  if (!raster_.holds(cell)) return false;
  const auto wide = static_cast<std::size_t>(raster_.columns) + 2;
  return codes_[(static_cast<std::size_t>(cell.row) + 1) * wide + static_cast<std::size_t>(cell.column) + 1] !=
         kUnknown;
}

void LikelihoodField::widen(std::vector<BeamEnd>& ends) {
  for (BeamEnd& end : ends) {
    const std::size_t widest = end.width < kWidths ? kWidths - 1 : 2 * kWidths - 1;
    end.width = std::min(end.width + kTwice, widest);
  }
}

void LikelihoodField::weigh(std::span<const BeamEnd> ends, const ParticleSet& particles,
                            std::span<float> logs) const {
  add_logs({raster_, codes_.data(), logs_.data()}, ends, particles, logs);
}

void LikelihoodField::weigh_plain(std::span<const BeamEnd> ends, const ParticleSet& particles,
                                  std::span<float> logs) const {
  add_logs_plain({raster_, codes_.data(), logs_.data()}, ends, particles, logs);
}

}  // namespace weft::agents
