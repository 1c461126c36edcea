#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/network/network.hpp"

/// Cuts stretches of places in two. Private to the routing folder.
namespace weft::routing {

/// Holds places by number, in the order of the network, with whom they are joined and roughly where they lie.
struct Layout {
  std::vector<PlaceId> places;
  std::vector<std::uint32_t> first_arc;  ///< of each place in `arcs`, and their number
  std::vector<std::uint32_t> arcs;       ///< places to which one can drive from here
  std::vector<float> x;
  std::vector<float> y;
};

/// Cuts a stretch of places in two near the middle where few arcs cross: along each of four directions the places
/// are sorted into bins, arcs counted at each border between bins, and the best border taken (after the sweep of
/// Schild & Sommer, "On balanced separators in road networks" (2015), section 3, with counts in place of flows).
/// Portion by portion, as a stretch may be the whole of a large network.
class Bisection {
 public:
  static constexpr std::uint32_t kPortion = 2048;  ///< places

  /// Takes at least two places. `part_of` holds one number for the places of this stretch and others elsewhere. All
  /// must outlive the bisection.
  Bisection(const Layout& layout, std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
            std::vector<std::uint32_t>& part_of);

  /// Does one portion; returns false when nothing was left to be done. At the end [first, last) is reordered, and the
  /// places of its second part have the number `second_part` in `part_of`.
  bool step(std::uint32_t second_part);
  /// Returns where the second part begins; both have at least one place.
  std::uint32_t middle() const { return middle_; }

 private:
  static constexpr std::size_t kBins = 512;
  enum class Phase { extent, count, divide, put_back, done };
  struct Sweep {
    std::array<float, 2> direction{};
    float low = 0.0F;
    float high = 0.0F;
    std::size_t border = 0;  ///< the first bin of the second part
    double worth = 0.0;      ///< less is better
  };

  float project(const Sweep& sweep, std::uint32_t place) const;
  std::size_t bin(const Sweep& sweep, std::uint32_t place) const;
  void begin_direction(std::size_t direction);
  void look_at_extent(std::uint32_t place);
  void count(std::uint32_t place);
  void judge();
  void divide(std::uint32_t place, std::uint32_t second_part);
  void finish_pass();

  const Layout& layout_;
  std::vector<std::uint32_t>& order_;
  std::vector<std::uint32_t>& part_of_;
  std::uint32_t first_;
  std::uint32_t last_;
  std::uint32_t at_;
  Phase phase_ = Phase::extent;
  std::size_t direction_ = 0;
  Sweep sweep_;
  std::optional<Sweep> best_;
  std::vector<std::int64_t> places_;    ///< in each bin
  std::vector<std::int64_t> crossing_;  ///< change of the number of arcs across, from border to border
  std::vector<std::uint32_t> seconds_;
  std::uint32_t middle_;
};

}  // namespace weft::routing
