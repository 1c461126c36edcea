#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/map_view.hpp"
#include "agents/navigation/teach_report.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/sample.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"

namespace weft::agents {

/// Describes a place that teaching has just kept, with the edges that join it to what exists.
struct Kept {
  Place place;
  Bytes content;
  std::vector<Edge> edges;  ///< odometry to the place before, stitches to places of the window
};

/// Describes a place that the robot has come by and knows better now.
struct LearnedPlace {
  PlaceId place;
  ContentHash made_of;  ///< the content that it was learned upon: another one there by now makes it void
  std::uint32_t content_format = 0;
  Bytes content;
};

/// Says how following goes: `stopped` may go on by itself; `failed` has given up on this route.
enum class Following : std::uint8_t { none, driving, waiting, arrived, stopped, failed };

/// Describes a wish for the exposure of the next images of a sensor (`View::sensor`).
struct ExposureWish {
  std::string sensor;
  Exposure exposure;
};

/// Holds the outcome of one sample.
struct Navigated {
  Twist command;  ///< zero when a hand drives, when standing, and when lost
  std::vector<Kept> kept;
  std::vector<LearnedPlace> learned_places;  ///< each is worth being shared
  std::optional<Fix> fix;
  std::vector<Refusal> refusals;  ///< of this sample
  Following following = Following::none;
  std::uint32_t route_at = 0;                ///< index of the last place of the route passed
  std::uint32_t route_freed = 0;             ///< everything before it is behind the footprint
  bool lost = false;                         ///< blind for longer than the limit: stands
  std::string_view reason;                   ///< why it stands
  std::optional<ExposureWish> exposes = {};  ///< none: nothing new
};

class RunRefiner;  // agents/navigation/run_refiner.hpp

struct TeachStart {
  ExperienceId experience;
  RobotId robot;
  std::vector<ExperienceId> others = {};  ///< of the methods that the navigator teaches beside the first
};

/// Holds a question of a robot that looks for itself without a seed: the signature of what it sees. A program that
/// has all contents can answer which places of the network look most like that: the server (docs/path-of-a-view.md),
/// or, in memory, `RecognitionIndex` (agents/methods/recognition):
///
///     navigator.step(...);
///     if (const Question* open = navigator.question())
///       navigator.propose(open->number, likeliest(index, snapshot, open->seen, {.most = 64, .after = open->after}));
struct Question {
  std::uint64_t number = 0;  ///< another question has another
  Signature seen;
  std::string_view method;  ///< that signed
  std::uint32_t content_format = 0;
  std::uint32_t after = 0;  ///< so many places were proposed for this signature before, in vain
};

/// Teaches, localises, recovers and follows for one robot and one method, written once (agents/navigation). The
/// method's type ends here: a variant of `NavigatorOf<M>` is behind it. Pure: time and views come in, decisions go
/// out.
class Navigator {
 public:
  virtual ~Navigator() = default;
  virtual std::string_view method() const = 0;
  /// Returns the methods that it teaches with, each an experience of its own.
  virtual std::vector<std::string> teaches() const { return {std::string(method())}; }
  /// Returns the methods of the edges that it can drive: its own, and the changes from one to the other.
  virtual std::vector<std::string> drives() const { return {std::string(method())}; }

  /// Takes one sample of the body.
  virtual Navigated step(const Sample& sample, const MapView& map) = 0;

  /// Begins to keep places, the first at the next view.
  virtual void begin_teach(const TeachStart& start) = 0;
  /// Keeps the last place, from the view of the latest sample, unless it lies at the place before; nothing more is
  /// kept afterwards. It is stitched like any other: a run that ends beside another one is no dead end. What had no
  /// view at that sample goes on being taught (`is_taught`): call again after the next one.
  virtual std::vector<Kept> end_teach(const MapView& map) = 0;
  virtual bool is_taught() const = 0;
  /// Ends teaching where the last place was kept; nothing more is kept. Returns the stitches that have been held back
  /// and that `end_teach` did not give out: they are to be handed in, too.
  virtual std::vector<Edge> leave_teach() = 0;
  /// Returns what refines a run taught with that method (one of `teaches`) before it is handed in; null: it is handed
  /// in as it is taught. This navigator outlives it.
  virtual std::unique_ptr<RunRefiner> refiner(std::string_view method) const;
  /// Keeps a place here at the next view, whatever the spacing: a label is wanted. While teaching only.
  virtual void keep_place() = 0;
  /// Returns an experience of one place: where the robot stands, without being taught, joined to the map by stitches
  /// of which at least one can be driven. Nothing but the newest view counts; what is believed stays as it is.
  /// Refused while teaching, when it does not know where it is, and when what is seen joins nothing
  /// ("nothing_joined", or why not).
  virtual OrRefusal<Kept> keep_alone(const TeachStart& start, const MapView& map) = 0;

  /// Takes note that the window `before` became `after`. An estimate at a place that has left the window is expressed
  /// by the nearest place that stayed, over the relations that led there. False: no place around has stayed, and the
  /// estimate relates to nothing. Places that were taught and are on their way to the server count as there.
  virtual bool map_changed(const Window& before, const Window& after) = 0;
  /// Forgets what was taught, as the server has refused it: those places will never be in the map.
  virtual void forget_taught(const Window& map) = 0;
  /// Drops the pose estimate and keeps the route.
  virtual void forget_where() = 0;
  /// Sets the pose estimate to one from another navigator or the agent; it holds until a fix contradicts it, and for
  /// as long as `blind_m` allows.
  virtual void believe(const Estimate& told) = 0;

  /// Looks for where the robot is: around a seed, or, without one, in the whole window. While teaching (or just
  /// before it begins) this finds where the experience joins the map.
  virtual void seek(const std::optional<PlaceId>& seed) = 0;
  /// Looks for where the robot is in the whole window, nearest to the estimate first, and keeps the estimate until
  /// another one is found. Seeks when there is no estimate.
  virtual void look_again() = 0;
  /// Ends such a look that was in vain. The search of a navigator that has no estimate or is lost goes on.
  virtual void stop_looking() = 0;
  virtual std::optional<Estimate> estimate() const = 0;
  /// Returns its question while it looks for itself without a seed, and no place around where it last was is left to
  /// try: it stays the same until it is answered, and is another one when the answer was in vain, when the robot has
  /// been moved by more than 0.25 m, and after ten seconds or so. Null: nothing. Valid until the next call.
  virtual const Question* question() const { return nullptr; }
  /// Takes the answer: places, the likeliest first; none: no more are known. They are tried in this order, before the
  /// rest of the window, as soon as the window has them with their contents. Ignores one to a question that is not
  /// open any more.
  virtual void propose(std::uint64_t /*question*/, const std::vector<PlaceId>& /*places*/) {}
  /// Returns where the robot may be by a fix that no second one has confirmed: the places around it are wanted.
  virtual std::optional<PlaceId> suspected() const { return std::nullopt; }
  /// Returns the latest place of the map that a run being taught lies beside, though nothing that was handed in joins
  /// it to that; none: there is no such place.
  virtual std::optional<PlaceId> beside() const { return std::nullopt; }
  /// Returns the runs of the map that the one being taught, or taught last, looks like and has been told apart from.
  virtual std::set<ExperienceId> told_apart() const { return {}; }
  /// Returns what the drive so far has shown of the robot beside where it is; what is not known well enough is left
  /// out.
  virtual std::vector<Diagnostic> diagnostics() const { return {}; }
  /// Returns the diagnostics of its fixes that are to be watched.
  virtual std::vector<WatchedDiagnostic> watched() const { return {}; }

  /// Reports what has been taught since teaching began, or was taught last, and how it will be found again, as far as
  /// that has been tried: some samples after each place was kept. refused: nothing has been taught yet, or the method
  /// cannot say.
  virtual Result<TeachReport> teach_report() const = 0;

  /// Follows a new route or a new version of it; the robot never passes `route.released`. `from`: the index of a
  /// place that it is known to have passed.
  virtual void follow(const Route& route, std::uint32_t from) = 0;
  void follow(const Route& route) { follow(route, 0); }
  /// Forgets the route and stands.
  virtual void stop() = 0;
};

}  // namespace weft::agents
