#pragma once
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "agents/agent/agent.hpp"
#include "core/random.hpp"
#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/link.hpp"
#include "server/service.hpp"
#include "storage/memory/memory_store.hpp"
#include "storage/spool/memory_spool.hpp"
#include "tests/simulation/ledger.hpp"
#include "tests/simulation/link_keeper.hpp"
#include "tests/simulation/marks_body.hpp"
#include "tests/simulation/site.hpp"

namespace weft::simulation {

/// Tells how the fleet comes to its map.
enum class MapFrom : std::uint8_t {
  taught,  ///< robots teach a named site, nobody knows anything at first
  stored   ///< a large site is in the store already; robots stand on it and have to be told where
};

struct FleetConfig {
  std::string site = "ring";  ///< one of site_names(); stored: "aisles"
  std::uint64_t seed = 1;
  std::size_t robots = 4;
  MapFrom map = MapFrom::taught;
  bool checks_waits = false;     ///< whether the server has to say why each robot stands that has a goal
  std::set<std::string> told{};  ///< invariants that are told when they break, and end nothing
};

/// Runs server, robots and one client in one thread, on a simulated network and clock. Each process can be crashed at
/// any moment and started again on what its disk holds; each has clocks of its own.
class Fleet {
 public:
  explicit Fleet(const FleetConfig& config);

  SteadyTime now() const { return now_; }
  /// Plays everything due up to `until`.
  void run_until(SteadyTime until);

  void crash_server();
  void start_server();
  bool server_up() const { return server_.service != nullptr; }
  void crash_robot(std::size_t robot);
  /// Starts the robot's agent. Its spool may refuse, on a full disk: then it stays down.
  void start_robot(std::size_t robot);
  bool robot_up(std::size_t robot) const { return robots_[robot].agent != nullptr; }
  std::size_t robots() const { return robots_.size(); }
  /// Returns whether the robot refines what it was taught before it hands that in.
  static bool refines(std::size_t robot) { return robot % 2 == 1; }
  void partition(std::size_t robot, bus::Cut cut);
  /// Gives the server's machine, or a robot's, another address. Who spoke with it has to find it again.
  void move_server();
  void move_robot(std::size_t robot);
  /// Makes the server stand still, or go on. It hears nothing until it goes on; what is sent to it waits.
  void hang_server(bool hangs);
  void hang_robot(std::size_t robot, bool hangs);
  /// Lets a stranger say once that it is the server, in the highest epoch, and answer nothing; false: takes it away.
  void stray_server(bool speaks);
  void set_faults(const bus::Faults& faults) { net_.set_faults(faults); }
  storage::MemoryDisk& disk() { return *server_.disk; }
  storage::SpoolDisk& spool_disk(std::size_t robot) { return *robots_[robot].disk; }

  void send(msg::OperatorRequest request);
  void send(msg::Query query);
  /// Returns the answers that the client has had since the last call.
  std::vector<msg::OperatorReply> take_replies();
  std::vector<msg::QueryReply> take_answers();

  const Site& site() const { return *site_; }
  /// Leads the robot along a line without teaching it; how far it is, `body` tells. False: too far from the line.
  bool take_by_hand(std::size_t robot, const std::vector<agents::SitePoint>& along);
  void let_go(std::size_t robot) { robots_[robot].body->stop_hand(); }
  /// Has the robot's base stop it by its own safety, or let it go on.
  void press(std::size_t robot, Safety safety) { robots_[robot].body->press(safety); }
  /// Puts a crate in the way of one robot, or takes it away; others do not meet it.
  void put_crate(std::size_t robot, const Eigen::Vector2d& crate_in_site) {
    robots_[robot].body->put_crate(crate_in_site);
  }
  void take_crate(std::size_t robot) { robots_[robot].body->take_crate(); }
  /// Gives the robot a battery; without one it says nothing of its charge.
  void equip(std::size_t robot, agents::Battery battery) { robots_[robot].body->equip(std::move(battery)); }
  const MarksBody& body(std::size_t robot) const { return *robots_[robot].body; }
  const msg::RobotState& state(std::size_t robot) const { return ledger_.robots.at(robots_[robot].id).state; }
  const RobotId& id_of(std::size_t robot) const { return robots_[robot].id; }
  const std::string& name(std::size_t robot) const { return robots_[robot].name; }

  Ledger& ledger() { return ledger_; }
  /// Returns a few places in a row of an experience that has ended, as the map has it; none while the server is down.
  Removal some_places(Random& random) const;
  void look_when_quiet();
  /// Returns how often robots were asked to make way, and standstills ended.
  std::uint64_t ways_made() const;
  /// Returns the server's events, a line each, then how every goal and robot stands: for people who look into a
  /// failure.
  std::vector<std::string> diary() const;
  /// Returns a hash over every message of the run, in order: the same seed gives the same.
  std::string trace() const;
  std::uint64_t messages() const { return messages_; }

 private:
  /// Joins a process to the network.
  struct Wire {
    std::unique_ptr<bus::Link> link;
    std::optional<LinkKeeper> keeper;
    std::string address;            ///< of its machine
    bus::Cut cut = bus::Cut::none;  ///< as faults have it
  };
  struct ServerProcess {
    PeerId id;
    std::shared_ptr<storage::MemoryDisk> disk;
    std::unique_ptr<storage::MapStore> store;
    Wire wire;
    std::unique_ptr<server::Service> service;
    SteadyTime wakes = SteadyTime::max();  ///< its next tick is due
    std::optional<SteadyTime> hung_since;
    Duration steady_offset{};
    Duration wall_offset{};
  };
  struct RobotProcess {
    PeerId id;
    std::string name;
    std::unique_ptr<MarksBody> body;
    std::shared_ptr<storage::SpoolDisk> disk;
    std::unique_ptr<storage::Spool> spool;
    Wire wire;
    std::uint64_t struck = 0;  ///< writes to its disk that had failed when last looked at
    std::unique_ptr<agents::Agent> agent;
    agents::Twist command;
    std::optional<agents::Sample> next;  ///< due at `due`
    SteadyTime due{};
    SteadyTime wakes = SteadyTime::max();  ///< its agent's next tick is due
    std::optional<SteadyTime> hung_since;
    Duration steady_offset{};
    Duration wall_offset{};
  };
  struct ClientProcess {
    PeerId id;
    Wire wire;
    std::uint64_t incarnation = 0;
    std::uint64_t sequence = 0;
    std::vector<msg::OperatorReply> replies;
    std::vector<msg::QueryReply> answers;
  };

  void open(Wire& wire, msg::Role role, const PeerId& id);
  void close(Wire& wire, const PeerId& id);
  Whereabouts whereabouts(const Wire& wire) const;
  void keep(Wire& wire, const PeerId& id, Duration unseen);
  void connect(Wire& wire, const PeerId& id);
  void connect_all();
  void look_at_links();
  std::string next_address() { return "machine " + std::to_string(++addresses_); }
  void look_at_spool(RobotProcess& robot);
  SteadyTime next_event() const;
  // These look when the next tick is due, after everything that may have changed it: that is too dear for each event.
  void note_wake();
  void note_wake(RobotProcess& robot);
  void play(SteadyTime at);
  void look();
  std::vector<msg::RobotRow> robot_rows();
  void store_map(std::size_t robots);
  void serve();
  void serve(RobotProcess& robot);
  void sample(RobotProcess& robot);
  void carry_out(RobotProcess& robot, agents::AgentOutput output);
  void send_all(const std::vector<msg::Message>& messages);
  template <class Asked>
  void send_as_client(Asked asked);
  void hear_client();
  void record(const msg::Message& message);
  SteadyTime clock(const RobotProcess& robot) const { return now_ + robot.steady_offset; }
  WallTime wall(Duration offset) const { return WallTime(now_.time_since_epoch() + offset); }
  server::Now server_now() const { return {now_ + server_.steady_offset, wall(server_.wall_offset)}; }
  PeerId draw_id();

  Random random_;
  SteadyTime now_{};
  std::shared_ptr<const Site> site_;
  bus::InProcessNet net_;
  Ledger ledger_;
  ServerProcess server_;
  std::vector<RobotProcess> robots_;
  ClientProcess client_;
  std::unique_ptr<bus::Link> stray_;
  SteadyTime next_look_{};
  bool checks_waits_ = false;
  SteadyTime next_look_at_traffic_{};
  SteadyTime next_look_at_links_{};
  std::uint64_t addresses_ = 0;
  std::uint64_t trace_ = 1469598103934665603ULL;
  std::uint64_t messages_ = 0;
};

}  // namespace weft::simulation
