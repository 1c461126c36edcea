#include "agents/perception/focal_share.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "agents/perception/robust.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kFewestSights = 20;
constexpr int kShareRounds = 10;
constexpr double kRowSigmaPx = 0.4;  // of a corner's row, at best
constexpr double kUsual_1_m = 0.35;  // of things 1 to 10 m away
constexpr double kUsualSigma_1_m = 0.3;
constexpr double kSaidTo = 0.02;     // 1 sigma, beforehand: else some views let it run away
constexpr double kHardlyTold = 0.8;  // of that variance: what is left of it has said nothing
constexpr double kMostShare = 0.1;   // data sheets are not as wrong as that
constexpr double kSettled = 1e-4;    // change of the share in the last round
constexpr Eigen::Index kFurther = 0;
constexpr Eigen::Index kFocal = 1;
constexpr Eigen::Index kPitches = 2;

/// Describes how one thing lies in another view against how the robot sees it.
struct Sight {
  Eigen::Index view = 0;
  double elevation = 0.0;  // tangent, downwards; mean of both
  double risen = 0.0;
  double towards = 1.0;  // share of a step ahead by which it comes nearer
};

struct Thing {
  std::vector<Sight> sights;
  double near_1_m = kUsual_1_m;  // over its distance from the robot
  double off = 0.0;              // of its elevation in the robot's view, which all sights share
};

std::vector<Thing> things_of(const std::vector<OtherView>& views, const std::vector<UprightFeature>& seen,
                             double focal_px) {
  const auto elevation_of = [&](const UprightFeature& feature) {
    return static_cast<double>(feature.pixel.y()) / std::hypot(focal_px, static_cast<double>(feature.pixel.x()));
  };
  std::vector<Thing> all(seen.size());
  for (std::size_t k = 0; k < views.size(); ++k) {
    for (const Match& match : *views[k].same) {
      const double before = elevation_of((*views[k].features)[match.a]);
      const double after = elevation_of(seen[match.b]);
      const double aside = static_cast<double>(seen[match.b].pixel.x()) / focal_px;
      all[match.b].sights.push_back({static_cast<Eigen::Index>(k), 0.5 * (before + after), after - before,
                                     1.0 / std::sqrt(1.0 + aside * aside)});
    }
  }
  std::erase_if(all, [](const Thing& thing) { return thing.sights.empty(); });
  return all;
}

class Solver {
 public:
  Solver(const std::vector<OtherView>& views, std::vector<Thing> things, double focal_px)
      : views_(views),
        things_(std::move(things)),
        least_sigma_(kRowSigmaPx / focal_px),
        state_(Eigen::VectorXd::Zero(kPitches + static_cast<Eigen::Index>(views.size()))) {
    for (std::size_t k = 0; k < views.size(); ++k) {
      std::vector<double> risen;
      for (const Thing& thing : things_)
        for (const Sight& sight : thing.sights)
          if (sight.view == static_cast<Eigen::Index>(k)) risen.push_back(sight.risen);
      if (!risen.empty()) state_[kPitches + static_cast<Eigen::Index>(k)] = median_of(risen);
    }
  }

  std::optional<FocalShare> solve() {
    double before = 0.0;
    for (int round = 0; round < kShareRounds; ++round) {
      before = state_[kFocal];
      if (!step()) return std::nullopt;
    }
    const Eigen::MatrixXd covariance = sigma_ * sigma_ * normal_.inverse();
    if (!covariance.allFinite() || std::abs(state_[kFocal] - before) > kSettled) return std::nullopt;
    return by_views_alone({state_[kFocal], covariance(kFocal, kFocal)});
  }

 private:
  /// Takes out what was held beforehand: who adds up several looks would count that with each of them.
  static std::optional<FocalShare> by_views_alone(const FocalShare& found) {
    constexpr double beforehand = kSaidTo * kSaidTo;
    if (found.variance > kHardlyTold * beforehand) return std::nullopt;
    const double variance = 1.0 / (1.0 / found.variance - 1.0 / beforehand);
    const double share = found.share * variance / found.variance;
    if (std::abs(share) > kMostShare) return std::nullopt;
    return FocalShare{share, variance};
  }

  /// Holds the residual of a thing's rise in a view, and its derivatives by the thing's nearness (1 / distance) and
  /// by how much further the robot is.
  struct Expected {
    double left = 0.0;
    double by_near = 0.0;
    double by_further = 0.0;
  };
  Expected expected(const Thing& thing, const Sight& sight) const {
    const double step_m = sight.towards * (state_[kFurther] - views_[static_cast<std::size_t>(sight.view)].ahead_m);
    const double of_mean = std::max(0.3, 1.0 + 0.5 * step_m * thing.near_1_m);
    const double share = step_m * thing.near_1_m / of_mean;
    const double left =
        sight.risen - thing.off - state_[kPitches + sight.view] - (state_[kFocal] + share) * sight.elevation;
    return {left, sight.elevation * step_m / (of_mean * of_mean),
            sight.elevation * sight.towards * thing.near_1_m / (of_mean * of_mean)};
  }

  /// Takes one Gauss-Newton step, each thing's own unknowns eliminated (Schur complement); false: it is singular.
  bool step() {
    std::vector<double> left;
    for (const Thing& thing : things_)
      for (const Sight& sight : thing.sights) left.push_back(std::abs(expected(thing, sight).left));
    sigma_ = std::max(least_sigma_, kSigmaOfMad * median_of(std::move(left)));
    const Eigen::Index size = state_.size();
    normal_ = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    const double focal_weight = sigma_ * sigma_ / (kSaidTo * kSaidTo);
    normal_(kFocal, kFocal) += focal_weight;
    right[kFocal] -= focal_weight * state_[kFocal];
    for (Eigen::Index k = kPitches; k < size; ++k) normal_(k, k) += 1e-6;  // a view that shows nothing
    eliminated_.clear();
    for (const Thing& thing : things_) add(thing, right);
    const Eigen::LDLT<Eigen::MatrixXd> solved(normal_);
    if (solved.info() != Eigen::Success || !solved.isPositive()) return false;
    const Eigen::VectorXd change = solved.solve(right);
    if (!change.allFinite()) return false;
    state_ += change;
    for (std::size_t i = 0; i < things_.size(); ++i) {
      const Eliminated& own = eliminated_[i];
      const Eigen::Vector2d moved = own.inverse * (own.right - own.with * change);
      things_[i].near_1_m = std::clamp(things_[i].near_1_m + moved[0], 0.0, 2.0);
      things_[i].off += moved[1];
    }
    return true;
  }

  void add(const Thing& thing, Eigen::VectorXd& right) {
    const Eigen::Index size = state_.size();
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
    Eliminated eliminated;
    eliminated.with = Eigen::MatrixXd::Zero(2, size);
    const double near_weight = sigma_ * sigma_ / (kUsualSigma_1_m * kUsualSigma_1_m);
    own(0, 0) = near_weight;
    own(1, 1) = 1.0;  // as sure as a sight
    eliminated.right = {near_weight * (kUsual_1_m - thing.near_1_m), -thing.off};
    for (const Sight& sight : thing.sights) {
      const Expected now = expected(thing, sight);
      const double weight = tukey_weight(now.left, sigma_);
      if (weight == 0.0) continue;
      const Eigen::Vector2d of_thing(now.by_near, 1.0);
      const Eigen::Vector3d of_all(now.by_further, sight.elevation, 1.0);
      const std::array<Eigen::Index, 3> at = {kFurther, kFocal, kPitches + sight.view};
      own += weight * of_thing * of_thing.transpose();
      eliminated.right += weight * now.left * of_thing;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        right[at[i]] += weight * now.left * of_all[row];
        eliminated.with.col(at[i]) += weight * of_all[row] * of_thing;
        for (std::size_t j = 0; j < 3; ++j)
          normal_(at[i], at[j]) += weight * of_all[row] * of_all[static_cast<Eigen::Index>(j)];
      }
    }
    eliminated.inverse = own.inverse();
    normal_ -= eliminated.with.transpose() * eliminated.inverse * eliminated.with;
    right -= eliminated.with.transpose() * (eliminated.inverse * eliminated.right);
    eliminated_.push_back(std::move(eliminated));
  }

  struct Eliminated {
    Eigen::Matrix2d inverse;
    Eigen::Vector2d right;
    Eigen::MatrixXd with;
  };

  const std::vector<OtherView>& views_;
  std::vector<Thing> things_;
  double least_sigma_;
  Eigen::VectorXd state_;
  Eigen::MatrixXd normal_;
  double sigma_ = 0.0;
  std::vector<Eliminated> eliminated_;
};

}  // namespace

std::optional<FocalShare> focal_share_of(const std::vector<OtherView>& views, const std::vector<UprightFeature>& seen,
                                         double focal_px) {
  std::size_t sights = 0;
  for (const OtherView& view : views) sights += view.same->size();
  if (sights < kFewestSights) return std::nullopt;
  return Solver(views, things_of(views, seen, focal_px), focal_px).solve();
}

}  // namespace weft::agents
