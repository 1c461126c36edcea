#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/methods/recognition/index.hpp"
#include "agents/navigation/navigator.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// How far a robot that knows nothing is pushed until it is to know where it is.
inline constexpr double kPushM = 3.0;

/// Which way along what was taught.
enum class Along : std::uint8_t { forwards, backwards };
inline constexpr Along kBothWays[] = {Along::forwards, Along::backwards};
const char* name_of(Along along);

/// What came of one robot that was put down somewhere.
struct Trial {
  Along along = Along::forwards;
  Pose2 site_from_robot;          ///< where it was put down
  std::optional<double> found_m;  ///< pushed so far until it believed to know where it is; none: it never did
  bool is_wrong = false;          ///< and that was wrong
  std::string refused;            ///< most often, when it never did
};

/// Where it is put down, and along what it is pushed.
struct Push {
  Along along = Along::forwards;
  Pose2 site_from_robot;
  std::vector<agents::SitePoint> way;
};
/// Anywhere on the line: a little beside it, headed a little askew, as robots that follow it are.
Push some_push(const std::vector<agents::SitePoint>& line, Along along, Random& random);

/// A body that is put down again and again.
class Pushed {
 public:
  /// Errors of body and method.
  static Result<Pushed> make(const Drive& drive);
  /// What the server knows: the signatures of all places. corrupt: a content that the method cannot read.
  Result<void> learn(const Taught& taught);
  /// With a navigator that has every setting at its default and is told nothing but the map. None: stopped.
  Result<std::optional<Trial>> push(const Push& push, const Taught& taught);

 private:
  Pushed(std::unique_ptr<agents::sim::SimulatedBody> body, agents::Floor method, std::function<bool()> asked_to_stop)
      : body_(std::move(body)), method_(std::move(method)), asked_to_stop_(std::move(asked_to_stop)) {}

  /// The server's part: at once.
  void answer(agents::Navigator& navigator, const Taught& taught) const;

  std::unique_ptr<agents::sim::SimulatedBody> body_;
  agents::Floor method_;
  agents::RecognitionIndex known_;
  std::function<bool()> asked_to_stop_;
};

}  // namespace weft::evaluate::floor
