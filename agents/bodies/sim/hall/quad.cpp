#include "agents/bodies/sim/hall/quad.hpp"

#include <cmath>

namespace weft::agents::sim {

void add_box(const BoxSides& box, const Quad& look, std::vector<Quad>& quads) {
  const Eigen::Vector3d ahead(std::cos(box.heading_rad), std::sin(box.heading_rad), 0.0);
  const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0.0);
  const Eigen::Vector3d l = box.length_m * ahead;
  const Eigen::Vector3d w = box.width_m * left;
  const Eigen::Vector3d h(0.0, 0.0, box.height_m);
  const Eigen::Vector3d& c = box.middle_of_bottom;
  const auto add = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& across, const Eigen::Vector3d& up) {
    Quad quad = look;
    quad.corner = corner.cast<float>();
    quad.across = across.cast<float>();
    quad.up = up.cast<float>();
    quad.pattern += static_cast<std::uint32_t>(quads.size());
    quads.push_back(quad);
  };
  add(c + 0.5 * l - 0.5 * w, w, h);
  add(c + 0.5 * l + 0.5 * w, -l, h);
  add(c - 0.5 * l + 0.5 * w, -w, h);
  add(c - 0.5 * l - 0.5 * w, l, h);
  add(c - 0.5 * l - 0.5 * w + h, l, w);
}

void add_closed_box(const BoxSides& box, const Quad& look, std::vector<Quad>& quads) {
  add_box(box, look, quads);
  const Eigen::Vector3d ahead(std::cos(box.heading_rad), std::sin(box.heading_rad), 0.0);
  const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0.0);
  Quad bottom = look;
  bottom.corner = (box.middle_of_bottom - 0.5 * box.length_m * ahead + 0.5 * box.width_m * left).cast<float>();
  bottom.across = (box.length_m * ahead).cast<float>();
  bottom.up = (-box.width_m * left).cast<float>();
  bottom.pattern += static_cast<std::uint32_t>(quads.size());
  quads.push_back(bottom);
}

}  // namespace weft::agents::sim
