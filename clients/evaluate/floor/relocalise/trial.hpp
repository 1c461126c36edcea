#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/navigator.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/signed_places.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Bounds how far a robot that knows nothing is pushed until it is to know where it is.
inline constexpr double kPushM = 3.0;

/// Tells which way a robot is pushed along what was taught.
enum class Along : std::uint8_t { forwards, backwards };
inline constexpr Along kBothWays[] = {Along::forwards, Along::backwards};
const char* name_of(Along along);

/// Holds what came of one robot that was put down somewhere.
struct Trial {
  Along along = Along::forwards;
  Pose2 site_from_robot;          ///< where it was put down
  std::optional<double> found_m;  ///< pushed so far until it believed to know where it is; none: it never did
  bool is_wrong = false;          ///< and that was wrong
  std::string refused;            ///< most often, when it never did
};

/// Says where a robot is put down, and along what it is pushed.
struct Push {
  Along along = Along::forwards;
  Pose2 site_from_robot;
  std::vector<agents::SitePoint> way;
};
/// Draws a start anywhere on the line: a little beside it, headed a little askew, as robots that follow it are.
Push some_push(const std::vector<agents::SitePoint>& line, Along along, Random& random);

/// Pushes one body that is put down again and again.
class Pushed {
 public:
  /// Makes the body and the method. Returns their errors.
  static Result<Pushed> make(const Drive& drive);
  /// Signs all places, as the server does. corrupt: a content that the method cannot read.
  Result<void> learn(const Taught& taught);
  /// Pushes it with a new navigator: all settings are the defaults, and it knows nothing but the map. None: stopped.
  Result<std::optional<Trial>> push(const Push& push, const Taught& taught);

 private:
  Pushed(std::unique_ptr<agents::sim::SimulatedBody> body, agents::Floor method, std::function<bool()> asked_to_stop)
      : body_(std::move(body)), method_(std::move(method)), asked_to_stop_(std::move(asked_to_stop)) {}

  std::unique_ptr<agents::sim::SimulatedBody> body_;
  agents::Floor method_;
  SignedPlaces known_;
  std::function<bool()> asked_to_stop_;
};

}  // namespace weft::evaluate::floor
