#include "clients/evaluate/generate/site_generator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"

namespace weft {
namespace {

constexpr double kAisle_m = 40.0;
constexpr double kBetweenAisles_m = 4.0;
constexpr double kBin_m = 0.5;
constexpr double kMeanSpacing_m = 0.25;
constexpr double kStitchChance = 0.6;  // the first runs along a corridor find nothing to stitch to
constexpr double kOtherWayChance = 0.1;
constexpr int kBinsAnAisle = static_cast<int>(kAisle_m / kBin_m);
constexpr std::uint64_t kMostPlaces = 10'000'000;
constexpr const char* kMethod = "floor";

Pose2 noise(Random& random, double position_m, double heading_rad) {
  return {random.normal(0.0, position_m), random.normal(0.0, position_m), random.normal(0.0, heading_rad)};
}

Relation measured(const Pose2& a_from_b, Random& random, double position_m, double heading_rad) {
  Metric2 relation{a_from_b * noise(random, position_m, heading_rad), Eigen::Matrix3d::Zero()};
  relation.covariance.diagonal() << position_m * position_m, position_m * position_m, heading_rad * heading_rad;
  return relation;
}

Result<void> within(const char* what, std::uint64_t value, std::uint64_t low, std::uint64_t high) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::invalid, std::string("site: ") + what + " is " + std::to_string(value) + ", must be in [" +
                                      std::to_string(low) + ", " + std::to_string(high) + "]");
}

}  // namespace

Result<void> check(const SitePlan& plan) {
  if (auto good = within("places", plan.places, 1, kMostPlaces); !good) return good;
  if (auto good = within("content bytes", plan.content_bytes, 8, 1'000'000); !good) return good;
  if (auto good = within("places of a batch", plan.batch_places, 1, kBatchPlaces); !good) return good;
  return within("runs a corridor", plan.runs_a_corridor, 1, 1000);
}

SiteGenerator::SiteGenerator(const SitePlan& plan) : plan_(plan), random_(plan.seed) {
  const double corridors_m = static_cast<double>(plan.places) * kMeanSpacing_m / plan.runs_a_corridor;
  const double meshes = std::max(1.0, corridors_m / (kAisle_m + kBetweenAisles_m));
  // About square.
  rows_ = std::max(1, static_cast<int>(std::lround(std::sqrt(meshes * kBetweenAisles_m / kAisle_m))));
  columns_ = std::max(1, static_cast<int>(std::lround(meshes / rows_)));
  const auto crossings = static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1);
  seen_.resize(crossings * 4 * kBinsAnAisle);
}

Batch SiteGenerator::next() {
  if (length_ == 0) begin_experience();
  poses_.clear();
  Batch batch;
  batch.experience = experience_;
  batch.sequence = ++sequence_;
  batch.robot = robot_;
  batch.name = "site-" + std::to_string(plan_.seed);
  batch.method = kMethod;
  while (batch.places.size() < plan_.batch_places && index_ < length_ && made_ < plan_.places) add_place(batch);
  if (index_ == length_ || is_done()) {
    batch.seal = true;
    batch.seal_reason = "end of the run";
    length_ = 0;
  }
  return batch;
}

Bytes SiteGenerator::content(const PlaceId& place) const {
  Random random(plan_.seed ^ (place.experience.value + 0x9e3779b97f4a7c15ULL * (place.index + 1ULL)));
  Bytes bytes(plan_.content_bytes);
  for (std::size_t at = 0; at < bytes.size(); at += 16) {
    std::uint64_t number = random.next();  // four bits a byte are random
    for (std::size_t i = at; i < std::min(at + 16, bytes.size()); ++i, number >>= 4U) {
      bytes[i] = static_cast<std::uint8_t>(number & 15U);
    }
  }
  return bytes;
}

void SiteGenerator::begin_experience() {
  experience_ = {random_.next() | 1U};
  for (std::uint8_t& byte : robot_.bytes) byte = static_cast<std::uint8_t>(random_.next());
  robot_.bytes[0] |= 1U;
  sequence_ = 0;
  index_ = 0;
  length_ = 200 + static_cast<std::uint32_t>(random_.below(2801));
  spacing_m_ = random_.uniform(0.2, 0.3);
  aside_m_ = random_.normal(0.5, 0.1);
  from_ = {static_cast<int>(random_.below(static_cast<std::uint64_t>(columns_) + 1)),
           static_cast<int>(random_.below(static_cast<std::uint64_t>(rows_) + 1))};
  to_ = from_;
  choose_turn();
  along_m_ = 0.0;
}

/// Draws a way on from the crossing, any but back; straight on half of the time.
void SiteGenerator::choose_turn() {
  const Crossing before = from_;
  const Crossing here = to_;
  std::vector<Crossing> ways;
  for (const auto& [right, up] : std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
    const Crossing there{here.column + right, here.row + up};
    if (there.column < 0 || there.column > columns_ || there.row < 0 || there.row > rows_) continue;
    if (there == before) continue;
    ways.push_back(there);
  }
  const Crossing straight{2 * here.column - before.column, 2 * here.row - before.row};
  from_ = here;
  to_ = ways[random_.below(ways.size())];
  if (std::find(ways.begin(), ways.end(), straight) != ways.end() && random_.chance(0.5)) to_ = straight;
}

void SiteGenerator::advance() {
  along_m_ += spacing_m_;
  const double length_m = from_.column != to_.column ? kBetweenAisles_m : kAisle_m;
  if (along_m_ < length_m) return;
  along_m_ -= length_m;
  choose_turn();
}

Pose2 SiteGenerator::site_from_robot() const {
  const Pose2 site_from_corridor{
      from_.column * kBetweenAisles_m, from_.row * kAisle_m,
      std::atan2(static_cast<double>(to_.row - from_.row), static_cast<double>(to_.column - from_.column))};
  return site_from_corridor * Pose2{along_m_, -aside_m_, 0.0};
}

/// Returns the bin of a corridor as counted from its crossing; one who comes the other way begins at the other end.
std::size_t SiteGenerator::bin(int along_bin, int direction) const {
  const bool is_back = direction != 0;
  const Crossing& begin = is_back ? to_ : from_;
  const Crossing& end = is_back ? from_ : to_;
  const int way = end.column > begin.column ? 0 : end.column < begin.column ? 1 : end.row > begin.row ? 2 : 3;
  const int bins = end.column != begin.column ? static_cast<int>(kBetweenAisles_m / kBin_m) : kBinsAnAisle;
  const int at = std::clamp(is_back ? bins - 1 - along_bin : along_bin, 0, bins - 1);
  const int crossing = begin.row * (columns_ + 1) + begin.column;
  return static_cast<std::size_t>((crossing * 4 + way) * kBinsAnAisle + at);
}

void SiteGenerator::add_place(Batch& batch) {
  const Pose2 site_from_here = site_from_robot();
  Place place;
  place.id = {experience_, index_};
  place.method = kMethod;
  place.content = {hash_bytes(content(place.id)), plan_.content_bytes};
  place.robot = robot_;
  place.frame = 8ULL * index_;
  place.seen_at = SensorTime(from_seconds(0.25 * index_));
  batch.places.push_back(place);
  if (index_ > 0) {
    Edge edge;
    edge.id = {{experience_, index_ - 1}, place.id};
    edge.a_from_b = measured(last_.inverse() * site_from_here, random_, 0.001, 0.0005);
    edge.method = kMethod;
    batch.edges.push_back(edge);
  }
  if (random_.chance(kStitchChance)) add_stitch(batch, place.id);
  const int along_bin = static_cast<int>(along_m_ / kBin_m);
  seen_[bin(along_bin, 0)].push_back({place.id, site_from_here});
  if (along_m_ < spacing_m_) {
    labels_.try_emplace("station-" + std::to_string(from_.row) + "-" + std::to_string(from_.column), place.id);
  }
  poses_.push_back(site_from_here);
  last_ = site_from_here;
  ++index_;
  ++made_;
  advance();
}

void SiteGenerator::add_stitch(Batch& batch, const PlaceId& place) {
  const bool is_other_way = random_.chance(kOtherWayChance);
  const std::vector<Seen>& beside = seen_[bin(static_cast<int>(along_m_ / kBin_m), is_other_way ? 1 : 0)];
  if (beside.empty()) return;
  const Seen& older = beside[random_.below(beside.size())];
  // One's own place must be one of an earlier time.
  if (older.place.experience == experience_ && older.place.index + 20 > place.index) return;
  Edge edge;
  edge.id = {older.place, place};
  edge.a_from_b = measured(older.site_from_place.inverse() * site_from_robot(), random_, 0.004, 0.003);
  edge.origin = Origin::stitch;
  edge.method = kMethod;
  edge.drivable = is_other_way ? Drivable::none : Drivable::both;
  edge.inliers = static_cast<std::uint32_t>(20 + random_.below(100));
  edge.overlap = static_cast<float>(random_.uniform(0.2, 0.9));
  batch.edges.push_back(edge);
}

}  // namespace weft
