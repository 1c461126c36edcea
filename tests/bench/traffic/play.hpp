#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "tests/server/arranged_site.hpp"

namespace weft::bench {

/// Runs a whole server and robots that are points: they drive what they are released, at 0.6 m/s, and say so.
class Play {
 public:
  Play();

  /// Teaches a way along the corners, a place each half metre; where it comes within 0.3 m of what was taught before
  /// in about the same direction the two are stitched. Returns the run.
  ExperienceId teach(const std::vector<Eigen::Vector2d>& corners);
  /// Returns the place of that run that is nearest.
  PlaceId near(ExperienceId run, const Eigen::Vector2d& at) const;
  void label(const std::string& name, const PlaceId& place) { site_.label(name, place); }

  void put(const std::string& robot, const PlaceId& place);
  void send(const std::string& robot, const std::string& label);
  /// Closes a stretch of a run, both ways, until it is opened.
  void close(const std::string& rule, const PlaceId& first, const PlaceId& last);
  void open(const std::string& rule);
  void end(const std::string& robot) { robots_.at(robot).is_alive = false; }
  void pass(double seconds);
  /// Returns whether every goal ended within that time; stops as soon as that is so.
  bool play(double seconds);

  double now_s() const;
  /// Returns how long after the last move a standstill was named for the first time; none: none was.
  std::optional<double> named_after_s() const { return named_after_s_; }
  std::vector<std::string> named() const { return site_.events_of("traffic.standstill"); }
  /// Returns what each goal that has not ended says last.
  std::vector<std::string> open_goals();

 private:
  struct Puppet {
    server::test::Peer peer;
    PlaceId at;
    bool is_alive = true;
    std::optional<Route> route;
    std::uint32_t index = 0;
    double driven_m = 0.0;  ///< beyond that place
  };
  void step();
  void take_orders();
  void drive(Puppet& robot);
  bool all_over();

  server::test::Site site_;
  std::map<std::string, Puppet> robots_;
  std::map<PlaceId, Pose2> poses_;
  server::test::Peer teacher_{.id = server::test::robot_id(99), .name = "teacher"};
  std::uint64_t runs_ = 0;
  std::uint8_t goals_ = 0;
  double moved_s_ = 0.0;
  std::optional<double> named_after_s_;
};

}  // namespace weft::bench
