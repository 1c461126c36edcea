#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/hall.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"

namespace weft::agents::sim {

inline constexpr std::size_t kHallSamples = 4;
inline constexpr int kHallBand = 4;  ///< rows of an image that are taken together

/// Describes the circumstances in which one image is taken.
struct HallShot {
  std::array<Pose3, kHallSamples> site_from_camera;  ///< in the middle of each quarter of the exposure
  /// Holds, of a rolling shutter, the same for each kHallBand rows; empty: all rows are taken at once.
  std::vector<std::array<Pose3, kHallSamples>> bands;
  double time_s = 0.0;      ///< of the body: what moves is there then
  double gain = 1.0;        ///< grey levels for what is 1 when the sensor is exposed as sites are lit for
  double noise_grey = 2.0;  ///< standard deviation
  std::uint64_t noise_seed = 0;
};

struct HallImage {
  Bytes grey;               ///< 8 bit, row-major
  double mean_light = 0.0;  ///< grey levels it would have had at gain 1, not cut off at white
};

struct HallCameraOptions {
  double vignetting = 0.0;  ///< loss in the corners
  double headlight = 0.0;   ///< of a lamp beside the camera: light on what is 2 m before it, 1 being the floor's mean
};

/// Renders what a camera that looks around in a hall sees: each pixel is the mean of four rays, at four moments of
/// the exposure and four places within it. Not for several threads.
class HallCamera {
 public:
  /// Takes the true camera; its width and height are multiples of 4.
  HallCamera(const CameraModel& camera, const HallCameraOptions& options, std::shared_ptr<const Hall> hall,
             std::vector<Mover> movers, const HallLight& light);
  /// Sets the light of another run.
  void set_light(const HallLight& light);

  HallImage take(const HallShot& shot);

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
    float right = 0.0F, down = 0.0F;  ///< of the pixel's middle, normalised
  };
  std::array<Sample, kHallSamples> samples_from(const std::array<Pose3, kHallSamples>& site_from_camera) const;
  void look(const HallShot& shot, const Moving& moving);
  void look_through(std::size_t from, const Sample& sample, const Moving& moving);
  void shade(const std::vector<ShadedFace>& faces, const RayPacket& rays, std::size_t from, std::uint32_t which);
  HallImage develop(const HallShot& shot) const;

  CameraModel camera_;
  HallCameraOptions options_;
  std::shared_ptr<const Hall> hall_;
  std::vector<Mover> movers_;
  HallLight light_;
  std::vector<ShadedFace> faces_;
  ShadeFace shade_face_ = shade_face();
  std::vector<float> ray_x_, ray_y_;       ///< normalised, without distortion; in blocks of 4 x 4 pixels
  std::vector<float> off_axis2_, length_;  ///< of such a ray
  std::vector<float> vignette_;
  std::vector<float> seen_;  ///< of the image being made, in blocks
  std::vector<float> noise_;
};

}  // namespace weft::agents::sim
