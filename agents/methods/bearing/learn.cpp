// What a place keeps of what robots see that come by: features with counts of how often they were there, as Dayoub &
// Duckett 2008 rehearse and forget views, Krajnik et al. 2017 rank features by how they do in matching, and Halodova
// et al. 2019 exchange the worst of a map for those of the newest view.
#include <algorithm>
#include <cmath>

#include "agents/methods/bearing/bearing.hpp"
#include "agents/perception/looming.hpp"

namespace weft::agents {
namespace {

/// Maps features of a place to where they stand in a view and back, by what both show.
class Moved {
 public:
  Moved(const Looming& looming, double focal_px) : looming_(looming), focal_px_(focal_px) {}

  Eigen::Vector2f into_view(const Eigen::Vector2f& pixel) const {
    const auto [azimuth, elevation] = seen_from(pixel);
    const double half = 0.5 * looming_.share;
    const double turned = looming_.turned_rad + half * std::sin(2.0 * azimuth + looming_.turned_rad);
    return pixel_of(azimuth + turned, ((1.0 + half) * elevation + looming_.pitch) / (1.0 - half));
  }
  Eigen::Vector2f into_place(const Eigen::Vector2f& pixel) const {
    const auto [azimuth, elevation] = seen_from(pixel);
    const double half = 0.5 * looming_.share;
    const double turned = looming_.turned_rad + half * std::sin(2.0 * azimuth - looming_.turned_rad);
    return pixel_of(azimuth - turned, ((1.0 - half) * elevation - looming_.pitch) / (1.0 + half));
  }

 private:
  struct Direction {
    double azimuth, elevation;  // to the right, and its tangent downwards
  };
  Direction seen_from(const Eigen::Vector2f& pixel) const {
    const auto x = static_cast<double>(pixel.x());
    return {std::atan2(x, focal_px_), static_cast<double>(pixel.y()) / std::hypot(focal_px_, x)};
  }
  Eigen::Vector2f pixel_of(double azimuth, double elevation) const {
    const double x = focal_px_ * std::tan(azimuth);
    return Eigen::Vector2d(x, elevation * std::hypot(focal_px_, x)).cast<float>();
  }

  Looming looming_;
  double focal_px_;
};

double share_of(const Sightings& sightings) {
  return static_cast<double>(sightings.seen) / sightings.could;
}

Sightings with_pass(const Sightings& before, bool is_seen, int fade_passes) {
  int could = before.could + 1;
  int seen = before.seen + (is_seen ? 1 : 0);
  if (could > fade_passes) {
    could = (could + 1) / 2;
    seen = (seen + 1) / 2;
  }
  return {static_cast<std::uint8_t>(could), static_cast<std::uint8_t>(seen)};
}

/// Updates the content of a place by what one pass has shown.
class Learning {
 public:
  Learning(const BearingLearnConfig& config, const BearingContent& known, const BearingContent& seen,
           const Moved& moved)
      : config_(config), seen_(seen), moved_(moved), place_(known), is_known_(seen.features.size(), false) {
    place_.sightings = sightings_of(known);
  }

  /// Counts for each feature whether it could be seen and was. `half`: half the size, in pixels, of the part of the
  /// image in which features are found.
  void count_all(const std::vector<Match>& agreeing, const Eigen::Vector2f& half) {
    std::vector<bool> is_seen(place_.features.size(), false);
    for (const Match& match : agreeing) {
      if (!stands_at(seen_.features[match.b], moved_.into_view(place_.features[match.a].pixel))) continue;
      is_seen[match.a] = true;
      is_known_[match.b] = true;
    }
    for (std::size_t i = 0; i < is_seen.size(); ++i) {
      const Eigen::Vector2f at = moved_.into_view(place_.features[i].pixel);
      const bool could = std::abs(at.x()) <= half.x() && std::abs(at.y()) <= half.y();
      if (is_seen[i] || could) place_.sightings[i] = with_pass(place_.sightings[i], is_seen[i], config_.fade_passes);
    }
  }

  void drop_hardly_seen() {
    drop(
        [&](const Sightings& one) { return one.could >= config_.few_passes && share_of(one) < config_.hardly_ever; });
  }

  void take_newcomers() {
    std::vector<UprightFeature> newcomers;
    for (std::size_t i = 0; i < seen_.features.size(); ++i) {
      if (newcomers.size() == static_cast<std::size_t>(config_.newcomers)) break;
      if (is_known_[i] || is_there(seen_.features[i])) continue;
      newcomers.push_back({moved_.into_place(seen_.features[i].pixel), seen_.features[i].descriptor});
    }
    make_room(newcomers.size());
    for (const UprightFeature& newcomer : newcomers) {
      if (place_.features.size() >= static_cast<std::size_t>(config_.features)) break;
      place_.features.push_back(newcomer);
      place_.sightings.push_back({});
    }
  }

  BearingContent take() { return std::move(place_); }

 private:
  bool stands_at(const UprightFeature& feature, const Eigen::Vector2f& expected) const {
    const Eigen::Vector2f off = feature.pixel - expected;
    return std::abs(off.x()) <= config_.moved_px && std::abs(off.y()) <= config_.risen_px;
  }

  /// Returns whether the place has this feature, though the vote matched it with none or with another one.
  bool is_there(const UprightFeature& feature) const {
    constexpr int alike_bits = 64;
    for (const UprightFeature& one : place_.features) {
      if (stands_at(feature, moved_.into_view(one.pixel)) &&
          hamming(one.descriptor, feature.descriptor) <= alike_bits)
        return true;
    }
    return false;
  }

  template <class Goes>
  void drop(Goes&& goes) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < place_.features.size(); ++i) {
      if (goes(place_.sightings[i])) continue;
      place_.features[kept] = place_.features[i];
      place_.sightings[kept++] = place_.sightings[i];
    }
    place_.features.resize(kept);
    place_.sightings.resize(kept);
  }

  /// Drops the least seen features to make room for `wanted` more, as far as they are seldom seen.
  void make_room(std::size_t wanted) {
    const auto most = static_cast<std::size_t>(config_.features);
    if (place_.features.size() + wanted <= most) return;
    std::size_t over = std::min(place_.features.size() + wanted - most, place_.features.size());
    std::vector<double> shares;
    for (const Sightings& one : place_.sightings) shares.push_back(share_of(one));
    std::sort(shares.begin(), shares.end());
    const double least = over == 0 ? 0.0 : std::min(shares[over - 1], config_.seldom);
    drop([&](const Sightings& one) {
      if (over == 0 || share_of(one) > least || share_of(one) >= config_.seldom) return false;
      --over;
      return true;
    });
  }

  const BearingLearnConfig& config_;
  const BearingContent& seen_;
  const Moved& moved_;
  BearingContent place_;
  std::vector<bool> is_known_;  // of the view's features
};

}  // namespace

std::optional<Bearing::Content> Bearing::learn(const Content& known, const Content& seen,
                                               const Relation& known_from_seen) const {
  const BearingLearnConfig& learn = config_.learn;
  const auto at = std::get<AlongPath>(compose(known_from_seen, AlongPath{}));
  if (known.description != seen.description) return std::nullopt;
  if (known.focal_px != seen.focal_px || std::abs(at.distance_m) > learn.along_m) return std::nullopt;
  if (at.distance_variance_m2 > learn.along_sigma_m * learn.along_sigma_m) return std::nullopt;
  const double rise_px = frequent_rise(known.features, seen.features, config_.width_px, config_.vote);
  const auto vote = vote_heading(known.features, seen.features, config_.width_px, config_.vote, rise_px);
  if (!vote || vote->above_chance < learn.above_chance) return std::nullopt;
  const auto looming = looming_of(known.features, seen.features, vote->agreeing, known.focal_px);
  if (!looming || looming->spread_rad > learn.spread_rad) return std::nullopt;
  if (std::abs(wrap_angle(looming->turned_rad - at.heading_shift_rad)) > learn.heading_rad) return std::nullopt;

  const double scale = config_.focal_px / camera_.fx;
  const Eigen::Vector2d half = 0.5 * scale * Eigen::Vector2d(camera_.width, camera_.height);
  const double rim_px = 2.0 * config_.features.cell_widths * config_.width_px;  // what a descriptor sees
  const Moved moved(*looming, known.focal_px);
  Learning pass(learn, known, seen, moved);
  pass.count_all(vote->agreeing, (half.array() - rim_px).matrix().cast<float>());
  pass.drop_hardly_seen();
  pass.take_newcomers();
  return pass.take();
}

}  // namespace weft::agents
