#include "core/network/routing/bisection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace weft::routing {
namespace {

constexpr std::size_t kBins = 512;
constexpr double kSmallerPart = 0.3;  ///< of the places, at least
constexpr std::array<std::array<float, 2>, 4> kDirections{{{1.0F, 0.0F}, {0.0F, 1.0F}, {0.7F, 0.7F}, {0.7F, -0.7F}}};

/// The places of one stretch in bins along one direction.
class Sweep {
 public:
  Sweep(const Layout& layout, const std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
        const std::array<float, 2>& direction)
      : layout_(layout), direction_(direction) {
    float high = -std::numeric_limits<float>::infinity();
    low_ = -high;
    for (std::uint32_t at = first; at < last; ++at) {
      const float along = project(order[at]);
      low_ = std::min(low_, along);
      high = std::max(high, along);
    }
    scale_ = high > low_ ? static_cast<float>(kBins) * 0.9999F / (high - low_) : 0.0F;
  }

  std::size_t bin(std::uint32_t place) const {
    return std::min(kBins - 1, static_cast<std::size_t>((project(place) - low_) * scale_));
  }

  struct Border {
    std::size_t bin = 0;  ///< the first one of the second part
    double worth = 0.0;   ///< less is better
  };
  std::optional<Border> best(const std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
                             const std::vector<std::uint32_t>& part_of) const {
    std::array<std::int64_t, kBins + 1> places{};
    std::array<std::int64_t, kBins + 1> crossing{};
    for (std::uint32_t at = first; at < last; ++at) {
      const std::uint32_t here = order[at];
      const std::size_t bin_here = bin(here);
      ++places[bin_here];
      for (std::uint32_t arc = layout_.first_arc[here]; arc < layout_.first_arc[here + 1]; ++arc) {
        const std::uint32_t there = layout_.arcs[arc];
        if (part_of[there] != part_of[here]) continue;
        const std::size_t bin_there = bin(there);
        ++crossing[std::min(bin_here, bin_there) + 1];
        --crossing[std::max(bin_here, bin_there) + 1];
      }
    }
    const auto all = static_cast<double>(last - first);
    std::optional<Border> found;
    std::int64_t before = 0;
    std::int64_t cut = 0;
    for (std::size_t border = 1; border < kBins; ++border) {
      before += places[border - 1];
      cut += crossing[border];
      const double smaller = std::min(static_cast<double>(before), all - static_cast<double>(before)) / all;
      if (smaller < kSmallerPart) continue;
      const double worth = (static_cast<double>(cut) + 1.0) / smaller;
      if (!found || worth < found->worth) found = Border{border, worth};
    }
    return found;
  }

 private:
  float project(std::uint32_t place) const {
    return direction_[0] * layout_.x[place] + direction_[1] * layout_.y[place];
  }

  const Layout& layout_;
  std::array<float, 2> direction_;
  float low_ = 0.0F;
  float scale_ = 0.0F;
};

}  // namespace

std::uint32_t bisect(const Layout& layout, std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
                     const std::vector<std::uint32_t>& part_of) {
  std::optional<Sweep::Border> best;
  std::optional<Sweep> best_sweep;
  for (const auto& direction : kDirections) {
    const Sweep sweep(layout, order, first, last, direction);
    const auto border = sweep.best(order, first, last, part_of);
    if (!border || (best && best->worth <= border->worth)) continue;
    best = border;
    best_sweep.emplace(sweep);
  }
  // Heaps of places on one spot have no border that leaves enough on both sides: the order decides.
  if (!best) return first + (last - first) / 2;
  const auto begin = order.begin();
  const auto second = std::stable_partition(begin + first, begin + last,
                                            [&](std::uint32_t place) { return best_sweep->bin(place) < best->bin; });
  return static_cast<std::uint32_t>(second - begin);
}

}  // namespace weft::routing
