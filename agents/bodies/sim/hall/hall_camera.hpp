#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/bloom.hpp"
#include "agents/bodies/sim/hall/carried.hpp"
#include "agents/bodies/sim/hall/hall.hpp"
#include "agents/bodies/sim/hall/sampled_rays.hpp"
#include "agents/bodies/sim/hall/unsteady_light.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"

namespace weft::agents::sim {

/// Describes the circumstances in which one image is taken.
struct HallShot {
  std::array<Pose3, kHallSamples> site_from_camera;  ///< in the middle of each quarter of the exposure
  /// Holds, of a rolling shutter, the same for each kHallBand rows; empty: all rows are taken at once.
  std::vector<std::array<Pose3, kHallSamples>> bands;
  double time_s = 0.0;                ///< of the body: what moves is there then
  std::vector<double> waited_s = {};  ///< of each mover, until then; empty: none has
  double gain = 1.0;                  ///< grey levels for what is 1 when the sensor is exposed as sites are lit for
  double noise_grey = 2.0;            ///< standard deviation
  std::uint64_t noise_seed = 0;
};

struct HallImage {
  Bytes grey;               ///< 8 bit, row-major
  double mean_light = 0.0;  ///< grey levels it would have had at gain 1, not cut off at white
  double mean_grey = 0.0;   ///< as it came out
};

struct HallCameraOptions {
  double vignetting = 0.0;  ///< loss in the corners
  double headlight = 0.0;   ///< of a lamp beside the camera: light on what is 2 m before it, 1 being the floor's mean
  double widest_rad = 0.0;  ///< off the axis, beyond which the lens lets no light in; 0: it fills the sensor
  double bloom = 0.0;       ///< share of light that scatters in the lens, about what is bright
  std::vector<Quad> carried = {};  ///< by the robot, in its frame, before the camera
};

/// Holds what is not always at one place of a hall.
struct Comings {
  std::vector<Mover> movers;
  std::vector<Obstacle> obstacles;
};

/// Renders what a camera that looks around in a hall sees: each pixel is the mean of four rays, at four moments of
/// the exposure and four places within it. Not for several threads.
class HallCamera {
 public:
  /// Takes the true camera; its width and height are multiples of 4.
  HallCamera(const CameraModel& camera, const HallCameraOptions& options, std::shared_ptr<const Hall> hall,
             Comings comings, const HallLight& light);
  /// Sets the light of another run.
  void set_light(const HallLight& light);

  HallImage take(const HallShot& shot);
  /// Returns how far away what stands still is along a pixel's ray, metres; infinite: there is nothing. For judges.
  double distance_m(const Pose3& site_from_camera, int column, int row) const;

 private:
  /// Holds the things that move, where they are when an image is taken.
  struct Moving {
    struct Sphere {
      Eigen::Vector3f middle = Eigen::Vector3f::Zero();
      float radius_m = 0.0F;
    };
    std::vector<ShadedFace> faces;
    QuadScene scene;
    std::vector<Sphere> around;  ///< each mover

    static Sphere around_of(std::span<const Quad> quads);
    bool may_be_met(const Eigen::Vector3f& eye, const Eigen::Vector3f& way, float focal_px) const;
  };
  std::vector<ShadedFace> faces_of(const std::vector<Quad>& quads, const std::vector<QuadLight>& light) const;
  /// Describes one of the looks through each pixel.
  struct Sample {
    Eigen::Vector3f eye = Eigen::Vector3f::Zero();
    Eigen::Matrix3f site_from_camera = Eigen::Matrix3f::Identity();
    std::size_t look = 0;  ///< which of them
  };
  std::array<Sample, kHallSamples> samples_from(const std::array<Pose3, kHallSamples>& site_from_camera) const;
  void relight(double time_s);
  Moving moving_at(const HallShot& shot) const;
  void look(const HallShot& shot, const Moving& moving);
  void look_through(std::size_t from, const Sample& sample, const Moving& moving);
  void shade(const std::vector<ShadedFace>& faces, const RayPacket& rays, std::size_t from, std::uint32_t which);
  bool sees_nothing(std::size_t block) const;
  double gather_light(const HallShot& shot);
  HallImage develop(const HallShot& shot);

  CameraModel camera_;
  HallCameraOptions options_;
  std::shared_ptr<const Hall> hall_;
  Comings comings_;
  HallLight light_;
  UnsteadyLight still_light_;
  std::vector<ShadedFace> faces_;
  ShadeFace shade_face_ = shade_face();
  SampledRays rays_;
  Carried carried_;
  Bloom bloom_;
  std::vector<bool> is_dark_;  ///< of a block: no ray through it needs to be cast
  std::vector<float> seen_;    ///< of the image being made, in blocks
  std::vector<float> noise_;
};

}  // namespace weft::agents::sim
