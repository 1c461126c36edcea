#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace weft::agents::sim {

/// Names the material of a surface; each has textures of its own.
enum class Stuff : std::uint8_t {
  floor,
  wall,
  ceiling,
  steel,
  load,
  pallet,
  sign,
  vehicle,
  clothing,
  lamp,
  duct,     ///< galvanised or painted sheet metal
  mural,    ///< what a whole ceiling shows, by its place (hall/mural.hpp)
  skylight  ///< shines; its grey is 128 times its brightness
};
inline constexpr std::size_t kStuffs = 13;

/// Describes a parallelogram of the hall, site frame, metres. It is seen from both sides and lit on the one that
/// `across` x `up` points to.
struct Quad {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  Eigen::Vector3f across = Eigen::Vector3f::UnitX();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  Stuff stuff = Stuff::wall;
  std::uint32_t pattern = 0;  ///< which of the stuff's textures, and where in it
  float grey = 128.0F;        ///< mean grey level under light 1
  float contrast = 1.0F;      ///< factor on the texture about its mean

  Eigen::Vector3f at(float u, float v) const { return corner + u * across + v * up; }
  Eigen::Vector3f normal() const { return across.cross(up).normalized(); }
};

/// Describes an upright box on a heading: its four sides and its top (no bottom: nobody looks from under the floor).
/// Sides come in the order of BoxHit's faces.
struct BoxSides {
  Eigen::Vector3d middle_of_bottom = Eigen::Vector3d::Zero();
  double heading_rad = 0.0;
  double length_m = 1.0, width_m = 1.0, height_m = 1.0;  ///< length along the heading
};
void add_box(const BoxSides& box, const Quad& look, std::vector<Quad>& quads);
/// Adds a box that may be looked at from below: its bottom, too.
void add_closed_box(const BoxSides& box, const Quad& look, std::vector<Quad>& quads);

}  // namespace weft::agents::sim
