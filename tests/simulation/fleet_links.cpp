#include "tests/simulation/fleet.hpp"

/// Plays where processes are on the network, and how each keeps its link open.
namespace weft::simulation {
namespace {

constexpr Duration kLookAtLinksEvery = std::chrono::milliseconds(500);  // as idl/bus/dds_bus.cpp does

}  // namespace

Whereabouts Fleet::whereabouts(const Wire& wire) const {
  return {wire.address, &wire == &server_.wire ? std::string() : server_.wire.address};
}

void Fleet::open(Wire& wire, msg::Role role, const PeerId& id) {
  wire.link = std::make_unique<bus::Link>(net_.attach(role, id));
  wire.keeper.emplace(net_, id, whereabouts(wire), now_);
  connect(wire, id);
}

void Fleet::close(Wire& wire, const PeerId& id) {
  net_.detach(id);
  wire.keeper.reset();
  wire.link.reset();
}

/// Cuts off who is not where others speak to it, or speaks to where nobody is.
void Fleet::connect(Wire& wire, const PeerId& id) {
  const bool connects = wire.keeper && wire.keeper->connects(whereabouts(wire));
  net_.partition(id, connects ? wire.cut : bus::Cut::all);
  if (const auto robot = ledger_.robots.find(id); robot != ledger_.robots.end()) {
    robot->second.is_cut_off = !connects || wire.cut != bus::Cut::none;
  }
}

void Fleet::connect_all() {
  connect(server_.wire, server_.id);
  connect(client_.wire, client_.id);
  for (RobotProcess& robot : robots_) connect(robot.wire, robot.id);
}

void Fleet::keep(Wire& wire, const PeerId& id, Duration unseen) {
  if (!wire.keeper) return;
  wire.keeper->look(whereabouts(wire), now_, wire.link->bus().counters().received, unseen);
  connect(wire, id);
}

void Fleet::look_at_links() {
  next_look_at_links_ = now_ + kLookAtLinksEvery;
  if (!server_.hung_since) keep(server_.wire, server_.id, {});
  keep(client_.wire, client_.id, {});
  for (RobotProcess& robot : robots_) {
    if (!robot.hung_since) keep(robot.wire, robot.id, {});
  }
}

void Fleet::partition(std::size_t robot, bus::Cut cut) {
  robots_[robot].wire.cut = cut;
  connect(robots_[robot].wire, robots_[robot].id);
}

void Fleet::move_server() {
  server_.wire.address = next_address();
  connect_all();
}

void Fleet::move_robot(std::size_t robot) {
  robots_[robot].wire.address = next_address();
  connect(robots_[robot].wire, robots_[robot].id);
}

/// Tells the ledger what the robot's disk refused since it was looked at last, and what it holds.
void Fleet::look_at_spool(RobotProcess& robot) {
  const std::uint64_t struck = robot.disk->faults.struck;
  if (std::exchange(robot.struck, struck) != struck) ledger_.spool_struck(robot.id);
  ledger_.look_at_spool(robot.id, *robot.disk, *server_.disk);
}

}  // namespace weft::simulation
