#include <limits>
#include <stdexcept>

#include "tests/simulation/fleet.hpp"

namespace weft::simulation {

void Fleet::hang_server(bool hangs) {
  if (!server_.service || hangs == server_.hung_since.has_value()) return;
  if (hangs) {
    server_.hung_since = now_;
    return;
  }
  const Duration away = now_ - *server_.hung_since;
  server_.hung_since.reset();
  ledger_.server_up(now_);
  server_.service->was_away(away, server_now());
  while (const auto message = server_.wire.link->take()) {
    ledger_.server_heard(*message);
    send_all(server_.service->handle(*message, server_now()));
  }
  const std::vector<msg::Message> said = server_.service->tick(server_now());
  ledger_.server_woke(said);
  send_all(said);
  note_wake();
  keep(server_.wire, server_.id, away);
}

void Fleet::hang_robot(std::size_t index, bool hangs) {
  RobotProcess& robot = robots_[index];
  if (!robot.agent || hangs == robot.hung_since.has_value()) return;
  if (hangs) {
    robot.hung_since = now_;
    ledger_.robots.at(robot.id).is_hung = true;
    return;
  }
  ledger_.robots.at(robot.id).is_hung = false;
  // The body was driven by the same process, or has stopped by itself when nobody spoke to it.
  robot.due = now_;
  const Duration away = now_ - *robot.hung_since;
  robot.agent->was_away(away, clock(robot));
  robot.hung_since.reset();
  note_wake(robot);
  keep(robot.wire, robot.id, away);
}

void Fleet::stray_server(bool speaks) {
  if (!speaks) return stray_.reset();
  const PeerId id = draw_id();
  stray_ = std::make_unique<bus::Link>(net_.attach(msg::Role::server, id));
  msg::Hello hello;
  hello.peer = id;
  hello.incarnation = random_.next();
  hello.role = msg::Role::server;
  hello.epoch = Epoch{std::numeric_limits<std::uint64_t>::max()};
  record(hello);
  if (const auto sent = stray_->send(hello); !sent) throw std::runtime_error(sent.error().message);
}

}  // namespace weft::simulation
