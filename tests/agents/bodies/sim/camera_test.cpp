#include "agents/bodies/sim/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/floor/procedural.hpp"
#include "agents/perception/lens.hpp"
#include "marks_seen.hpp"
#include "sites.hpp"

namespace weft::agents::sim {
namespace {

/// Arranges a hall lit from everywhere, seen by a camera without any fault but what a test sets.
class CameraSees : public testing::Test {
 protected:
  CameraSees() {
    site_ = empty_site();
    site_.lamps.clear();
    site_.disturbances = no_disturbances();
  }

  Camera camera(std::shared_ptr<const FloorSource> floor = std::make_shared<DottedFloor>(),
                const CameraOptions& options = {}) {
    const double gloss = floor->gloss();
    return Camera(model_, options, std::move(floor), std::make_shared<const Scene>(site_.boxes),
                  Light(site_, gloss, Random(1)));
  }

  FloorShot still(const Pose2& site_from_robot) const {
    FloorShot shot;
    shot.site_from_camera_mid = lift(site_from_robot) * model_.robot_from_camera;
    shot.site_from_camera.fill(shot.site_from_camera_mid);
    shot.body = {site_from_robot.x, site_from_robot.y, site_.base.radius_m, site_.base.body_height_m};
    return shot;
  }

  /// Returns the same while driving: `moved_m` ahead and `turned_rad` from the exposure's begin to its end.
  FloorShot moving(const Pose2& site_from_robot, double moved_m, double turned_rad) const {
    FloorShot shot = still(site_from_robot);
    for (std::size_t k = 0; k < kSubsamples; ++k) {
      const double share = kSubsampleTime[k];
      shot.site_from_camera[k] =
          lift(site_from_robot * se2_exp(Eigen::Vector3d(share * moved_m, 0.0, share * turned_rad))) *
          model_.robot_from_camera;
    }
    return shot;
  }

  Eigen::Vector2d pixel_of(const Pose3& site_from_camera, const Eigen::Vector3d& in_site) const {
    return sim::pixel_of(model_, site_from_camera, in_site);
  }

  int at(const Bytes& image, int u, int v) const { return image[static_cast<std::size_t>(v * model_.width + u)]; }

  Site site_;
  CameraModel model_ = given_camera_from(CameraSetup{}, no_disturbances(), "r1", 0);
};

TEST_F(CameraSees, MarksWhereTheTrueModelProjectsThem) {
  Camera subject = camera();
  const FloorShot shot = still({3.137, 2.071, 0.7});
  expect_where_they_belong(
      marks_seen(model_, shot.site_from_camera_mid, subject.render(shot), [&](const Eigen::Vector2d& p) {
        return pixel_of(shot.site_from_camera_mid, {p.x(), p.y(), 0.0});
      }));
}

/// Holds the spread (variance, px^2) of one mark's darkness along the columns and rows.
struct Spread {
  double across = 0.0, down = 0.0;
};
Spread spread_of(const Bytes& image, int width, const Eigen::Vector2d& centre) {
  double weights = 0.0;
  double u_sum = 0.0, v_sum = 0.0, uu = 0.0, vv = 0.0;
  for (int v = static_cast<int>(centre.y()) - 30; v <= centre.y() + 30; ++v) {
    for (int u = static_cast<int>(centre.x()) - 30; u <= centre.x() + 30; ++u) {
      const double dark = std::max(0.0, 200.0 - image[static_cast<std::size_t>(v * width + u)]);
      weights += dark;
      u_sum += dark * u;
      v_sum += dark * v;
      uu += dark * u * u;
      vv += dark * v * v;
    }
  }
  return {uu / weights - std::pow(u_sum / weights, 2), vv / weights - std::pow(v_sum / weights, 2)};
}

TEST_F(CameraSees, BlurRunsAlongTheMotion) {
  // One mark straight ahead.
  const Pose2 site_from_robot{3.0 - 0.85, 2.0, 0.0};
  Camera subject = camera();
  const Eigen::Vector2d centre =
      pixel_of(still(site_from_robot).site_from_camera_mid, Eigen::Vector3d(3.0, 2.0, 0.0));
  const Spread sharp = spread_of(subject.render(still(site_from_robot)), model_.width, centre);
  const Spread driven = spread_of(subject.render(moving(site_from_robot, 0.02, 0.0)), model_.width, centre);
  const Spread turned = spread_of(subject.render(moving(site_from_robot, 0.0, 0.02)), model_.width, centre);
  EXPECT_GT(driven.down, sharp.down + 2.0);
  EXPECT_NEAR(driven.across, sharp.across, 1.0);
  EXPECT_GT(turned.across, sharp.across + 2.0);
  EXPECT_NEAR(turned.down, sharp.down, 1.0);
}

TEST_F(CameraSees, ARackStandsBeforeTheFloor) {
  site_.boxes.push_back({Box::Kind::pillar, "pillar", {3.5, 2.0, 0.0}, 0.4, 0.4, 3.0});
  const Pose2 site_from_robot{2.0, 2.0, 0.0};
  Camera with = camera();
  const FloorShot shot = still(site_from_robot);
  const Bytes seen = with.render(shot);
  site_.boxes.clear();
  Camera without = camera();
  const Bytes bare = without.render(shot);
  // The face at x = 3.3 stands on the floor between y = 1.8 and 2.2 and rises out of the picture.
  int changed_inside = 0;
  int changed_outside = 0;
  int inside = 0;
  const Pose3 camera_from_site = shot.site_from_camera_mid.inverse();
  for (int v = 0; v < model_.height; v += 3) {
    for (int u = 0; u < model_.width; u += 3) {
      const Eigen::Vector2d ray = normalised_from_pixel(model_, {u, v});
      const Eigen::Vector3d direction = camera_from_site.rotation.inverse() * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
      const Eigen::Vector3d& eye = shot.site_from_camera_mid.translation;
      const double t = (3.3 - eye.x()) / direction.x();
      const Eigen::Vector3d hit = eye + t * direction;
      const bool hits = direction.x() > 0.0 && std::abs(hit.y() - 2.0) < 0.2 && hit.z() > 0.0 && hit.z() < 3.0;
      const double rim = std::min({std::abs(std::abs(hit.y() - 2.0) - 0.2), std::abs(hit.z())});
      if (rim < 0.01) {
        continue;  // the edge itself
      }
      inside += hits;
      (hits ? changed_inside : changed_outside) += std::abs(at(seen, u, v) - at(bare, u, v)) > 3;
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(changed_inside, inside * 8 / 10);
  EXPECT_EQ(changed_outside, 0);
}

TEST_F(CameraSees, ShineMovesWithTheViewAndNotWithTheFloor) {
  class Glossy final : public FloorSource {
   public:
    void fill(TileKey, std::span<std::uint8_t> texels) const override {
      std::fill(texels.begin(), texels.end(), 100);
    }
    double gloss() const override { return 60.0; }
  };
  site_.lamps.push_back({9.0, 6.0, 6.0, 1.0});
  Camera subject = camera(std::make_shared<Glossy>());
  const auto brightest_ahead_m = [&](double x) {
    const FloorShot shot = still({x, 6.0, 0.0});
    const Bytes image = subject.render(shot);
    double best = -1.0;
    double where = 0.0;
    for (double ahead = 0.5; ahead < 2.2; ahead += 0.01) {
      const Eigen::Vector2d p = pixel_of(shot.site_from_camera_mid, {x + ahead, 6.0, 0.0});
      if (p.y() > 0 && p.y() < model_.height) {
        const double grey = at(image, static_cast<int>(p.x()), static_cast<int>(p.y()));
        if (grey > best) {
          best = grey;
          where = x + ahead;
        }
      }
    }
    return where;
  };
  // The mirrored lamp is seen on the floor where the angles agree: 0.6 / 6.6 of the way from eye to lamp.
  const double before = brightest_ahead_m(0.0);
  const double after = brightest_ahead_m(2.0);
  EXPECT_NEAR(before, 0.25 + (9.0 - 0.25) * 0.6 / 6.6, 0.35);
  EXPECT_GT(after - before, 1.0);
}

TEST_F(CameraSees, ItsOwnShadowWhenALampIsBehind) {
  class Flat final : public FloorSource {
   public:
    void fill(TileKey, std::span<std::uint8_t> texels) const override {
      std::fill(texels.begin(), texels.end(), 120);
    }
    double gloss() const override { return 0.0; }
  };
  site_.lamps.push_back({0.0, 6.0, 3.0, 3.0});
  CameraOptions shaded;
  shaded.shadow = 1.0;
  Camera with = camera(std::make_shared<Flat>(), shaded);
  Camera without = camera(std::make_shared<Flat>());
  const FloorShot shot = still({3.0, 6.0, 0.0});
  const Bytes a = with.render(shot);
  const Bytes b = without.render(shot);
  EXPECT_LT(at(a, 376, 475), at(b, 376, 475) - 15);
  EXPECT_EQ(at(a, 376, 5), at(b, 376, 5));
}

TEST_F(CameraSees, CornersAreDarkerByTheVignetting) {
  class Flat final : public FloorSource {
   public:
    void fill(TileKey, std::span<std::uint8_t> texels) const override {
      std::fill(texels.begin(), texels.end(), 200);
    }
    double gloss() const override { return 0.0; }
  };
  CameraOptions options;
  options.vignetting = 0.2;
  Camera subject = camera(std::make_shared<Flat>(), options);
  const Bytes image = subject.render(still({3.0, 6.0, 0.0}));
  EXPECT_NEAR(at(image, 376, 240), 200, 2);
  EXPECT_NEAR(at(image, 0, 0), 160, 2);
  EXPECT_NEAR(at(image, 751, 479), 160, 2);
}

TEST_F(CameraSees, DirtOnTheLensAtTheSamePlaceOfEveryImage) {
  class Flat final : public FloorSource {
   public:
    void fill(TileKey, std::span<std::uint8_t> texels) const override {
      std::fill(texels.begin(), texels.end(), 200);
    }
    double gloss() const override { return 0.0; }
  };
  CameraOptions options;
  options.lens_spots = 10;
  options.lens_depth = 0.8;
  Camera subject = camera(std::make_shared<Flat>(), options);
  const Bytes image = subject.render(still({3.0, 6.0, 0.0}));
  EXPECT_EQ(image, subject.render(still({9.0, 2.0, 1.0})));
  const auto dark = std::count_if(image.begin(), image.end(), [](int grey) { return grey < 150; });
  EXPECT_GT(dark, 500);
  EXPECT_LT(dark, static_cast<std::ptrdiff_t>(image.size() / 5));
  options.lens_seed = 7;
  EXPECT_NE(image, camera(std::make_shared<Flat>(), options).render(still({3.0, 6.0, 0.0})));
}

TEST_F(CameraSees, NoiseOfTheStatedSize) {
  CameraOptions options;
  options.noise_grey = 2.0;
  Camera noisy = camera(std::make_shared<DottedFloor>(), options);
  FloorShot shot = still({3.0, 6.0, 0.0});
  shot.noise_seed = 1;
  const Bytes a = noisy.render(shot);
  shot.noise_seed = 2;
  const Bytes b = noisy.render(shot);
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += std::pow(a[i] - b[i], 2);
  }
  // Two independent noises, each rounded to whole levels.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(a.size()) / 2.0), std::hypot(2.0, std::sqrt(1.0 / 12.0)), 0.05);
}

TEST_F(CameraSees, TheSameFloorFromTwoPlaces) {
  // Nothing swims: where both images see a piece of floor, they agree on it.
  auto floor = make_procedural_floor(site_.floor);
  ASSERT_TRUE(floor);
  site_.floor.gloss = 0.0;
  Camera subject = camera(*floor);
  const FloorShot first = still({5.0, 6.0, 0.3});
  const FloorShot second = still({5.15, 6.02, 0.35});
  const Bytes a = subject.render(first);
  const Bytes b = subject.render(second);
  double sum_ab = 0.0, sum_aa = 0.0, sum_bb = 0.0, sum_a = 0.0, sum_b = 0.0;
  int n = 0;
  for (double ahead = 0.7; ahead < 1.2; ahead += 0.004) {
    for (double left = -0.3; left < 0.3; left += 0.004) {
      const Eigen::Vector2d p = Pose2{5.0, 6.0, 0.3} * Eigen::Vector2d(ahead, left);
      const Eigen::Vector2d ua = pixel_of(first.site_from_camera_mid, {p.x(), p.y(), 0.0});
      const Eigen::Vector2d ub = pixel_of(second.site_from_camera_mid, {p.x(), p.y(), 0.0});
      const double ga = at(a, static_cast<int>(std::lround(ua.x())), static_cast<int>(std::lround(ua.y())));
      const double gb = at(b, static_cast<int>(std::lround(ub.x())), static_cast<int>(std::lround(ub.y())));
      sum_a += ga;
      sum_b += gb;
      sum_ab += ga * gb;
      sum_aa += ga * ga;
      sum_bb += gb * gb;
      ++n;
    }
  }
  const double correlation =
      (sum_ab - sum_a * sum_b / n) / std::sqrt((sum_aa - sum_a * sum_a / n) * (sum_bb - sum_b * sum_b / n));
  EXPECT_GT(correlation, 0.7);
}

}  // namespace
}  // namespace weft::agents::sim
