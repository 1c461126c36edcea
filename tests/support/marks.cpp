#include "tests/support/marks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace weft::agents {

namespace {

/// Describes one mark as seen from both views.
struct Common {
  Pose2 a_from_mark;
  Pose2 b_from_mark;
  Pose2 a_from_b;
};

std::vector<Common> common_marks(const std::vector<Marks::Sighting>& a, const std::vector<Marks::Sighting>& b) {
  std::vector<Common> common;
  auto at = b.begin();
  for (const Marks::Sighting& seen : a) {
    while (at != b.end() && at->mark < seen.mark) ++at;
    if (at == b.end()) break;
    if (at->mark != seen.mark) continue;
    common.push_back(
        {seen.robot_from_mark, at->robot_from_mark, seen.robot_from_mark * at->robot_from_mark.inverse()});
  }
  return common;
}

/// Returns whether mark `common` stands where `a_from_b` says.
bool agrees(const MarksConfig& config, const Common& common, const Pose2& a_from_b) {
  const Pose2 predicted = a_from_b * common.b_from_mark;
  return (predicted.translation() - common.a_from_mark.translation()).norm() <= config.agree_m &&
         std::abs(wrap_angle(predicted.heading - common.a_from_mark.heading)) <= config.agree_rad;
}

/// Fits a_from_b by least squares over positions and headings of the marks (Procrustes in the plane, closed form).
Metric2 fit(const MarksConfig& config, const std::vector<Common>& inliers) {
  Eigen::Vector2d mean_a = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_b = Eigen::Vector2d::Zero();
  for (const Common& one : inliers) {
    mean_a += one.a_from_mark.translation();
    mean_b += one.b_from_mark.translation();
  }
  const auto count = static_cast<double>(inliers.size());
  mean_a /= count;
  mean_b /= count;
  const double ratio = config.position_sigma_m / config.heading_sigma_rad;
  const double weight = ratio * ratio;
  double sine = 0.0;
  double cosine = 0.0;
  double spread = weight * count;
  for (const Common& one : inliers) {
    const Eigen::Vector2d a = one.a_from_mark.translation() - mean_a;
    const Eigen::Vector2d b = one.b_from_mark.translation() - mean_b;
    const double turned = one.a_from_mark.heading - one.b_from_mark.heading;
    cosine += a.dot(b) + weight * std::cos(turned);
    sine += b.x() * a.y() - b.y() * a.x() + weight * std::sin(turned);
    spread += b.squaredNorm();
  }
  Metric2 result;
  result.a_from_b.heading = std::atan2(sine, cosine);
  const Eigen::Vector2d moved = mean_a - Pose2{0.0, 0.0, result.a_from_b.heading} * mean_b;
  result.a_from_b.x = moved.x();
  result.a_from_b.y = moved.y();
  const double sigma2 = 2.0 * config.position_sigma_m * config.position_sigma_m;
  const double heading_variance = sigma2 / spread;
  const double variance = sigma2 / count + heading_variance * mean_b.squaredNorm();
  result.covariance.diagonal() << variance, variance, heading_variance;
  return result;
}

double spread_of(const MarksConfig& config, const std::vector<Common>& inliers, const Pose2& a_from_b) {
  double sum = 0.0;
  for (const Common& one : inliers) {
    sum += (a_from_b * one.b_from_mark.translation() - one.a_from_mark.translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(inliers.size())) / config.position_sigma_m;
}

void put(Bytes& bytes, std::uint64_t value) {
  for (unsigned shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint64_t take(ByteView& bytes) {
  std::uint64_t value = 0;
  for (unsigned i = 0; i < 8; ++i) value |= std::uint64_t{bytes[i]} << (8U * i);
  bytes = bytes.subspan(8);
  return value;
}

constexpr std::size_t bytes_a_sighting = 32;
constexpr std::size_t most_sightings = 10'000;

Bytes encoded(const std::vector<Marks::Sighting>& sightings) {
  Bytes bytes;
  bytes.reserve(8 + sightings.size() * bytes_a_sighting);
  put(bytes, sightings.size());
  for (const Marks::Sighting& seen : sightings) {
    put(bytes, seen.mark);
    put(bytes, std::bit_cast<std::uint64_t>(seen.robot_from_mark.x));
    put(bytes, std::bit_cast<std::uint64_t>(seen.robot_from_mark.y));
    put(bytes, std::bit_cast<std::uint64_t>(seen.robot_from_mark.heading));
  }
  return bytes;
}

Marks::Sighting take_sighting(ByteView& bytes) {
  Marks::Sighting seen;
  seen.mark = take(bytes);
  seen.robot_from_mark.x = std::bit_cast<double>(take(bytes));
  seen.robot_from_mark.y = std::bit_cast<double>(take(bytes));
  seen.robot_from_mark.heading = std::bit_cast<double>(take(bytes));
  return seen;
}

}  // namespace

Marks::operator Payload() const {
  return {std::make_shared<const Bytes>(encoded(sightings))};
}

std::optional<Marks> marks_of(const View& view) {
  const Payload* const payload = std::get_if<Payload>(&view.data);
  if (payload == nullptr || payload->bytes == nullptr) return std::nullopt;
  ByteView bytes(*payload->bytes);
  Marks marks;
  for (std::uint64_t left = take(bytes); left > 0; --left) marks.sightings.push_back(take_sighting(bytes));
  return marks;
}

std::vector<Error> check(const MarksConfig& config) {
  std::vector<Error> issues;
  const auto within = [&](const char* field, double value, double low, double high) {
    if (value > low && value <= high) return;
    issues.push_back({ErrorCode::invalid, std::string("marks: ") + field + " is " + std::to_string(value) +
                                              "; it must be in (" + std::to_string(low) + ", " +
                                              std::to_string(high) + "]"});
  };
  within("position_sigma_m", config.position_sigma_m, 0, 0.2);
  within("heading_sigma_rad", config.heading_sigma_rad, 0, 0.5);
  within("agree_m", config.agree_m, 0, 1);
  within("agree_rad", config.agree_rad, 0, 1);
  within("least_share", config.least_share, 0.499, 1);
  within("most_distance_m", config.most_distance_m, 0, 20);
  return issues;
}

OrRefusal<Related> MarksMethod::relate(const Content& a, const Content& b,
                                       const std::optional<Relation>& guess) const {
  const std::vector<Common> common = common_marks(a.sightings, b.sightings);
  const std::size_t least = guess ? 1 : 2;
  if (common.size() < least) {
    return tl::unexpected(Refusal{"few_marks", static_cast<double>(common.size()), static_cast<double>(least)});
  }
  std::vector<Common> inliers;
  for (const Common& hypothesis : common) {
    std::vector<Common> supporting;
    for (const Common& one : common) {
      if (agrees(config_, one, hypothesis.a_from_b)) supporting.push_back(one);
    }
    if (supporting.size() > inliers.size()) inliers = std::move(supporting);
    if (inliers.size() == common.size()) break;
  }
  const double share = static_cast<double>(inliers.size()) / static_cast<double>(common.size());
  if (share < config_.least_share || inliers.size() < least) {
    return tl::unexpected(Refusal{"inconsistent_marks", share, config_.least_share});
  }
  const Metric2 fitted = fit(config_, inliers);
  const double apart = fitted.a_from_b.translation().norm();
  if (apart > config_.most_distance_m) {
    return tl::unexpected(Refusal{"too_far_apart", apart, config_.most_distance_m});
  }
  Related related;
  related.a_from_b = fitted;
  related.inliers = static_cast<std::uint32_t>(inliers.size());
  related.overlap = static_cast<double>(inliers.size()) / static_cast<double>(b.sightings.size());
  related.residual = spread_of(config_, inliers, fitted.a_from_b);
  return related;
}

Step MarksMethod::observe(Odometry& odometry, const View* view, const Motion& motion) const {
  const auto blind = [&](std::string_view reason) {
    Step step = dead_reckon(config_.blind, motion, reason);
    odometry.last_from_now = std::get<Metric2>(compose(odometry.last_from_now, step.previous_from_current));
    return step;
  };
  if (view == nullptr) return blind("no_view");
  OrRefusal<Content> seen = extract(odometry, *view);
  if (!seen) return blind(seen.error().reason);
  const Relation previous_from_last = inverse(Relation{odometry.last_from_now});
  Step step = blind({});
  const OrRefusal<Related> related = relate(odometry.last, *seen, Relation{odometry.last_from_now});
  if (!related) {
    step.blind_reason = related.error().reason;
  } else if (!agrees(config_.gate, motion, planar(odometry.last_from_now), planar(related->a_from_b))) {
    // One of the two views is of somewhere else. Which one shows at the next.
    step.blind_reason = motion.wheels ? "disagrees_with_wheels" : "disagrees_with_command";
  } else {
    step.previous_from_current =
        Metric2{planar(compose(previous_from_last, related->a_from_b)), planar_covariance(related->a_from_b)};
    step.seen = true;
  }
  odometry.last = std::move(*seen);
  odometry.last_from_now = Metric2{};
  return step;
}

OrRefusal<MarksMethod::Content> MarksMethod::extract(const Odometry&, const View& view) const {
  const std::optional<Marks> marks = marks_of(view);
  if (!marks) return tl::unexpected(Refusal{"not_marks"});
  if (marks->sightings.empty()) return tl::unexpected(Refusal{"no_marks", 0.0, 1.0});
  Content content{marks->sightings};
  const auto by_mark = [](const Sighting& a, const Sighting& b) { return a.mark < b.mark; };
  const auto same_mark = [](const Sighting& a, const Sighting& b) { return a.mark == b.mark; };
  std::stable_sort(content.sightings.begin(), content.sightings.end(), by_mark);
  content.sightings.erase(std::unique(content.sightings.begin(), content.sightings.end(), same_mark),
                          content.sightings.end());
  return content;
}

Bytes MarksMethod::encode(const Content& content) const {
  return encoded(content.sightings);
}

Result<MarksMethod::Content> MarksMethod::decode(ByteView bytes) const {
  if (bytes.size() < 8) return fail(ErrorCode::corrupt, "marks content: shorter than its count of 8 bytes");
  const std::uint64_t count = take(bytes);
  if (count > most_sightings || bytes.size() != count * bytes_a_sighting) {
    return fail(ErrorCode::corrupt, "marks content: " + std::to_string(count) + " sightings do not fit " +
                                        std::to_string(bytes.size()) + " bytes; 32 a sighting, at most 10000");
  }
  Content content;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Sighting seen = take_sighting(bytes);
    const bool in_order = content.sightings.empty() || content.sightings.back().mark < seen.mark;
    if (!in_order || !is_finite(seen.robot_from_mark)) {
      return fail(ErrorCode::corrupt, "marks content: sighting " + std::to_string(i) +
                                          (in_order ? " is not finite" : " is out of order"));
    }
    content.sightings.push_back(seen);
  }
  return content;
}

std::optional<Signature> MarksMethod::sign(const Content& content) const {
  constexpr std::uint64_t bins = 32;
  if (content.sightings.empty()) return std::nullopt;
  Signature signature(bins, 0.0F);
  for (const Sighting& seen : content.sightings) {
    signature[(seen.mark * 0x9e3779b97f4a7c15ULL) >> 59U] += 1.0F;  // Fibonacci hashing to 32 bins
  }
  float square = 0.0F;
  for (const float count : signature) square += count * count;
  for (float& count : signature) count /= std::sqrt(square);
  return signature;
}

Eigen::Vector2d MarksMethod::gaze(const Content& content) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Sighting& seen : content.sightings) sum += seen.robot_from_mark.translation();
  return sum / std::max(1.0, static_cast<double>(content.sightings.size()));
}

static_assert(Method<MarksMethod>);

}  // namespace weft::agents
