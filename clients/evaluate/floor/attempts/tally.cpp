#include "clients/evaluate/floor/attempts/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::evaluate::floor {
namespace {

std::size_t bin_of(double value, double width) {
  return std::min(static_cast<std::size_t>(value / width), Recall::kBins - 1);
}

template <std::size_t N>
void add_to(std::array<std::size_t, N>& sum, const std::array<std::size_t, N>& more) {
  for (std::size_t i = 0; i < N; ++i) sum[i] += more[i];
}

}  // namespace

bool is_right(const Pose2& place_from_robot, const Pose2& truth) {
  const Pose2 off = truth.inverse() * place_from_robot;
  return off.translation().norm() <= kWrongM && std::abs(wrap_angle(off.heading)) <= kWrongRad;
}

std::size_t Outcomes::all_refused() const {
  std::size_t sum = 0;
  for (const auto& [reason, count] : refused) sum += count;
  return sum;
}

void Outcomes::add(const Outcomes& other) {
  right += other.right;
  wrong += other.wrong;
  for (const auto& [reason, count] : other.refused) refused[reason] += count;
}

void Recall::add(const Recall& other) {
  add_to(tried_by_metres, other.tried_by_metres);
  add_to(right_by_metres, other.right_by_metres);
  add_to(tried_by_heading, other.tried_by_heading);
  add_to(right_by_heading, other.right_by_heading);
}

void Tally::count(const std::string& sort, const agents::OrRefusal<Pose2>& place_from_robot,
                  const std::optional<Pose2>& truth, const Pose2& site_from_place) {
  Outcomes& outcomes = sorts[sort];
  if (!place_from_robot) {
    ++outcomes.refused[std::string(place_from_robot.error().reason)];
  } else if (truth && is_right(*place_from_robot, *truth)) {
    ++outcomes.right;
  } else {
    ++outcomes.wrong;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Pose2 off = truth ? truth->inverse() * *place_from_robot : Pose2{};
    wrong_ones.push_back({sort, truth ? off.translation().norm() : nan, truth ? off.heading : nan,
                          site_from_place * truth.value_or(Pose2{}), site_from_place, *place_from_robot});
  }
}

void Tally::recall(const std::string& sort, const Apart& apart, bool is_right) {
  Recall& recall = recalls[sort];
  const std::size_t metres = bin_of(apart.metres, Recall::kBinM);
  const std::size_t heading = bin_of(apart.radians, Recall::kBinRad);
  ++recall.tried_by_metres[metres];
  ++recall.tried_by_heading[heading];
  recall.right_by_metres[metres] += is_right ? 1 : 0;
  recall.right_by_heading[heading] += is_right ? 1 : 0;
}

void Tally::add(const Tally& other) {
  for (const auto& [sort, outcomes] : other.sorts) sorts[sort].add(outcomes);
  for (const auto& [sort, recall] : other.recalls) recalls[sort].add(recall);
  wrong_ones.insert(wrong_ones.end(), other.wrong_ones.begin(), other.wrong_ones.end());
}

std::size_t Tally::attempts() const {
  std::size_t sum = 0;
  for (const auto& [sort, outcomes] : sorts) sum += outcomes.attempts();
  return sum;
}

std::size_t Tally::wrong() const {
  std::size_t sum = 0;
  for (const auto& [sort, outcomes] : sorts) sum += outcomes.wrong;
  return sum;
}

}  // namespace weft::evaluate::floor
