#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/simulation/chaos.hpp"
#include "tests/simulation/fleet.hpp"

namespace weft::simulation {

/// Tells what people do where robots wait for one another.
enum class People : std::uint8_t {
  none,  ///< nothing: they find lost robots, lead back who cannot set off, and no more
  help
};

/// Tells what people do more often than anything else.
enum class Focus : std::uint8_t { none, rules, stops, teaching };

/// Asks of the fleet what people do: they teach the course and its sidings, then send robots about, change their
/// minds, teach some more, and help where robots wait for one that has nothing to do. Every request is repeated until
/// it is answered, as `weft` does. Faults play on meanwhile.
class Operator {
 public:
  Operator(Fleet& fleet, Chaos& chaos, Random random, People people, Focus focus)
      : fleet_(fleet), chaos_(chaos), random_(random), people_(people), focus_(focus) {}

  /// Gives each robot its lesson, or tells it where it stands on a stored map; then sends each to a station. False
  /// when it could not be done in time.
  bool begin(MapFrom map);
  /// Does one of the things that people do.
  void errand();
  /// Looks at the goals that have not ended, and helps.
  void help();
  /// Lets time pass; faults play.
  void pass(Duration time);
  /// Returns the number of goals that this operator has not seen end, as of its last look.
  std::size_t open_goals() const { return open_.size(); }
  /// Returns why `begin` gave up.
  const std::string& trouble() const { return trouble_; }
  std::uint64_t goals_sent() const { return goals_sent_; }
  std::uint64_t goals_accepted() const { return goals_accepted_; }
  /// Returns how often a robot was led back to where it can set off.
  std::uint64_t led_back() const { return led_back_; }

 private:
  struct Open {
    std::string label;
    Goal goal;           ///< as last seen
    SteadyTime since{};  ///< its history has been as it is
  };
  std::optional<msg::OperatorReply> ask(msg::OperatorRequest request, double give_up_s = 120.0);
  std::optional<msg::OperatorReply> repeat(const msg::OperatorRequest& request, double give_up_s);
  std::optional<msg::QueryReply> answer_to(msg::Query query);
  std::map<GoalId, std::vector<Goal>> look_at(std::vector<GoalId> goals);
  Revision quarantined();
  bool teach_all();
  bool find_all();
  bool teach_lesson(std::size_t robot);
  /// Has the place named where the robot stands. A robot that refines answers when the run has arrived: its request
  /// is added to `open`.
  bool label_here(std::size_t robot, const std::string& label, std::vector<msg::OperatorRequest>& open);
  bool teach_piece(std::size_t robot, double from_m, double to_m, const std::vector<std::size_t>& through);
  void teach_stop(std::size_t robot);
  /// Teaches a robot some more. False: somebody stands in the way, or it has something to do.
  bool teach_more(std::size_t robot);
  void take_away(std::size_t robot);
  void find_at(std::size_t robot, const std::string& label);
  bool is_clear(std::size_t robot, const std::vector<agents::SitePoint>& line, bool leaving) const;
  void send_goal(const std::string& label, const std::string& robot);
  template <class IsEnough>
  void insist(const msg::OperatorRequest& request, IsEnough&& is_enough);
  void resume(std::size_t robot);
  void stop_a_while(std::size_t robot);
  void press_a_while(std::size_t robot);
  void edit_a_while();
  void rule_a_while();
  void often(std::size_t robot);
  void note_stray(const Goal& goal);
  void look_around();
  void help_all_waiting();
  void lead_back(std::size_t robot);
  std::set<std::size_t> at_dead_ends() const;
  void help_waiting(const GoalId& id, Open& open);
  bool waits_for(std::size_t robot, const std::string& other) const;
  std::optional<std::size_t> blocker_of(const Goal& goal) const;
  std::vector<std::string> free_stations() const;
  std::string free_station();
  std::optional<std::size_t> robot_named(const std::string& name) const;
  std::optional<std::size_t> serving(const Goal& goal) const;
  bool is_idle(std::size_t robot) const;
  bool has_errand(std::size_t robot) const;
  template <class Condition>
  bool wait(double seconds, Condition&& condition) {
    const SteadyTime end = fleet_.now() + from_seconds(seconds);
    while (!condition()) {
      if (fleet_.now() >= end) return false;
      pass(std::chrono::milliseconds(500));
    }
    return true;
  }

  /// Notes what went wrong; always false.
  bool give_up(const std::string& what, const std::optional<msg::OperatorReply>& reply);

  Fleet& fleet_;
  Chaos& chaos_;
  Random random_;
  People people_;
  Focus focus_;
  std::string trouble_;
  std::set<std::size_t> starts_;                 ///< robots whose start has a label
  std::map<std::string, std::size_t> stations_;  ///< labels that stand, and which station of the site
  std::map<GoalId, Open> open_;
  std::set<std::size_t> strays_;  ///< robots to be led back to where they can set off
  std::uint64_t goals_sent_ = 0;
  std::uint64_t goals_accepted_ = 0;
  std::uint64_t led_back_ = 0;
};

}  // namespace weft::simulation
