#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Describes the first point in which a ray meets a box.
struct BoxHit {
  std::int32_t box = -1;  ///< index into the site's boxes; -1: none
  std::int32_t face = 0;  ///< 0..3: the sides at +x, +y, -x, -y of the box's frame; 4: its top
  float distance = 0.0F;  ///< in lengths of the ray's direction
};

/// Describes the plane of one face of a box, for many rays from one eye, and the face's own coordinates in it.
struct FacePlane {
  Eigen::Vector3f normal;  ///< site frame
  float ahead = 0.0F;      ///< metres from the eye along the normal
  Eigen::Vector2d middle;  ///< of the box, on the floor
  Eigen::Vector2d along;   ///< site frame; `along_m` of a FaceJob counts this way
  bool top = false;        ///< its `up_m` lies across `along` on the floor

  /// Returns how far away a ray of this direction meets the plane, in lengths of it.
  float distance(const Eigen::Vector3f& direction) const {
    return ahead / (normal.x() * direction.x() + normal.y() * direction.y() + normal.z() * direction.z());
  }
  /// Returns along_m and up_m of a point of the plane, site frame.
  Eigen::Vector2d in_face(const Eigen::Vector3d& p) const {
    const double x = p.x() - middle.x();
    const double y = p.y() - middle.y();
    return {along.x() * x + along.y() * y, top ? along.x() * y - along.y() * x : p.z()};
  }
};

/// Holds the things that stand on the floor, for ray queries. May be used by several cameras, one thread each.
class Scene {
 public:
  explicit Scene(std::vector<Box> boxes);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  static constexpr std::size_t kPacket = 16;
  /// Casts rays from one eye (site frame), at most kPacket of them; `hits` has as many.
  void cast(const Eigen::Vector3d& eye, std::span<const Eigen::Vector3f> directions, std::span<BoxHit> hits) const;
  /// Casts rays likewise, each from an eye of its own.
  void cast(std::span<const Eigen::Vector3f> eyes, std::span<const Eigen::Vector3f> directions,
            std::span<BoxHit> hits) const;

  /// Returns the plane of a face as seen from `eye` (site frame).
  FacePlane plane_of(std::int32_t box, std::int32_t face, const Eigen::Vector3d& eye) const;

  const std::vector<Box>& boxes() const { return boxes_; }
  /// Returns a floor point (site frame) in a box's own frame.
  Eigen::Vector2d in_box(std::int32_t box, double x, double y) const {
    const Turn& turn = turns_[static_cast<std::size_t>(box)];
    return {turn.cosine * (x - turn.x) + turn.sine * (y - turn.y),
            turn.cosine * (y - turn.y) - turn.sine * (x - turn.x)};
  }
  /// Returns the boxes that come within `reach_m` of a floor point.
  std::vector<std::int32_t> boxes_near(double x, double y, double reach_m) const;
  /// Returns whether the line of sight from (eye_x, eye_y) to (x, y) passes over the box's footprint.
  bool crosses(std::int32_t box, double eye_x, double eye_y, double x, double y) const;

 private:
  struct Embree;
  struct Turn {
    double x, y, cosine, sine;
  };
  std::vector<Box> boxes_;
  std::vector<Turn> turns_;  ///< of each box; asked for at every pixel that shows one
  std::unique_ptr<Embree> embree_;
};

}  // namespace weft::agents::sim
