#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "agents/bodies/sim/hall/hall.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"

namespace weft::agents::sim {

inline constexpr std::size_t kHallSamples = 4;

/// One image's circumstances.
struct HallShot {
  std::array<Pose3, kHallSamples> site_from_camera;  ///< in the middle of each quarter of the exposure
  double time_s = 0.0;                               ///< of the body: what moves is there then
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

/// A camera that looks around in a hall: each pixel is the mean of four rays, at four moments of the exposure and
/// four places within it. Not for several threads.
class HallCamera {
 public:
  /// `camera` is the true one; width and height are multiples of 4.
  HallCamera(const CameraModel& camera, const HallCameraOptions& options, std::shared_ptr<const Hall> hall,
             std::vector<Mover> movers, const HallLight& light);
  /// Another run's.
  void set_light(const HallLight& light);

  HallImage take(const HallShot& shot);

 private:
  struct Moving {
    std::vector<Quad> quads;
    std::vector<QuadLight> light;
    QuadScene scene;
  };
  /// What shading a quad needs.
  struct Face {
    const Quad* quad;
    float across_m, up_m;
    Eigen::Vector3f normal;
    QuadLight light;
  };
  static std::vector<Face> faces_of(const std::vector<Quad>& quads, const std::vector<QuadLight>& light);
  void look(const HallShot& shot, const std::vector<Face>& moving, const QuadScene& scene);
  float seen(const Face& face, const RayPacket& rays, std::size_t i, float off_axis2) const;
  HallImage develop(const HallShot& shot) const;

  CameraModel camera_;
  HallCameraOptions options_;
  std::shared_ptr<const Hall> hall_;
  std::vector<Mover> movers_;
  HallLight light_;
  std::vector<Face> faces_;
  std::vector<float> ray_x_, ray_y_;  ///< normalised, without distortion; in blocks of 4 x 4 pixels
  std::vector<float> vignette_;
  std::vector<float> seen_;  ///< of the image being made, in blocks
  std::vector<float> noise_;
};

}  // namespace weft::agents::sim
