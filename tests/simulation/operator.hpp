#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/simulation/fleet.hpp"

namespace weft::simulation {

/// What people ask of the fleet: they teach the ring and its sidings, then send robots about, change their minds,
/// teach some more. Every request is repeated until it is answered, as `weft` does.
class Operator {
 public:
  Operator(Fleet& fleet, Random random) : fleet_(fleet), random_(random) {}

  /// One lap for each robot, through its own sidings; returns false when it could not be done in time.
  bool teach_all();
  /// One random errand. Never waits longer than a few minutes for it.
  void errand();
  /// Why `teach_all` gave up.
  const std::string& trouble() const { return trouble_; }
  std::uint64_t goals_sent() const { return goals_sent_; }
  std::uint64_t goals_accepted() const { return goals_accepted_; }

 private:
  std::optional<msg::OperatorReply> ask(msg::OperatorRequest request, double give_up_s = 120.0);
  bool teach_lap(std::size_t robot);
  bool teach_piece(std::size_t robot, double from_m, double to_m, const std::vector<std::size_t>& through);
  void teach_more(std::size_t robot);
  void send_goal();
  template <class Condition>
  bool wait(double seconds, Condition&& condition);

  /// Notes what went wrong; always false.
  bool give_up(const std::string& what, const std::optional<msg::OperatorReply>& reply);

  std::string trouble_;
  Fleet& fleet_;
  Random random_;
  std::vector<std::string> labels_;
  std::vector<GoalId> goals_;
  std::uint64_t goals_sent_ = 0;
  std::uint64_t goals_accepted_ = 0;
};

}  // namespace weft::simulation
