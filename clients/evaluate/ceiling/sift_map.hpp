#pragma once
#include <memory>
#include <optional>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/view.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::evaluate::ceiling {

/// Finds an image in a mosaic by SIFT features, as Lucas et al. began to do it (V, end): the baseline of finding
/// oneself. The mosaic is a list of features on the ceiling; images and robots are laid by their mounts.
class SiftMap {
 public:
  explicit SiftMap(double ceiling_m);
  ~SiftMap();
  SiftMap(SiftMap&&) noexcept;
  SiftMap& operator=(SiftMap&&) noexcept;

  /// Adds an image that was taken there.
  void add(const agents::CameraModel& camera, const agents::Image& image, const Pose2& map_from_robot);

  /// Returns map_from_robot that most features agree with: nearest neighbours with the ratio of Lowe 2004, then a
  /// rigid motion by random sampling. None: fewer than twelve agree.
  std::optional<Pose2> find(const agents::CameraModel& camera, const agents::Image& image) const;

 private:
  struct Features;
  double ceiling_m_;
  std::unique_ptr<Features> features_;
};

}  // namespace weft::evaluate::ceiling
