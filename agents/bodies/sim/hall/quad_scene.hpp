#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"

namespace weft::agents::sim {

inline constexpr std::size_t kRays = 16;

/// Holds directions of rays from one eye, and what they meet first.
struct RayPacket {
  std::array<float, kRays> x{}, y{}, z{};  ///< directions, site frame, of any length
  std::array<std::int32_t, kRays> quad{};  ///< -1: none
  std::array<float, kRays> u{}, v{};       ///< along `across` and `up` of it, [0, 1]
  std::array<float, kRays> distance{};     ///< in lengths of the direction
};

/// Holds parallelograms for ray queries (Embree).
class QuadScene {
 public:
  explicit QuadScene(std::span<const Quad> quads);
  ~QuadScene();
  QuadScene(QuadScene&&) noexcept;
  QuadScene& operator=(QuadScene&&) noexcept;

  void cast(const Eigen::Vector3f& eye, RayPacket& packet) const;
  /// Returns how far away the first thing is that a ray along `way` meets, metres; infinite: it meets none.
  float distance_m(const Eigen::Vector3f& eye, const Eigen::Vector3f& way) const;
  /// Returns whether anything is between the two points, 1 mm from either end left out.
  bool is_hidden(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace weft::agents::sim
