#pragma once
#include <cstddef>
#include <vector>

namespace weft::agents::sim {

/// Scatters light in a lens: a share of it falls in halos of three sizes about where it should, so that a lamp that
/// is far brighter than white has a glow around it.
class Bloom {
 public:
  /// Takes the image's size in blocks of 4 x 4 pixels. `share` 0: nothing scatters.
  Bloom(std::size_t columns, std::size_t rows, double share);
  /// Scatters what each pixel gets, in blocks of 4 x 4 pixels; in place.
  void scatter(std::vector<float>& light);

 private:
  void blur(std::size_t reach);
  void blur_once(std::size_t reach, std::size_t count, std::size_t lines, std::size_t step, std::size_t line_step);
  void add_halos(std::vector<float>& light) const;

  std::size_t columns_, rows_;
  float share_;
  std::vector<float> blocks_, halo_, line_;  ///< a value a block
};

}  // namespace weft::agents::sim
