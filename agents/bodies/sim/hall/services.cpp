#include "agents/bodies/sim/hall/services.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace weft::agents::sim {
namespace {

Quad look_of_metal(double grey) {
  Quad quad;
  quad.stuff = Stuff::duct;
  quad.grey = static_cast<float>(grey);
  return quad;
}

/// Describes what runs straight and level: where it begins, its heading and its length.
struct Run {
  Eigen::Vector2d from;
  double heading_rad, length_m;

  template <class Straight>
  static Run of(const Straight& it) {
    return {{it.x0, it.y0}, std::atan2(it.y1 - it.y0, it.x1 - it.x0), std::hypot(it.x1 - it.x0, it.y1 - it.y0)};
  }
  Eigen::Vector3d at(double along_m, double left_m, double z) const {
    const double c = std::cos(heading_rad);
    const double s = std::sin(heading_rad);
    return {from.x() + c * along_m - s * left_m, from.y() + s * along_m + c * left_m, z};
  }
  /// Calls `put` for each piece of at most `piece_m`: with its middle along the run and its length.
  template <class Put>
  void in_pieces(double piece_m, Put&& put) const {
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / piece_m)));
    for (int i = 0; i < pieces; ++i) put((i + 0.5) * length_m / pieces, length_m / pieces);
  }
};

void add_rod(const Eigen::Vector3d& lower_end, double ceiling_m, std::vector<Quad>& quads) {
  constexpr double side_m = 0.012;
  add_box({lower_end, 0.0, side_m, side_m, ceiling_m - lower_end.z()}, look_of_metal(110.0), quads);
}

}  // namespace

void add_duct(const Duct& duct, double ceiling_m, std::vector<Quad>& quads) {
  constexpr double joints_m = 1.2;
  constexpr double joint_m = 0.03;
  constexpr double hangs_m = 2.4;
  const Run run = Run::of(duct);
  const double bottom_m = ceiling_m - duct.below_m - duct.height_m;
  run.in_pieces(joints_m, [&](double along, double length) {
    add_closed_box({run.at(along, 0.0, bottom_m), run.heading_rad, length, duct.width_m, duct.height_m},
                   look_of_metal(duct.grey), quads);
    add_closed_box({run.at(along - 0.5 * length, 0.0, bottom_m - joint_m), run.heading_rad, joint_m,
                    duct.width_m + 2.0 * joint_m, duct.height_m + 2.0 * joint_m},
                   look_of_metal(0.8 * duct.grey), quads);
  });
  if (duct.below_m <= 0.0) return;
  run.in_pieces(hangs_m, [&](double along, double) {
    for (const double side : {-0.5, 0.5})
      add_rod(run.at(along, side * (duct.width_m + 0.08), bottom_m), ceiling_m, quads);
    add_closed_box({run.at(along, 0.0, bottom_m - 0.04), run.heading_rad, 0.04, duct.width_m + 0.16, 0.04},
                   look_of_metal(0.6 * duct.grey), quads);
  });
}

void add_pipe(const Pipe& pipe, double ceiling_m, std::vector<Quad>& quads) {
  constexpr int sides = 8;
  constexpr double piece_m = 2.0;
  constexpr double couplings_m = 3.0;
  const Run run = Run::of(pipe);
  const double z = ceiling_m - pipe.below_m;
  const auto add_round = [&](double along, double length, double radius, double grey) {
    for (int i = 0; i < sides; ++i) {
      const auto rim = [&](int corner) -> Eigen::Vector3d {
        const double angle = 2.0 * std::numbers::pi * (corner + 0.5) / sides;
        return run.at(along - 0.5 * length, radius * std::cos(angle), z + radius * std::sin(angle));
      };
      Quad side = look_of_metal(grey);
      side.corner = rim(i).cast<float>();
      side.across = (run.at(length, 0.0, 0.0) - run.at(0.0, 0.0, 0.0)).cast<float>();
      side.up = (rim(i + 1) - rim(i)).cast<float>();
      side.pattern = static_cast<std::uint32_t>(quads.size());
      quads.push_back(side);
    }
  };
  const double radius = 0.5 * pipe.diameter_m;
  run.in_pieces(piece_m, [&](double along, double length) {
    add_round(along, length, radius, pipe.grey);
    add_rod(run.at(along, 0.0, z), ceiling_m, quads);
    add_round(along, 0.03, 1.15 * radius + 0.004, 0.7 * pipe.grey);  // the clamp
  });
  run.in_pieces(couplings_m, [&](double along, double) {
    add_round(along + 0.6, 2.2 * pipe.diameter_m, 1.3 * radius, 1.1 * pipe.grey);
  });
}

void add_skylight(const Skylight& skylight, double ceiling_m, std::vector<Quad>& quads) {
  constexpr double frame_m = 0.08;
  constexpr double bars_m = 1.0;
  const Pose2& pose = skylight.site_from_skylight;
  const Run run{
      pose.translation() - 0.5 * skylight.length_m * Eigen::Vector2d(std::cos(pose.heading), std::sin(pose.heading)),
      pose.heading, skylight.length_m};
  const double z = ceiling_m - 0.1;
  Quad pane;
  pane.stuff = Stuff::skylight;
  pane.grey = static_cast<float>(128.0 * skylight.brightness);
  pane.corner = run.at(0.0, 0.5 * skylight.width_m, z).cast<float>();
  pane.across = (run.at(run.length_m, 0.0, z) - run.at(0.0, 0.0, z)).cast<float>();
  pane.up = (run.at(0.0, -skylight.width_m, z) - run.at(0.0, 0.0, z)).cast<float>();
  quads.push_back(pane);
  const double low = z - frame_m;
  for (const double side : {-0.5, 0.5}) {
    add_closed_box({run.at(0.5 * run.length_m, side * skylight.width_m, low), run.heading_rad, run.length_m + frame_m,
                    frame_m, frame_m + 0.02},
                   look_of_metal(160.0), quads);
    add_closed_box(
        {run.at((0.5 + side) * run.length_m, 0.0, low), run.heading_rad, frame_m, skylight.width_m, frame_m + 0.02},
        look_of_metal(160.0), quads);
  }
  run.in_pieces(bars_m, [&](double along, double length) {
    if (along + 0.6 * length > run.length_m) return;
    add_closed_box({run.at(along + 0.5 * length, 0.0, z - 0.04), run.heading_rad, 0.04, skylight.width_m, 0.04},
                   look_of_metal(140.0), quads);
  });
}

void add_sprinkler(double x, double y, double ceiling_m, std::vector<Quad>& quads) {
  add_closed_box({{x, y, ceiling_m - 0.2}, 0.0, 0.03, 0.03, 0.2}, look_of_metal(170.0), quads);
  add_closed_box({{x, y, ceiling_m - 0.21}, 0.0, 0.09, 0.09, 0.01}, look_of_metal(60.0), quads);
}

void add_hanging_sign(double x, double y, double ceiling_m, Random& random, std::vector<Quad>& quads) {
  constexpr double lowest_m = 2.2;
  const double height = random.uniform(0.25, 0.45);
  const double length = random.uniform(0.7, 1.3);
  const double bottom = std::max(lowest_m, ceiling_m - random.uniform(0.8, 1.5) - height);
  if (bottom + height > ceiling_m - 0.1) return;
  const double heading = random.chance(0.5) ? 0.0 : std::numbers::pi / 2;
  Quad look = look_of_metal(random.uniform(90.0, 150.0));
  look.stuff = Stuff::sign;
  look.pattern = static_cast<std::uint32_t>(random.below(1U << 20U));
  add_closed_box({{x, y, bottom}, heading, length, 0.03, height}, look, quads);
  const Run run{{x, y}, heading, length};
  for (const double end : {-0.4, 0.4}) add_rod(run.at(end * length, 0.0, bottom + height), ceiling_m, quads);
}

}  // namespace weft::agents::sim
