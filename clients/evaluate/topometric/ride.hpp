#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/topometric/config.hpp"
#include "agents/navigation/navigator.hpp"
#include "clients/evaluate/signed_places.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "clients/evaluate/topometric/moment.hpp"
#include "clients/evaluate/topometric/noted_method.hpp"
#include "clients/evaluate/topometric/raw_odometry.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Says who drives, where and when.
struct Rider {
  agents::sim::Site site;
  std::string robot = "r1";
  std::uint64_t seed = 1;
  std::uint64_t day = 0;
  std::filesystem::path scratch;  ///< a file for the truth; made and removed
  std::function<bool()> asked_to_stop;
  agents::TopometricConfig settings = {};
};

/// Joins a simulated body to the navigator of `topometric` that its agent would have, and notes each sample. Nothing
/// that drives sees the truth: it goes to a file, which is read at the end.
class Ride {
 public:
  /// Errors of body and method.
  static Result<std::unique_ptr<Ride>> make(const Rider& rider);
  ~Ride();
  Ride(const Ride&) = delete;
  Ride& operator=(const Ride&) = delete;

  agents::sim::SimulatedBody& body() { return *body_; }
  agents::Navigator& navigator() { return *navigator_; }
  const agents::Topometric& method() const { return method_; }
  double now_s() const { return moments_.empty() ? 0.0 : moments_.back().sensor_s; }
  std::size_t samples() const { return moments_.size(); }

  struct Stepped {
    agents::Navigated navigated;
    bool hand_done = false;
  };
  /// Takes one sample, drives as the navigator wants, answers its question by what the map's places look like.
  Result<Stepped> step(const TaughtMap& map);
  /// Returns what the method did in the newest sample.
  const Noted& noted() const { return *noted_; }
  /// Says what the newest sample that refused anything refused, each reason once with what was measured and its
  /// bound;
  /// "" for none.
  std::string last_refused() const;
  /// Notes the last place of a run at the newest sample.
  void note_kept(const std::vector<agents::Kept>& kept);
  /// Signs the places of the map, as the server does. corrupt: a content that the method cannot read.
  Result<void> learn_signs(const TaughtMap& map) { return signs_.learn(method_, map); }

  /// Returns all samples with the truth beside them. The ride is over.
  Result<Moments> finish();

 private:
  Ride(const Rider& rider, std::unique_ptr<agents::sim::SimulatedBody> body, const agents::Topometric& method,
       RawOdometry raw);
  void note(const agents::Sample& sample, const agents::Navigated& now, const TaughtMap& map, double processor_ms,
            const std::optional<agents::Estimate>& before);

  std::filesystem::path truth_;
  std::unique_ptr<agents::sim::SimulatedBody> body_;
  agents::Topometric method_;  ///< the judge's own
  std::shared_ptr<Noted> noted_;
  std::unique_ptr<agents::Navigator> navigator_;
  RawOdometry raw_;
  SignedPlaces signs_;
  agents::Twist command_;
  Pose2 start_from_robot_;
  std::vector<agents::Refusal> last_refused_;
  Moments moments_;
};

}  // namespace weft::evaluate::topometric
