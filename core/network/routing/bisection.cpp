#include "core/network/routing/bisection.hpp"

#include <algorithm>
#include <limits>

namespace weft::routing {
namespace {

constexpr double kSmallerPart = 0.3;  ///< of the places, at least
constexpr std::array<std::array<float, 2>, 4> kDirections{{{1.0F, 0.0F}, {0.0F, 1.0F}, {0.7F, 0.7F}, {0.7F, -0.7F}}};

}  // namespace

Bisection::Bisection(const Layout& layout, std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
                     std::vector<std::uint32_t>& part_of)
    : layout_(layout), order_(order), part_of_(part_of), first_(first), last_(last), at_(first), middle_(first) {
  begin_direction(0);
}

void Bisection::begin_direction(std::size_t direction) {
  direction_ = direction;
  phase_ = Phase::extent;
  sweep_.direction = kDirections.at(direction);
  sweep_.high = -std::numeric_limits<float>::infinity();
  sweep_.low = -sweep_.high;
  places_.assign(kBins + 1, 0);
  crossing_.assign(kBins + 1, 0);
}

float Bisection::project(const Sweep& sweep, std::uint32_t place) const {
  return sweep.direction[0] * layout_.x[place] + sweep.direction[1] * layout_.y[place];
}

std::size_t Bisection::bin(const Sweep& sweep, std::uint32_t place) const {
  const float scale = sweep.high > sweep.low ? static_cast<float>(kBins) * 0.9999F / (sweep.high - sweep.low) : 0.0F;
  return std::min(kBins - 1, static_cast<std::size_t>((project(sweep, place) - sweep.low) * scale));
}

void Bisection::look_at_extent(std::uint32_t place) {
  const float along = project(sweep_, place);
  sweep_.low = std::min(sweep_.low, along);
  sweep_.high = std::max(sweep_.high, along);
}

void Bisection::count(std::uint32_t place) {
  const std::size_t here = bin(sweep_, place);
  ++places_[here];
  for (std::uint32_t arc = layout_.first_arc[place]; arc < layout_.first_arc[place + 1]; ++arc) {
    const std::uint32_t other = layout_.arcs[arc];
    if (part_of_[other] != part_of_[place]) continue;
    const std::size_t there = bin(sweep_, other);
    ++crossing_[std::min(here, there) + 1];
    --crossing_[std::max(here, there) + 1];
  }
}

/// Takes the best border of this direction, if it is the best of all so far.
void Bisection::judge() {
  const auto all = static_cast<double>(last_ - first_);
  std::int64_t before = 0;
  std::int64_t cut = 0;
  for (std::size_t border = 1; border < kBins; ++border) {
    before += places_[border - 1];
    cut += crossing_[border];
    const double smaller = std::min(static_cast<double>(before), all - static_cast<double>(before)) / all;
    if (smaller < kSmallerPart) continue;
    sweep_.border = border;
    sweep_.worth = (static_cast<double>(cut) + 1.0) / smaller;
    if (!best_ || sweep_.worth < best_->worth) best_ = sweep_;
  }
}

void Bisection::divide(std::uint32_t place, std::uint32_t second_part) {
  // Heaps of places on one spot have no border that leaves enough on both sides: the order decides.
  const bool is_first = best_ ? bin(*best_, place) < best_->border : at_ < first_ + (last_ - first_) / 2;
  if (is_first) {
    order_[middle_++] = place;
  } else {
    part_of_[place] = second_part;
    seconds_.push_back(place);
  }
}

void Bisection::finish_pass() {
  at_ = first_;
  if (phase_ == Phase::extent) {
    phase_ = Phase::count;
  } else if (phase_ == Phase::count) {
    judge();
    if (direction_ + 1 < kDirections.size()) {
      begin_direction(direction_ + 1);
    } else {
      phase_ = Phase::divide;
      seconds_.reserve(last_ - first_);
    }
  } else if (phase_ == Phase::divide) {
    phase_ = Phase::put_back;
    at_ = middle_;
  } else {
    phase_ = Phase::done;
  }
}

bool Bisection::step(std::uint32_t second_part) {
  if (phase_ == Phase::done) return false;
  const std::uint32_t end = std::min(last_, at_ + kPortion);
  for (; at_ < end; ++at_) {
    switch (phase_) {
      case Phase::extent:
        look_at_extent(order_[at_]);
        break;
      case Phase::count:
        count(order_[at_]);
        break;
      case Phase::divide:
        divide(order_[at_], second_part);
        break;
      case Phase::put_back:
        order_[at_] = seconds_[at_ - middle_];
        break;
      case Phase::done:
        break;
    }
  }
  if (at_ == last_) finish_pass();
  return true;
}

}  // namespace weft::routing
