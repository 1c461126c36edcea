#include "tests/idl/examples.hpp"

#include <cmath>

namespace weft::bus {
namespace {

/// Returns an id of bytes that count up from `first`.
template <class Id>
Id id_of(std::uint8_t first) {
  Id id;
  for (std::uint8_t& byte : id.bytes) byte = first++;
  return id;
}

PlaceId place_id(std::uint64_t experience, std::uint32_t index) {
  return {ExperienceId{experience}, index};
}

msg::Header header() {
  return {id_of<PeerId>(0x10), 0x1122334455667788, Epoch{7}, 42, {0xaa, 0xbb, 0xcc}};
}

Relation metric2() {
  Metric2 relation{{1.5, -0.25, 0.5}, Eigen::Matrix3d::Identity() * 0.01};
  relation.covariance(0, 1) = relation.covariance(1, 0) = 0.002;
  return relation;
}

Relation metric3() {
  Metric3 relation;
  relation.a_from_b.rotation = Eigen::Quaterniond(0.8, 0.0, 0.0, 0.6);
  relation.a_from_b.translation = {1.0, 2.0, 3.0};
  relation.covariance = Matrix6d::Identity() * 0.25;
  return relation;
}

Place place(std::uint32_t index) {
  return {place_id(0xabcdef, index),
          3,
          "floor",
          2,
          {id_of<ContentHash>(0x40), 123456},
          id_of<RobotId>(0x10),
          900 + index,
          SensorTime(Duration(5'000'000'123))};
}

Edge edge(const Relation& relation, Origin origin) {
  return {{place_id(0xabcdef, 1), place_id(0xfedcba, 2)}, 4, 87, 0.75F, origin, Drivable::both, relation, "floor"};
}

Route route() {
  Route made;
  made.goal = id_of<GoalId>(0x60);
  made.id = id_of<RouteId>(0x70);
  made.version = 3;
  made.made_of = Revision{99};
  made.robot = id_of<RobotId>(0x10);
  made.places = {place_id(1, 5), place_id(1, 6), place_id(2, 0), place_id(2, 1)};
  made.relations = {metric2(), metric3(), AlongPath{2.0, 0.5, -0.1, 0.02}};
  made.released = 2;
  made.limits = {{0, 1, 0.5}, {1, 3, 0.25}};
  made.reason = "waits for r2 at 0000000000000002:1";
  return made;
}

msg::RobotDescription description() {
  return {
      header(), "r1", "sim", {"floor", "marks"}, 0.35, true, {{"down", 752, 480, "f = 460"}, {"front", 640, 400, ""}},
      true};
}

msg::RobotState state() {
  msg::RobotState made;
  made.header = header();
  made.name = "r1";
  made.mode = msg::RobotMode::driving;
  made.localised = true;
  made.place = place_id(0xabcdef, 17);
  made.place_from_robot = metric2();
  made.blind_m = 0.125;
  made.speed_m_s = 0.5;
  made.frame = 4711;
  made.experience = ExperienceId{0xabcdef};
  made.goal = id_of<GoalId>(0x60);
  made.route = id_of<RouteId>(0x70);
  made.route_version = 3;
  made.window_revision = Revision{98};
  made.window_digest = id_of<Digest>(0x80);
  made.contents_missing = 12;
  made.memory_bytes = 5'000'000;
  made.memory_cap_bytes = 64'000'000;
  made.diagnostics = {{"mount_pitch_rad", 0.0078125, 0.0009765625, 0.0}, {"height_offset_m", -0.0078125, 0.0, 0.007}};
  made.safety = Safety::protective_stop;
  made.spool_batches = 6;
  made.spool_free_bytes = 7'000'000'000;
  made.server_unheard_s = 1.25;
  made.server_gap_s = 13.5;
  made.reason = "window is incomplete";
  made.spool_refuses = "the disk is full";
  return made;
}

msg::RobotPower power() {
  return {header(), 0.75, true, 42.5};
}

Rule rule() {
  return {"dock-slow",
          RuleKind::speed,
          0.25,
          true,
          {{place_id(1, 5), place_id(1, 9)}, {place_id(1, 5), place_id(2, 0)}},
          "dock",
          3.5,
          Area{"hall", id_of<ContentHash>(0x90), {{0.5, -1.5}, {12.5, 3.25}, {0.25, 8.0}}}};
}

Registration registration() {
  return {"hall", id_of<ContentHash>(0x90), {{"dock", place_id(1, 5), {0.25, -0.5}, {12.5, 3.25}, 0.125, 1.5}}};
}

msg::Event event() {
  return {WallTime(Duration(1'700'000'000'000'000'001)),
          "goal.assigned",
          id_of<RobotId>(0x10),
          id_of<GoalId>(0x60),
          "shortest route",
          "dispatcher",
          4711};
}

Goal goal() {
  Goal made;
  made.id = id_of<GoalId>(0x60);
  made.label = "dock";
  made.to = place_id(2, 1);
  made.wanted = id_of<RobotId>(0x10);
  made.robot = id_of<RobotId>(0x10);
  made.state = GoalState::executing;
  made.number = 5;
  made.route = id_of<RouteId>(0x70);
  made.route_version = 3;
  made.priority = 7;
  made.kind = GoalKind::yield;
  made.no_return = true;
  made.history = {{WallTime(Duration(10)), GoalState::pending, "asked for", "alice"},
                  {WallTime(Duration(20)), GoalState::executing, "route accepted", "r1"}};
  return made;
}

msg::WindowPatch patch() {
  msg::WindowPatch made{header(), example_addressee(), 77, 1, 3, {}};
  made.patch.base = Revision{90};
  made.patch.target = Revision{99};
  made.patch.added = {place(1), place(2)};
  made.patch.changed = {place(3)};
  made.patch.removed = {place_id(9, 9)};
  made.patch.edges = {edge(metric2(), Origin::stitch), edge(metric3(), Origin::blind)};
  made.patch.edges_removed = {{place_id(9, 8), place_id(9, 9)}};
  made.patch.labels = {{"dock", place_id(2, 1)}, {"gate", place_id(1, 5)}};
  made.patch.labels_removed = {"old"};
  made.patch.digest = id_of<Digest>(0x80);
  return made;
}

std::vector<Diagnostic> shares(double as_is, double half_light, double worn) {
  return {{"as_is", as_is, 0.0625, 0.5}, {"half_light", half_light, 0.125, 0.5}, {"worn", worn, 0.125, 0.5}};
}

std::vector<msg::TaughtStretch> report() {
  return {{0.0, 9.75, 48, place_id(0xabcdef, 0), shares(1.0, 0.875, 0.75), 0.004, "few_inliers"},
          {9.75, 20.0, 51, place_id(0xabcdef, 48), shares(0.5, 0.25, 0.0), 0.02, ""}};
}

msg::QueryReply query_reply() {
  msg::QueryReply made;
  made.header = header();
  made.to = example_addressee();
  made.request = 31;
  made.part = 0;
  made.parts = 2;
  made.robots = {{description(),
                  state(),
                  0.5,
                  true,
                  "cyclonedds",
                  "0.1.0",
                  -0.001,
                  "0000000000000001:5 to 0000000000000002:0",
                  70'000,
                  4'000'000,
                  9'000,
                  45,
                  msg::RobotWait{place_id(0xabcdef, 0),
                                 place_id(0xabcdef, 2),
                                 {example_addressee()},
                                 WallTime(std::chrono::seconds(1'700'000'100)),
                                 "dock-shut"},
                  "r1 and r2 wait for one another",
                  power(),
                  "anna",
                  "hall",
                  {3.5, -2.25, 0.75},
                  true,
                  true,
                  true}};
  made.goals = {goal()};
  made.routes = {route()};
  made.events = {event()};
  made.oldest_event = 17;
  made.newest_event = 4712;
  made.alarms = {{msg::AlarmKind::clock, id_of<RobotId>(0x10), "r1", place_id(0xabcdef, 3),
                  WallTime(std::chrono::seconds(1'700'000'200)), "3000 ms ahead"}};
  made.log = {
      {Revision{9}, Revision{4}, WallTime(std::chrono::seconds(1'700'000'000)), "rollback", "anna", "to revision 4"}};
  made.info = {Revision{99},
               Epoch{7},
               2,
               400,
               12,
               380,
               9'000'000,
               55,
               1,
               1ULL << 40U,
               "weft 0.1.0",
               "fastdds",
               "sqlite",
               "disk full",
               "r1 and r2",
               {{"weft/1/query: Query.kind must be from 1 to 6", 2}}};
  made.network.revision = Revision{88};
  made.network.places = {place(1), place(2)};
  made.network.edges = {edge(metric2(), Origin::stitch)};
  made.network.labels = {{"dock", place_id(2, 1)}};
  made.network.aparts = {{{ExperienceId{0xabcdef}, 3, 9}, {ExperienceId{0xfedcba}, 0, 4}}};
  made.network.rules = {rule()};
  made.network.registrations = {registration()};
  made.network.total = 400;
  made.network.is_last = true;
  made.experiences = {{ExperienceId{0xabcdef},
                       "loop",
                       id_of<RobotId>(0x10),
                       "floor",
                       true,
                       180,
                       45.25,
                       WallTime(std::chrono::seconds(1'700'000'000)),
                       {"dock"},
                       {"dock"},
                       {ExperienceId{0xfedcba}},
                       1}};
  made.awaited_labels = {{"dock-2", place_id(3, 7), id_of<RobotId>(0x10), "ann"}};
  made.rules = {{rule(), 37, "no label 'dock'"}};
  made.registrations = {{registration(),
                         {{msg::RegistrationRow::PickState::left_out, 1.125}},
                         812,
                         1000,
                         0.984375,
                         0.03125,
                         "held by one pick",
                         "the picks lie within 1 m"}};
  made.arrivals = {{id_of<GoalId>(0x30), 130.5, 110.25, 180.75}};
  made.outcome = msg::Outcome::refused;
  made.message = "the map has no revision 900";
  return made;
}

void add_session(std::vector<Example>& all) {
  using msg::Role;
  all.push_back({"hello", Role::agent,
                 msg::Hello{id_of<PeerId>(0x10),
                            0x1122334455667788,
                            Role::agent,
                            1,
                            2,
                            Epoch{7},
                            "r1",
                            "weft 0.1.0",
                            "fastdds",
                            0x99aabbccddeeff00,
                            {0x0102030405060708, 9}}});
  all.push_back({"robot_description", Role::agent, description()});
  all.push_back({"robot_state", Role::agent, state()});
  all.push_back({"robot_power", Role::agent, power()});
  for (const auto& [name, writer] : {std::pair{"echo_up", Role::client}, std::pair{"echo_down", Role::server}}) {
    const PeerId to = writer == Role::server ? example_addressee() : PeerId{};
    all.push_back({name, writer, msg::Echo{header(), to, 14, 3, {1, 2, 4, 8}}});
  }
  all.push_back({"clock_probe", Role::server,
                 msg::ClockProbe{header(), example_addressee(), 13, WallTime(Duration(1'700'000'000'123'456'789))}});
  all.push_back({"clock_reply", Role::agent,
                 msg::ClockReply{header(), 13, WallTime(Duration(1'700'000'000'123'456'789)),
                                 WallTime(Duration(1'700'000'000'223'456'789)),
                                 WallTime(Duration(1'700'000'000'223'456'999))}});
}

void add_network(std::vector<Example>& all) {
  using msg::Role;
  Batch batch{ExperienceId{0xabcdef},
              8,
              id_of<RobotId>(0x10),
              "loop",
              "floor",
              {place(1), place(2)},
              {},
              {edge(metric2(), Origin::odometry), edge(AlongPath{2.0, 0.5, -0.1, 0.02}, Origin::stitch)},
              true,
              "stopped"};
  all.push_back({"experience_batch", Role::agent, msg::ExperienceBatch{header(), std::move(batch)}});
  all.push_back({"batch_ack", Role::server,
                 msg::BatchAck{header(),
                               example_addressee(),
                               ExperienceId{0xabcdef},
                               7,
                               {id_of<ContentHash>(0x40), id_of<ContentHash>(0x50)},
                               8,
                               "gap after place 12"}});
  const msg::Chunk chunk{
      header(), example_addressee(),  msg::ContentKind::cloud, msg::Coding::zstd, id_of<ContentHash>(0x40), 1000,
      64,       {1, 2, 3, 4, 5, 6, 7}};
  all.push_back({"chunk_up", Role::agent, chunk});
  all.push_back({"chunk_down", Role::server, chunk});
  const msg::ContentRequest request{
      header(), example_addressee(), {{id_of<ContentHash>(0x40), 64}, {id_of<ContentHash>(0x50), 0}}};
  all.push_back({"content_request_up", Role::client, request});
  all.push_back({"content_request_down", Role::server, request});
  all.push_back({"window_request", Role::agent,
                 msg::WindowRequest{header(),
                                    77,
                                    {place_id(0xabcdef, 17), 25, 2000, {place_id(1, 5), place_id(1, 6)}},
                                    Revision{90},
                                    id_of<Digest>(0x80)}});
  all.push_back({"window_patch", Role::server, patch()});
  all.push_back(
      {"recognise", Role::agent, msg::Recognise{header(), 21, "floor", 2, {0.0F, 0.25F, 0.5F, -1.5F}, 64, 128}});
  all.push_back({"recognised", Role::server,
                 msg::Recognised{header(),
                                 example_addressee(),
                                 21,
                                 msg::Outcome::refused,
                                 "this server does not sign for 'floor'",
                                 {place_id(2, 1), place_id(1, 5)},
                                 380,
                                 20}});
}

void add_driving(std::vector<Example>& all) {
  using msg::Role;
  all.push_back({"route_order", Role::server, msg::RouteOrder{header(), example_addressee(), route()}});
  all.push_back({"route_progress", Role::agent,
                 msg::RouteProgress{header(), id_of<GoalId>(0x60), id_of<RouteId>(0x70), 3, msg::RoutePhase::arrived,
                                    3, 2, 3, metric2(), "there"}});
  all.push_back({"agent_command", Role::server,
                 msg::AgentCommand{header(),
                                   example_addressee(),
                                   19,
                                   msg::AgentCommand::Kind::teach_start,
                                   "loop",
                                   place_id(1, 5),
                                   {{0.5, 1.5}, {2.5, -3.5}}}});
  all.push_back({"agent_reply", Role::agent,
                 msg::AgentReply{header(),
                                 19,
                                 true,
                                 "teaching",
                                 place_id(1, 5),
                                 ExperienceId{0xabcdef},
                                 report(),
                                 {{"navigation: fixes", 70}}}});
}

void add_operating(std::vector<Example>& all) {
  using msg::Role;
  all.push_back({"operator_request", Role::client,
                 msg::OperatorRequest{header(),
                                      30,
                                      msg::OperatorRequest::Kind::goal_send,
                                      "anna",
                                      "r1",
                                      "dock",
                                      "dock-1",
                                      place_id(2, 1),
                                      id_of<GoalId>(0x60),
                                      {{0.5, 1.5}},
                                      {Revision{40},
                                       {{{ExperienceId{0xabcdef}, 3, 9}}, {{place_id(1, 5), place_id(2, 0)}}},
                                       true,
                                       0.25,
                                       0.5,
                                       "/var/backups/map.sqlite"},
                                      true,
                                      rule(),
                                      7,
                                      true,
                                      registration(),
                                      msg::PointOnPlan{"hall", {4.5, -6.5}}}});
  all.push_back({"operator_reply", Role::server,
                 msg::OperatorReply{header(),
                                    example_addressee(),
                                    30,
                                    msg::Outcome::refused,
                                    "no label 'dock'",
                                    id_of<GoalId>(0x60),
                                    place_id(2, 1),
                                    ExperienceId{0xabcdef},
                                    Revision{41},
                                    300,
                                    4000,
                                    "rows",
                                    {"content 12ab: checksum differs"},
                                    {{"places", 400}},
                                    report()}});
  all.push_back(
      {"query", Role::client,
       msg::Query{header(), 31, msg::Query::Kind::events, id_of<GoalId>(0x60), "r1", Revision{7}, 20, Revision{90},
                  Revision{88}, place_id(1, 5), "robot.lost", WallTime(std::chrono::seconds(1'700'000'300)), 4700}});
  all.push_back({"query_reply", Role::server, query_reply()});
  all.push_back({"event_note", Role::server, msg::EventNote{header(), event(), true}});
}

}  // namespace

PeerId example_addressee() {
  return id_of<PeerId>(0xa0);
}

std::vector<Example> examples() {
  std::vector<Example> all;
  add_session(all);
  add_network(all);
  add_driving(all);
  add_operating(all);
  return all;
}

}  // namespace weft::bus
