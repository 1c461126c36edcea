#pragma once
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "core/network/goal.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"
#include "server/eta/passing.hpp"
#include "server/eta/speeds.hpp"

namespace weft::server {

/// Tells from how long robots took, against what was foretold, between what the next one will take in four of five
/// cases. Wide until kFewest are known.
class Band {
 public:
  void add(double real_s, double foretold_s);
  double soonest() const { return of_foretold(0.1, 0.5); }  ///< share of the time foretold
  double latest() const { return of_foretold(0.9, 2.0); }

  static constexpr std::size_t kFewest = 10;

 private:
  double of_foretold(double share, double if_few) const;

  std::deque<double> ratios_;  ///< the latest last
};

/// Foretells when robots come to their goals, from their reports on the way. What it has learned of the map is kept
/// in the store; the band is that of the arrivals since the server started.
class Arrivals {
 public:
  explicit Arrivals(const std::map<RunPiece, std::vector<Pass>>& stored) : speeds_(stored) {}

  /// Takes the robot's report on this version of its route.
  void on_report(const RobotId& robot, const Route& route, const msg::RouteProgress& report, SteadyTime now);
  /// Forgets where the robot was on its route, which is over.
  void ended(const RobotId& robot) { robots_.erase(robot); }
  /// Returns when the robot comes to the end of its route, counted from its latest report.
  msg::Arrival foretell(const RobotId& robot, const Route& route) const;

  /// Returns what is to be stored with whatever is stored next: some pieces of runs, each half minute at most.
  std::vector<storage::PutPasses> due(SteadyTime now);
  /// Notes that these could not be stored.
  void put_back(const std::vector<storage::PutPasses>& passes) { speeds_.put_back(passes); }

 private:
  struct Foretold {
    SteadyTime at;
    double left_s = 0.0;
  };
  struct Followed {
    RouteId route;
    Passing passing;
    std::size_t from = 0;              ///< index at which it was first seen
    std::optional<Foretold> half_way;  ///< what was foretold there, to be compared with what comes
    bool is_disturbed = false;         ///< it was stopped: that nobody foretells
  };

  void compare(Followed& robot, const Route& route, const msg::RouteProgress& report, SteadyTime now);

  Speeds speeds_;
  Band band_;
  std::map<RobotId, Followed> robots_;
  SteadyTime next_round_{};
};

}  // namespace weft::server
