#include "tests/simulation/stored_map.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "agents/navigation/config.hpp"
#include "core/network/codec.hpp"
#include "tests/support/marks.hpp"

namespace weft::simulation {
namespace {

constexpr double kRun_m = 250.0;
constexpr double kOverlap_m = 1.5;  // a run goes on past where the next one begins
constexpr double kSpacing_m = 0.35;
constexpr double kSpacing_rad = 0.17;
constexpr double kStep_m = 0.05;
constexpr std::uint32_t kPlacesOfBatch = 100;
constexpr double kSigma_m = 0.003;
constexpr double kSigma_rad = 0.004;
constexpr agents::StitchConfig kStitch;

Relation relation_between(const Pose2& a, const Pose2& b) {
  Metric2 relation{a.inverse() * b, Eigen::Matrix3d::Zero()};
  relation.covariance.diagonal() = Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigma_rad * kSigma_rad);
  return relation;
}

}  // namespace

StoredMap::StoredMap(const Site& site, std::size_t robots, const RobotId& teacher, Random random) {
  for (double from_m = 0.0; from_m < site.length_m(); from_m += kRun_m)
    teach_run(site, from_m, std::min(from_m + kRun_m, site.length_m()) + kOverlap_m, teacher, random);
  const Course& course = site.course();
  for (std::size_t k = 0; k < course.stations().size(); ++k)
    labels_["station-" + std::to_string(k)] = nearest(course.stations()[k].at_m);
  for (std::size_t i = 0; i < robots; ++i) labels_["start-" + std::to_string(i)] = nearest(course.start_m(i, robots));
}

void StoredMap::teach_run(const Site& site, double from_m, double to_m, const RobotId& teacher, Random& random) {
  Batch batch;
  batch.experience = ExperienceId{random.next() | 1U};
  batch.robot = teacher;
  batch.name = "lap-" + std::to_string(static_cast<int>(from_m));
  batch.method = "marks";
  const auto hand_in = [&] {
    ++batch.sequence;
    batches_.push_back(batch);
    batch.places.clear();
    batch.edges.clear();
  };
  crossed_at_m_ = from_m;
  std::optional<Spot> before;
  std::uint32_t index = 0;
  for (double at_m = from_m; at_m < to_m; at_m += kStep_m) {
    const Pose2 pose = site.pose(at_m, {});
    const bool is_due = !before || at_m - before->at_m > kSpacing_m - 0.5 * kStep_m ||
                        std::abs(wrap_angle(pose.heading - before->pose.heading)) > kSpacing_rad;
    if (!is_due) continue;
    const Spot spot{{batch.experience, index++}, pose, at_m};
    keep(site, spot, batch, before ? &*before : nullptr, random);
    before = spot;
    if (batch.places.size() == kPlacesOfBatch) hand_in();
  }
  batch.seal = true;
  batch.seal_reason = "the operator ended it";
  hand_in();
}

/// Keeps a place there: what is seen, how it lies to the one before, and to what it comes by.
void StoredMap::keep(const Site& site, const Spot& spot, Batch& batch, const Spot* before, Random& random) {
  const agents::MarksMethod method;
  agents::View view;
  view.data = read_marks(site, spot.pose, random);
  const auto seen = method.extract({}, view);
  Bytes content = seen ? method.encode(*seen) : method.encode({});
  Place place;
  place.id = spot.place;
  place.method = batch.method;
  place.content = {hash_bytes(content), content.size()};
  place.robot = batch.robot;
  place.frame = spot.place.index;
  contents_[place.content.hash] = std::move(content);
  batch.places.push_back(place);
  if (before != nullptr) {
    Edge edge;
    edge.id = {before->place, spot.place};
    edge.a_from_b = relation_between(before->pose, spot.pose);
    edge.method = batch.method;
    batch.edges.push_back(edge);
  }
  join(spot, batch);
  places_[spot.place] = spot.pose;
  cells_[{static_cast<int>(std::floor(spot.pose.x)), static_cast<int>(std::floor(spot.pose.y))}].push_back(
      spots_.size());
  spots_.push_back(spot);
}

/// Joins the place to the nearest of each of two runs that lead the same way, and now and then to one that it
/// crosses.
void StoredMap::join(const Spot& spot, Batch& batch) {
  std::set<ExperienceId> joined;
  const auto stitch = [&](const Spot& other, Drivable drivable) {
    Edge edge;
    edge.id = {other.place, spot.place};
    edge.a_from_b = relation_between(other.pose, spot.pose);
    edge.origin = Origin::stitch;
    edge.method = batch.method;
    edge.drivable = drivable;
    edge.inliers = 8;
    edge.overlap = 0.8F;
    batch.edges.push_back(edge);
  };
  for (const Spot* const other : around(spot)) {
    const bool is_alike = std::abs(wrap_angle(other->pose.heading - spot.pose.heading)) <= kStitch.drivable_rad;
    if (is_alike && joined.size() < kStitch.most_a_place && joined.insert(other->place.experience).second) {
      stitch(*other, Drivable::both);
    } else if (!is_alike && spot.at_m - crossed_at_m_ > kStitch.across_every_m) {
      stitch(*other, Drivable::none);
      crossed_at_m_ = spot.at_m;
    }
  }
}

/// Returns what lies within reach, the nearest first, but for what has just been driven.
std::vector<const StoredMap::Spot*> StoredMap::around(const Spot& spot) const {
  std::vector<const Spot*> near;
  const auto away = [&](const Spot* other) { return (other->pose.translation() - spot.pose.translation()).norm(); };
  const int x = static_cast<int>(std::floor(spot.pose.x));
  const int y = static_cast<int>(std::floor(spot.pose.y));
  for (int column = x - 1; column <= x + 1; ++column) {
    for (int row = y - 1; row <= y + 1; ++row) {
      const auto found = cells_.find({column, row});
      if (found == cells_.end()) continue;
      for (const std::size_t number : found->second) {
        const Spot& other = spots_[number];
        const bool is_just_driven =
            other.place.experience == spot.place.experience && spot.at_m - other.at_m < kStitch.own_distance_m;
        if (!is_just_driven && away(&other) <= kStitch.reach_m) near.push_back(&other);
      }
    }
  }
  std::stable_sort(near.begin(), near.end(), [&](const Spot* a, const Spot* b) { return away(a) < away(b); });
  return near;
}

PlaceId StoredMap::nearest(double at_m) const {
  const auto nearer = [&](const Spot& a, const Spot& b) { return std::abs(a.at_m - at_m) < std::abs(b.at_m - at_m); };
  return std::min_element(spots_.begin(), spots_.end(), nearer)->place;
}

bool StoredMap::write(const std::shared_ptr<storage::MemoryDisk>& disk) const {
  const std::unique_ptr<storage::MapStore> store = storage::make_memory_store(disk);
  if (!store->open()) return false;
  for (const Batch& batch : batches_) {
    storage::Transaction step;
    for (const Place& place : batch.places)
      step.changes.emplace_back(
          storage::PutContent{place.content.hash, msg::ContentKind::content, contents_.at(place.content.hash)});
    step.changes.emplace_back(storage::AppendBatch{batch, hash(batch)});
    if (!store->commit(step)) return false;
  }
  storage::Transaction step;
  for (const auto& [label, place] : labels_) step.changes.emplace_back(storage::PutLabel{label, place});
  return store->commit(step).has_value();
}

}  // namespace weft::simulation
