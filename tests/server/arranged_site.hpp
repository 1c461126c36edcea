#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/network/change.hpp"
#include "server/service.hpp"
#include "storage/memory/memory_store.hpp"

/// Holds a server on a disk in memory, driven message by message, with both clocks in the test's hand.
namespace weft::server::test {

using namespace std::chrono_literals;

RobotId robot_id(std::uint8_t number);
GoalId goal_id(std::uint8_t number);

/// Speaks for one peer: stamps its headers.
struct Peer {
  PeerId id;
  std::uint64_t incarnation = 1;
  std::uint64_t sequence = 0;
  std::string name;
  bool knows_limits = false;

  msg::Header header() { return {id, incarnation, {}, ++sequence, {}}; }
};

/// Holds a batch and the bytes of its places' contents.
struct Handed {
  Batch batch;
  std::vector<Bytes> contents;
};

/// Makes a straight run of places, `spacing_m` apart, handed in batch by batch.
class TaughtRun {
 public:
  TaughtRun(const Peer& robot, std::uint64_t experience, double spacing_m = 0.5)
      : robot_(robot.id), experience_{experience}, spacing_m_(spacing_m) {}
  /// Returns the next batch. Each byte is one of `values`: with few of them the contents are stored compressed.
  Handed next(std::uint32_t places, std::size_t content_bytes = 100, std::uint64_t values = 256);
  Handed seal();
  PlaceId place(std::uint32_t index) const { return {experience_, index}; }
  ExperienceId id() const { return experience_; }

 private:
  RobotId robot_;
  ExperienceId experience_;
  double spacing_m_;
  std::uint64_t sequence_ = 0;
  std::uint32_t places_ = 0;
};
/// Returns the edge older_from_newer: `newer` lies at (x, y) of `older`, in metres.
Edge stitch(const PlaceId& older, const PlaceId& newer, double x = 0.0, double y = 0.0);
/// Returns the same with the newer place turned by so much.
Edge turned(Edge stitch, double heading_rad);

class Site {
 public:
  explicit Site(std::shared_ptr<storage::MemoryDisk> disk = std::make_shared<storage::MemoryDisk>(),
                Signers signers = {});

  /// Ends the server at once and starts it again on the same disk.
  void restart();
  void say(const msg::Message& message);
  /// Lets time pass, with every tick in its place.
  void pass(Duration duration);

  // A robot's usual words.
  void hello(Peer& robot);
  /// Says hello, the description, and a state when a place is given.
  void arrive(Peer& robot, const std::optional<PlaceId>& place);
  msg::RobotState state(Peer& robot, const std::optional<PlaceId>& place) const;
  /// Returns the state of a robot that drives a route and is at one of its places.
  msg::RobotState driving(Peer& robot, const Route& route, const PlaceId& place) const;
  /// Says that an operator has stopped the robot there: it makes no way.
  void stand_stopped(Peer& robot, const PlaceId& place);
  /// Says each second, for so many, that the robot stands there.
  void stand(Peer& robot, const PlaceId& place, int seconds);
  void power(Peer& robot, double share, bool is_charging = false);
  void progress(Peer& robot, const Route& route, msg::RoutePhase phase, std::uint32_t freed = 0,
                std::optional<std::uint32_t> at = std::nullopt);
  /// Hands in the batch and all its contents.
  void hand_in(Peer& robot, const Handed& handed);
  void send_batch(Peer& robot, const Batch& batch);
  void send_content(Peer& robot, const Bytes& bytes);
  void label(const std::string& name, const PlaceId& place);

  // An operator's.
  msg::OperatorRequest request(msg::OperatorRequest::Kind kind);
  msg::OperatorReply ask(const msg::OperatorRequest& request);
  msg::OperatorReply send_goal(std::uint8_t number, const std::string& label, const std::string& robot = "");
  msg::OperatorReply put_rule(const Rule& rule);
  msg::QueryReply read(msg::Query::Kind kind);
  /// Returns a robot's row; fails the test when it has none.
  msg::RobotRow row(const std::string& robot);

  const Goal& goal(std::uint8_t number);
  std::vector<Goal> goals_of(GoalKind kind);
  /// Returns the latest cause in a goal's history.
  std::string why(std::uint8_t number) { return goal(number).history.back().cause; }
  /// Returns the route of the latest order since the last `hush`, to whichever robot; throws when there is none.
  Route order() const { return last<msg::RouteOrder>().value().route; }
  /// Returns the latest route since the last `hush` that a robot was ordered to drive, not the end of one.
  std::optional<Route> order_to(const Peer& robot) const;
  std::vector<std::string> events_of(const std::string& kind) const;
  msg::MapInfo info();
  /// Returns how often the server counted that.
  std::uint64_t counted(const std::string& what);

  /// Returns all messages of a kind that were said since the last `hush`.
  template <class M>
  std::vector<M> heard() const {
    std::vector<M> found;
    for (const msg::Message& message : said_) {
      if (const auto* const one = std::get_if<M>(&message)) found.push_back(*one);
    }
    return found;
  }
  template <class M>
  std::optional<M> last() const {
    const std::vector<M> all = heard<M>();
    if (all.empty()) return std::nullopt;
    return all.back();
  }
  void hush() { said_.clear(); }

  std::shared_ptr<storage::MemoryDisk> disk;
  Unjoined unjoined = Unjoined::warn;  ///< from the next restart on
  ChargeLevels charge;                 ///< the same
  Service& service() { return *service_; }
  Now now{.steady = SteadyTime(1000s), .wall = WallTime(5000s)};
  Peer client{.id = robot_id(200), .incarnation = 7, .sequence = 0, .name = "anna"};

 private:
  void start_server();
  void take(std::vector<msg::Message> messages);

  Signers signers_;
  std::unique_ptr<storage::MapStore> store_;
  std::unique_ptr<Service> service_;
  std::vector<msg::Message> said_;
  std::uint64_t starts_ = 0;
  std::uint64_t request_ = 0;
  Goal found_;
};

}  // namespace weft::server::test
