#pragma once
#include <tl/expected.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agents/perception/motion.hpp"
#include "agents/perception/view.hpp"
#include "core/bytes.hpp"
#include "core/diagnostic.hpp"
#include "core/network/network.hpp"
#include "core/network/relation.hpp"
#include "core/network/window.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

/// Describes the method contract: what differs between ways of navigating by camera. Everything else (teaching,
/// searching the neighbourhood, acceptance, recovery, following, stitching) is generic and in agents/navigation.
namespace weft::agents {

/// Holds the effect on a relation of errors that all steps of a drive have in common (a calibration's), one column
/// each: xi of (x, y, z, roll, pitch, yaw) in a_from_b * se3_exp(xi) for one sigma, m and rad. Columns are
/// independent of one another; those that a method does not use are zero, and so are z, roll and pitch of methods of
/// the plane.
using CommonErrors = Eigen::Matrix<double, 6, 11>;
/// Holds the same of x, y and heading alone.
using PlanarErrors = Eigen::Matrix<double, 3, 11>;
inline constexpr Eigen::Index kYaw = 5;  ///< row of CommonErrors
CommonErrors in_space(const PlanarErrors& errors);
PlanarErrors in_plane(const CommonErrors& errors);

/// Describes the motion between two consecutive samples.
struct Step {
  Relation previous_from_current;  ///< with its covariance, that of `common` included
  bool seen = false;               ///< false: vision was blind, this is integrated commands or wheels
  std::string_view blind_reason;   ///< static text; empty when seen
  CommonErrors common = CommonErrors::Zero();
};

/// Tells why something was not accepted: a name that is counted and shown, the measured value and its bound.
struct Refusal {
  std::string_view reason;  ///< static text, e.g. "few_inliers"
  double measured = 0.0;
  double bound = 0.0;
};
template <class T>
using OrRefusal = tl::expected<T, Refusal>;

/// Describes a relation that two contents agree on, with its evidence.
struct Related {
  Relation a_from_b;
  std::uint32_t inliers = 0;
  double overlap = 0.0;                      ///< share of b's view seen in a
  double residual = 0.0;                     ///< the method's distance (h_distance for floor); smaller is better
  std::vector<Diagnostic> diagnostics = {};  ///< what else the two contents show of the robot that saw b
  /// Says what speaks against it, from 0 to 1: the share of what one of them shows where the other has seen that
  /// nothing stands, as something has come or gone, or it is another place that looks alike; 1 where nothing else
  /// confirms it. 0 also where the method cannot tell.
  double doubt = 0.0;
};

/// Describes a diagnostic of fixes that deserves a person's attention while it is beyond a bound, and how to say so.
struct WatchedDiagnostic {
  /// Sets where a notice begins and, lower, where it ends, so that it does not flicker.
  struct Bounds {
    double begins = 0.0;
    double ends = 0.0;
  };
  std::string_view name;  ///< of Related::diagnostics
  Bounds against_places;  ///< of its size, as fixes state it
  Bounds against_itself;  ///< of its change on the places of one experience, where no other robot plays a part
  /// Returns the notice: the value, what it is compared with ("its places say"), and what to look at.
  std::string (*notice)(double value, std::string_view compared_with) = nullptr;
  std::string_view well_again;  ///< said when the notice ends
};

using Signature = std::vector<float>;
/// Returns the squared distance of two signatures of one method.
double distance2(const Signature& a, const Signature& b);

/// Describes a recognised place and where the robot is relative to it, with the evidence.
struct Fix {
  PlaceId place;
  Relation place_from_robot;
  Related evidence;
};

/// Holds the pose that navigation believes: a single hypothesis. A method that localises in its own way may keep a
/// richer belief; its fixes lead to this.
struct Estimate {
  PlaceId place;
  Relation place_from_robot;
  double blind_m = 0.0;  ///< travelled since the last fix
};

/// Describes a place as a chart is made of it: its relation to the chart's centre and its decoded content (null while
/// the bytes have not arrived).
template <class Content>
struct ChartPlace {
  PlaceId id;
  std::uint32_t depth = 0;
  Relation centre_from_place;
  std::shared_ptr<const Content> content;
};

/// Bounds the part of the map around the robot that a chart is made of.
struct ChartSize {
  std::uint32_t hops = 12;
  std::uint32_t places = 200;
};

/// Holds the answer of `locate`.
template <class Belief>
struct Located {
  Belief belief;
  std::optional<Fix> fix;
  std::vector<Refusal> refusals;  ///< of this attempt
};

/// Describes the way ahead that `steer` may look at: the released part of the route in the robot's frame (planar,
/// points of the path with the direction of travel), the profile, and how it ends.
struct Ahead {
  std::vector<Pose2> robot_from_path;  ///< ordered; the first may lie behind the robot
  double to_end_m = 0.0;               ///< along the path to the released point
  bool end_is_goal = false;
  double speed_limit_m_s = 0.6;
  double speed_m_s = 0.0;   ///< current
  double aside_m = 0.0;     ///< so far beside the path the robot may be steered, as it is held for it
  bool knows_aside = true;  ///< false: how far beside the path the robot is nobody knows (AlongPath)
  Duration elapsed{};
};
struct Stop {
  std::string_view reason;
};
using Steering = tl::expected<Twist, Stop>;

/// Shows a method that localises in its own way where the robot is: the chart around it, the method's belief in that,
/// and the pose that navigation believes, which has moved on since the last fix.
template <class M>
struct Around {
  const typename M::Chart* chart = nullptr;
  const typename M::Belief* belief = nullptr;
  Pose2 centre_from_robot;
};

/// Tells for how long a robot has not known where it is.
struct LostFor {
  Duration time{};
  double turned_rad = 0.0;  ///< since then, both directions added up
};

/// Describes a place of a taught run that is to be refined, as it was kept. Places come in the order of their
/// indices.
template <class Content>
struct ExperiencePlace {
  PlaceId id;
  std::shared_ptr<const Content> content;
  /// Holds what was kept with the place: odometry from the one before, stitches to earlier places of the same run and
  /// to places of others, whose contents are not among those given.
  std::vector<Edge> edges;
};

/// Describes a new relation for an edge of a run that is not handed in yet.
struct AmendedEdge {
  EdgeId edge;
  Relation a_from_b;
};

/// Describes a new content for a place of a run that is not handed in yet.
template <class Content>
struct AmendedPlace {
  PlaceId place;
  Content content;
};

/// Holds all that refining changes of a run; what is not named stays as it was taught.
template <class Content>
struct Amendments {
  std::vector<AmendedEdge> edges;
  std::vector<AmendedPlace<Content>> places;
};

/// Describes another robot, on another day, beside where a view was taken.
struct Revisit {
  std::size_t condition = 0;  ///< one of M::conditions
  Pose2 robot_from_other;     ///< a few centimetres and degrees: what lies further off was not in the view
  std::uint64_t seed = 0;     ///< of its calibration's error, noise and what lies on the floor
};

/// Holds what the other robot sees, and where it stands: where it was asked to, or, of a method that knows views from
/// where they were taken alone, there.
template <class Content>
struct Revisited {
  Content content;
  Pose2 robot_from_other;
};

/// Describes a method. M is a value: configuration and calibration, fixed after construction. Odometry is its state
/// between samples.
template <class M>
concept Method = std::movable<M> &&
    requires(const M& m, typename M::Odometry odometry, const View& view, const Motion& motion,
             const typename M::Content& content, const std::optional<Relation>& guess, ByteView bytes) {
  { M::name } -> std::convertible_to<std::string_view>;
  { M::content_format } -> std::convertible_to<std::uint32_t>;
  requires std::default_initializable<typename M::Odometry>;
  /// Returns the step of a sample and updates the state in place. `view` is null when the frame was dropped.
  { m.observe(odometry, static_cast<const View*>(nullptr), motion) } -> std::same_as<Step>;
  /// Returns what a place here would store. Refusal: nothing to remember here (too blank, too blurred).
  { m.extract(std::as_const(odometry), view) } -> std::same_as<OrRefusal<typename M::Content>>;
  { m.encode(content) } -> std::same_as<Bytes>;
  { m.decode(bytes) } -> std::same_as<Result<typename M::Content>>;
  /// Returns a_from_b of the robot frames at which both were extracted.
  { m.relate(content, content, guess) } -> std::same_as<OrRefusal<Related>>;
  { m.sign(content) } -> std::same_as<std::optional<Signature>>;
};

/// Describes a method that localises in its own way (a mosaic, a filter, fixed points). The default is
/// agents/navigation/localiser.hpp: a list of candidates, breadth-first + relate.
template <class M>
concept ChartsItself = Method<M> &&
    requires(const M& m, const std::vector<ChartPlace<typename M::Content>>& around, const typename M::Chart& chart,
             typename M::Belief belief, const Step& step, const typename M::Content& seen, const Estimate& seed) {
  { M::chart_size } -> std::convertible_to<ChartSize>;
  { m.chart(around) } -> std::same_as<typename M::Chart>;
  { m.begin(chart, seed) } -> std::same_as<typename M::Belief>;
  { m.locate(chart, belief, step, seen) } -> std::same_as<Located<typename M::Belief>>;
  /// Returns the belief, around navigation's own estimate, once navigation has weighed the method's fix.
  { m.believed(chart, belief, seed) } -> std::same_as<typename M::Belief>;
};

/// Describes a method whose beliefs hold more than where the robot is: that outlives a lost way and goes into each
/// new chart.
template <class M>
concept Remembers = ChartsItself<M> &&
    requires(const M& m, const typename M::Chart& chart, const typename M::Belief& before, const Estimate& seed) {
  { m.begin(chart, seed, before) } -> std::same_as<typename M::Belief>;
};

/// Describes a method whose belief goes on in the next chart as it is, so that a robot on its way need not begin
/// anew.
template <class M>
concept CarriesBelief = ChartsItself<M> &&
    requires(const M& m, const typename M::Chart& chart, const typename M::Belief& before, const Estimate& seed) {
  /// Returns the belief `before` of another chart, in this one; `seed` is where the robot was in this one when it was
  /// located last. The steps since then are joined to the next `locate`'s.
  { m.carried(chart, seed, before) } -> std::same_as<typename M::Belief>;
};

/// Returns whether fixes of a method are what odometry and views say together, so that navigation must not weigh them
/// against odometry again: they are gated as ever and then believed as they are.
template <class M>
constexpr bool is_posterior() {
  if constexpr (requires { M::is_posterior; }) return M::is_posterior;
  return false;
}

/// Returns whether edges that a method has taught are driven in either direction, the robot facing the way it drives.
template <class M>
constexpr bool drives_both_ways() {
  if constexpr (requires { M::drives_both_ways; }) return M::drives_both_ways;
  return false;
}

/// Describes a method that knows better how two places taught one after the other lie to each other than odometry
/// alone.
template <class M>
concept Registers = Method<M> && requires(const M& m, const typename M::Content& content, const Relation& a_from_b) {
  /// Returns the relation as odometry and both contents have it; as it was where they do not agree.
  { m.registered(content, content, a_from_b) } -> std::same_as<Relation>;
};

/// Describes a method that can tell two places apart which look alike where both see the same.
template <class M>
concept Contradicts = Method<M> &&
    requires(const M& m, const typename M::Content& content, const Relation& a_from_b) {
  /// Returns what either of them shows, were they related so, that the other one should show and does not: 0 or more.
  { m.contradiction(content, content, a_from_b) } -> std::same_as<double>;
};

/// Describes a method that sees whether a straight way between two places nobody has driven is free: a shortcut.
template <class M>
concept Clears = ChartsItself<M> && requires(const M& m, const typename M::Chart& chart, const Pose2& pose) {
  /// Returns whether all of the straight way from a to b, as wide as the robot, is known to be free.
  { m.is_clear(chart, pose /* centre_from_a */, pose /* a_from_b */) } -> std::same_as<bool>;
};

/// Describes a method that looks around where the robot is lost: it turns on the spot and never drives.
template <class M>
concept Recovers = Method<M> && requires(const M& m, typename M::Odometry& odometry, const LostFor& lost) {
  /// Returns how to turn; none: it stands.
  { m.recover(odometry, lost) } -> std::same_as<std::optional<Twist>>;
};

/// Describes a method whose contents look alike in more places than one: what a view is related to anywhere is
/// believed when no place elsewhere in the window is nearly as much like it.
template <class M>
concept ComparesRivals = Method<M> &&
    requires(const M& m, const typename M::Content& place, const typename M::Content& seen) {
  /// Returns how alike the two are: larger is more alike; 0: not at all.
  { m.likeness(place, seen) } -> std::same_as<double>;
  /// Returns how much like it a place elsewhere may be, by the likeness of the place itself.
  { m.most_of_rival(1.0) } -> std::same_as<double>;
};

/// Describes a method that steers in its own way. Default: spline + Hoffmann + PI (agents/navigation/follower.hpp).
template <class M>
concept SteersItself = ChartsItself<M> &&
    requires(const M& m, typename M::Odometry& odometry, const Around<M>* around, const Ahead& ahead) {
  /// Returns the command for this sample; `around` is null where there is no chart. Stop "blocked": something stands
  /// in the way.
  { m.steer(odometry, around, ahead) } -> std::same_as<Steering>;
};

/// Returns whether a method that steers itself does so along a path that can be bent, as the default does: without
/// the places that step back or aside. Else it gets the released places as they lie.
template <class M>
constexpr bool steers_along_a_path() {
  if constexpr (requires { M::steers_along_a_path; }) return M::steers_along_a_path;
  return false;
}

/// Describes a method that says how its camera is to expose the next views so that they show most of what it matches.
/// None: as the camera likes. It is asked after `observe`, at each view.
template <class M>
concept Exposes = Method<M> && requires(const M& m, const typename M::Odometry& odometry, const View& view) {
  { m.expose(odometry, view) } -> std::same_as<std::optional<Exposure>>;
};

/// Describes a method whose places know how the robot was driving there: it is repeated no faster.
template <class M>
concept Replays = Method<M> && requires(const typename M::Content& content) {
  { M::driven(content) } -> std::same_as<Twist>;
};

/// Describes a method whose places become better known each time that a robot comes by. What it has learned of a
/// place is a content like any other: every robot localises against it.
template <class M>
concept Learns = Method<M> && requires(const M& m, const typename M::Content& known, const typename M::Content& seen,
                                       const Relation& known_from_seen) {
  /// Is the format of contents that `encode` makes of what was learned; `content_format` is that of those that were
  /// taught.
  { M::learned_format } -> std::convertible_to<std::uint32_t>;
  /// Returns the place as it is better known after one more pass, of which `seen` is the view nearest to it. None:
  /// this view is not to be learned from.
  { m.learn(known, seen, known_from_seen) } -> std::same_as<std::optional<typename M::Content>>;
  /// Returns whether a robot sees so much more of the second one, `learned`, than of the first, `shared`, upon which
  /// it was learned, that all robots are to have it. Soon false where nothing changes.
  { m.is_worth_sharing(known, known) } -> std::same_as<bool>;
};

/// Returns the newest format of contents that M reads.
template <Method M>
constexpr std::uint32_t newest_format() {
  if constexpr (Learns<M>) return std::max<std::uint32_t>(M::content_format, M::learned_format);
  return M::content_format;
}

/// Describes a method that can say what another robot would have looked for a place with instead of a view: with it
/// teaching finds out whether a place will be found again before the robot leaves it.
template <class M>
concept SimulatesRevisits = Method<M> &&
    requires(const M& m, const typename M::Odometry& odometry, const View& view, const Revisit& revisit) {
  /// Names what may have changed by then, the mildest first: "as_is", "half_light".
  {std::span<const std::string_view>(M::conditions)};
  /// Returns what the other robot sees, made of nothing that a place taught here is made of; `odometry` is that at
  /// the view.
  { m.simulate_revisit(odometry, view, revisit) } -> std::same_as<OrRefusal<Revisited<typename M::Content>>>;
};

/// Tells how far off a robot guesses where it is when it looks for a place: one sigma.
struct GuessError {
  double sigma_m = 0.03;
  double sigma_rad = 0.02;
};

/// Returns with which guess places of a method are to be found again: that of a robot which has just localised,
/// unless the method states another as `revisit_guess`.
template <SimulatesRevisits M>
constexpr GuessError revisit_guess() {
  if constexpr (requires { M::revisit_guess; }) return M::revisit_guess;
  return {};
}

/// Describes a method that measures more of its robot than where it is.
template <class M>
concept Diagnoses = Method<M> && requires(const M& m, const typename M::Odometry& odometry) {
  {std::span<const WatchedDiagnostic>(M::watched)};
  /// Returns what the drive so far has shown; a diagnostic that is not known well enough is left out.
  { m.diagnose(odometry) } -> std::same_as<std::vector<Diagnostic>>;
};

/// Describes a method that refines what it was taught, when the run is over and before it is handed in. The run stays
/// on the robot until it is refined. The result depends on the run alone.
template <class M>
concept Refines = Method<M> && std::movable<typename M::Refinement> &&
    requires(const M& m, const std::vector<ExperiencePlace<typename M::Content>>& experience,
             typename M::Refinement& refinement) {
  /// Returns the refinement of a run, about as dear as one piece. A run that cannot be refined has no pieces.
  { m.begin_refine(experience) } -> std::same_as<typename M::Refinement>;
  /// Does one piece, at most 50 ms on a robot's computer; false: it is done, also where nothing was to be done.
  { m.refine(refinement) } -> std::same_as<bool>;
  /// Returns how many pieces there are in all, at most.
  { m.pieces(std::as_const(refinement)) } -> std::same_as<std::size_t>;
  { m.refined(std::move(refinement)) } -> std::same_as<Amendments<typename M::Content>>;
};

}  // namespace weft::agents
