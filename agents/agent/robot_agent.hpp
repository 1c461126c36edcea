#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/budget.hpp"
#include "agents/agent/commands.hpp"
#include "agents/agent/content_cache.hpp"
#include "agents/agent/lift_watch.hpp"
#include "agents/agent/recogniser.hpp"
#include "agents/agent/replica.hpp"
#include "agents/agent/route_task.hpp"
#include "agents/agent/session.hpp"
#include "agents/agent/spooler.hpp"

namespace weft::agents {

/// How long to wait for a piece of the map; then what there is has to do.
inline constexpr Duration kMapAtMost = std::chrono::seconds(20);

/// A run that is being taught, from the command to the sealed experience.
struct Teaching {
  enum class Phase {
    preparing,  ///< waits for the map around the seed
    seeking,    ///< waits for the first fix around the seed
    hand,       ///< waits for the body's hand to say whether it can drive this
    on,
    ending  ///< waits for a view of each camera: the last places
  };
  Phase phase = Phase::preparing;
  ExperienceId experience;           ///< of the first method
  std::vector<ExperienceId> others;  ///< of the methods beside it
  std::string name;
  std::optional<PlaceId> seed;
  std::vector<SitePoint> along;
  CommandKey started_by;
  std::optional<CommandKey> stopped_by;
  SteadyTime deadline{};  ///< of preparing, seeking and ending
  bool hand_done = false;
  bool asked_for_all = false;           ///< of the map: any of it may be met
  std::optional<CommandKey> next_part;  ///< who waits for the hand to take up another line of the same run
  std::size_t kept = 0;                 ///< places of all its experiences
  std::size_t joined = 0;               ///< of these, to places of other runs or far back in the same one

  /// An edge between places that two cameras of this robot see joins nothing new, nor one that nobody can drive.
  bool joins(const Edge& edge) const;
};

/// What the experience of a method beside the first one is called; none of a run without a name.
std::string name_of_other(const std::string& name, const std::string& method);

/// A run that is taught and spooled, while the server has not acknowledged all of it.
struct HandingIn {
  ExperienceId experience;
  std::vector<ExperienceId> others;
  CommandKey asked_by;
  SteadyTime deadline{};
  std::string what;  ///< was taught

  bool has(ExperienceId other) const;
};

/// A place that is wanted where the robot stands, without its being taught.
struct KeepingAlone {
  CommandKey asked_by;
  std::string name;
  SteadyTime deadline{};
  std::string refused = "no image came";  ///< by the last view
};

/// A search for oneself that somebody waits for.
struct Localising {
  std::optional<CommandKey> asked_by;  ///< none: the agent's own idea
  std::optional<PlaceId> seed;
  bool seeking = false;   ///< false: waits for the map
  bool believes = false;  ///< what it believes until it is seen otherwise
  SteadyTime deadline{};
};

/// The agent put together from its parts: what comes in goes to the part that it concerns, and after each call
/// everything that is due goes out, small before big.
class RobotAgent final : public Agent {
 public:
  RobotAgent(const AgentConfig& config, std::unique_ptr<Navigator> navigator, Spooler spooler, Random random,
             SteadyTime now);

  AgentOutput handle(const msg::Message& message, SteadyTime now, WallTime wall) override;
  AgentOutput tick(SteadyTime now) override;
  std::optional<SteadyTime> next_tick() const override;
  void was_away(Duration away, SteadyTime now) override;
  AgentOutput step(const Sample& sample, SteadyTime now) override;
  AgentOutput body_failed(const Error& error, SteadyTime now) override;
  AgentOutput leave(SteadyTime now) override;
  AgentOutput hand_answered(const Result<void>& answer, SteadyTime now) override;

  const Window& window() const override { return replica_.window(); }
  std::optional<Route> route() const override { return task_.route(); }
  std::optional<Estimate> estimate() const override { return navigator_->estimate(); }
  Counters counters() const override;
  std::string mount() const override;

 private:
  // Messages (robot_agent_messages.cpp).
  bool admit(const msg::Header& header, const PeerId& to, SteadyTime now);
  void heard(Session::Heard heard, SteadyTime now);
  void on(const msg::Hello& hello, SteadyTime now);
  void on(const msg::BatchAck& ack, SteadyTime now);
  void on(const msg::Chunk& chunk, SteadyTime now);
  void on(const msg::ContentRequest& request, SteadyTime now);
  void on(const msg::WindowPatch& patch, SteadyTime now);
  void on(const msg::RouteOrder& order, SteadyTime now);
  void on(const msg::AgentCommand& command, SteadyTime now);
  void on(const msg::Recognised& answer, SteadyTime now);
  void answer(const msg::ClockProbe& probe, SteadyTime now, WallTime wall);

  // What operators want (robot_agent_commands.cpp).
  void teach_start(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void teach_on(const msg::AgentCommand& command, const CommandKey& key);
  void teach_stop(const CommandKey& key, SteadyTime now);
  void teach_report(const msg::AgentCommand& command, const CommandKey& key);
  void tell_counts(const CommandKey& key);
  void localise(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void stop(const CommandKey& key, SteadyTime now);
  void resume(const CommandKey& key, SteadyTime now);
  ExperienceId new_experience();
  void reply(const CommandKey& key, const msg::AgentReply& reply);
  void refuse(const CommandKey& key, std::string reason);

  // A place that somebody wants to name (robot_agent_keep.cpp).
  void keep_place(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void try_keep_alone(SteadyTime now);
  Result<void> hand_in_alone(const TeachStart& start, const Kept& kept, const std::string& name, SteadyTime now);
  void give_up_keeping(SteadyTime now);

  // What it has come to know better of the map's places (robot_agent_lessons.cpp).
  void note_lessons(std::vector<Lesson> lessons, SensorTime seen_at);
  void hand_in_lessons(SteadyTime now);

  // Looking for itself anywhere (robot_agent_recognise.cpp).
  void look_at(std::vector<PlaceId> places, SteadyTime now);
  void follow_search(bool has_fix, SteadyTime now);
  void define_for_proposed(SteadyTime now);
  void forget_proposed();
  WindowDefinition usual_window() const;
  std::vector<PlaceId> always_held() const;
  std::vector<ContentRef> proposed_first(std::vector<ContentRef> contents) const;

  MapView map_view() const { return {replica_.window(), cache_, replica_.generation()}; }

  // What takes longer than one message (robot_agent_work.cpp).
  void work(SteadyTime now);
  void prepare_teaching(SteadyTime now);
  void start_hand();
  void begin_teaching();
  void end_teaching(SteadyTime now);
  void finish_handing_in(SteadyTime now);
  void stop_teaching(const std::string& reason, SteadyTime now);
  void abandon_teaching(const std::string& reason, SteadyTime now);
  void keep(const std::vector<Kept>& kept, SteadyTime now);
  void prepare_localising(SteadyTime now);
  void start_localising(std::optional<CommandKey> asked_by, const std::optional<PlaceId>& seed, SteadyTime now);
  void look_again(SteadyTime now);
  void note_fix(const Fix& fix, SteadyTime now);
  void note_lift(const ExperienceId& experience, double lift_m);
  void search_when_of_use(SteadyTime now);
  bool wants_to_look() const;
  void give_back_route(SteadyTime now);
  void try_follow(SteadyTime now);
  void note_following(const Navigated& navigated, SteadyTime now);
  void recentre(SteadyTime now);
  void keep_ground(SteadyTime now);
  void want_contents(SteadyTime now);

  // What is said of oneself (robot_agent_state.cpp).
  msg::RobotMode mode() const;
  std::string reason() const;
  msg::RobotDescription description();
  msg::RobotState state();
  bool state_due(SteadyTime now);

  void pump(SteadyTime now);
  AgentOutput finish(SteadyTime now);
  template <class M>
  void send(M message) {
    message.header = session_.header();
    output_.send.emplace_back(std::move(message));
  }

  AgentConfig config_;
  std::unique_ptr<Navigator> navigator_;
  Random random_;
  Session session_;
  Spooler spooler_;
  Replica replica_;
  Recogniser recogniser_;
  std::vector<PlaceId> proposed_;     ///< places that the server says to look at
  std::optional<PlaceId> suspected_;  ///< by a fix that waits for a second one
  bool is_for_proposed_ = false;      ///< the window is of those alone
  std::string proposals_noted_;       ///< so that a log has them once
  std::optional<Window> ground_;      ///< as it was when the ground was taken away; while what is left is asked for
  ContentCache cache_;
  Budget budget_;
  CommandLedger ledger_;
  RouteTask task_;
  AgentOutput output_;

  std::optional<Teaching> teaching_;
  std::optional<HandingIn> handing_in_;
  std::optional<Localising> localising_;
  std::vector<CommandKey> keeping_;  ///< who waits for the next kept place
  SteadyTime keeping_until_{};
  std::optional<KeepingAlone> keeping_alone_;
  struct Learned {
    Place place;
    Bytes content;
  };
  std::map<PlaceId, Learned> lessons_;  ///< until its drive has ended
  std::string teaching_failed_;         ///< why teaching ended by itself; until the next command
  bool stopped_ = false;                ///< by an operator
  bool lost_ = false;
  std::string fault_;
  bool follow_pending_ = false;  ///< the route waits for the map or for a localisation
  SteadyTime follow_at_latest_{};
  std::string waits_for_;   ///< why a pending route waits
  std::string stands_for_;  ///< the navigator's reason at the last sample
  Twist command_;
  std::uint64_t frame_ = 0;
  LiftWatch lift_;
  Counters seen_;  ///< fixes, and refusals of the navigator by their reason
  double speed_m_s_ = 0.0;

  PlaceId focus_;  ///< believed place when contents and centre were last looked at
  SteadyTime focused_at_{};
  std::optional<Revision> searched_at_;  ///< of the map in which it last looked for itself
  bool strays_ = false;                  ///< its route is not where it believes that it stands
  GoalId strayed_;                       ///< whose route was given back last
  int times_strayed_ = 0;                ///< for that goal
  SteadyTime search_at_{};

  SteadyTime describe_at_;
  SteadyTime state_at_;       ///< next state without a change
  SteadyTime state_sent_at_;  ///< last one
  struct Shown {
    msg::RobotMode mode{};
    bool localised = false;
    RouteId route;
    std::uint32_t version = 0;
    ExperienceId experience;
    Digest window;
    bool complete = false;
    std::string reason;
    bool operator==(const Shown&) const = default;
  };
  Shown shown() const;
  Shown said_;
};

}  // namespace weft::agents
