#pragma once
#include <initializer_list>
#include <opencv2/core.hpp>

#include "core/random.hpp"

namespace weft::agents::sim {

/// Paints in grey on a surface whose places are in metres from its first corner.
class CeilingCanvas {
 public:
  CeilingCanvas(double width_m, double depth_m, double texel_m);

  /// Describes clouds of a size, metres, and strength, grey levels.
  struct Cloud {
    double size_m, grey;
  };
  /// Fills all with clouds about a mean of 128.
  void fill(std::initializer_list<Cloud> clouds, Random random);
  /// Makes all that is there lighter or darker by `grey` within a rectangle.
  void shade(double x, double y, double width_m, double depth_m, double grey);
  void rectangle(double x, double y, double width_m, double depth_m, double grey);
  void disc(double x, double y, double radius_m, double grey);
  void line(double x0, double y0, double x1, double y1, double width_m, double grey);
  /// Darkens a spot with an uneven, soft rim; at its rim most, as dried water does.
  void stain(double x, double y, double radius_m, double grey, Random random);

  double width_m() const { return width_m_; }
  double depth_m() const { return depth_m_; }
  double area_m2() const { return width_m_ * depth_m_; }
  /// Returns the picture, 8 bit, brought to a mean of 128.
  cv::Mat done() const;

 private:
  int texels(double metres) const;

  double width_m_, depth_m_, texel_m_;
  cv::Mat grey_;  ///< 8 bit
};

}  // namespace weft::agents::sim
