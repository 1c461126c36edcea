#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "idl/bus/link.hpp"
#include "idl/bus/topics.hpp"
#include "tests/idl/examples.hpp"

namespace weft::bus {
namespace {

using testing::HasSubstr;

/// Returns what a reader says to the example of type M after `spoil` has spoiled it.
template <class M>
std::string refusal(const std::function<void(M&)>& spoil) {
  for (Example& example : examples()) {
    auto* const message = std::get_if<M>(&example.message);
    if (message == nullptr) continue;
    spoil(*message);
    const Result<Encoded> encoded = encode(example.message, example.sender);
    if (!encoded) return "not sent: " + encoded.error().message;
    const Result<msg::Message> decoded = decode(encoded->topic, encoded->cdr);
    return decoded ? "accepted" : decoded.error().message;
  }
  return "no example";
}
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std::string kLong(5000, 'x');

TEST(FromIdl, NamesMessageFieldAndBound) {
  EXPECT_EQ(refusal<msg::RobotState>([](auto& m) { m.blind_m = -1.0; }),
            "RobotState.blind_m must be finite and not negative");
  EXPECT_EQ(refusal<msg::WindowPatch>([](auto& m) { m.patch.changed[0].robot = {}; }),
            "WindowPatch.changed[0].robot must not be none");
  EXPECT_EQ(refusal<msg::QueryReply>([](auto& m) { m.robots[0].state.name = kLong; }),
            "QueryReply.robots[0].state.name is longer than 64 bytes");
}

TEST(FromIdl, RefusesNumbersThatAreNone) {
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { m.speed_m_s = kNan; }), HasSubstr("speed_m_s must be finite"));
  EXPECT_THAT(refusal<msg::AgentCommand>([](auto& m) { m.along[1].y = INFINITY; }),
              HasSubstr("along.y must be finite"));
  EXPECT_THAT(refusal<msg::RobotDescription>([](auto& m) { m.footprint_radius_m = 0.0; }),
              HasSubstr("footprint_radius_m must be above 0"));
  EXPECT_THAT(refusal<msg::QueryReply>([](auto& m) { m.robots[0].clock_skew_s = kNan; }), HasSubstr("clock_skew_s"));
}

TEST(FromIdl, RefusesRelationsThatAreNone) {
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { std::get<Metric2>(m.place_from_robot).a_from_b.x = kNan; }),
              HasSubstr("RobotState.place_from_robot.relation"));
  EXPECT_THAT(
      refusal<msg::WindowPatch>([](auto& m) { std::get<Metric2>(m.patch.edges[0].a_from_b).covariance(0, 0) = -1; }),
      HasSubstr("WindowPatch.edges[0].a_from_b.relation"));
  EXPECT_THAT(refusal<msg::RouteOrder>(
                  [](auto& m) { std::get<Metric3>(m.route.relations[1]).a_from_b.rotation.coeffs() *= 2.0; }),
              HasSubstr("RouteOrder.route.relations[1].relation"));
}

TEST(FromIdl, RefusesValuesOutsideTheirEnumeration) {
  EXPECT_THAT(refusal<msg::Hello>([](auto& m) { m.role = msg::Role{9}; }),
              HasSubstr("Hello.role must be from 1 to 3"));
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { m.mode = msg::RobotMode{0}; }),
              HasSubstr("mode must be from 1 to 8"));
  EXPECT_THAT(refusal<msg::WindowPatch>([](auto& m) { m.patch.edges[0].origin = Origin{4}; }), HasSubstr("origin"));
  EXPECT_THAT(refusal<msg::Chunk>([](auto& m) { m.coding = msg::Coding{3}; }),
              HasSubstr("coding must be from 0 to 2"));
  EXPECT_THAT(refusal<msg::Query>([](auto& m) { m.kind = msg::Query::Kind{77}; }),
              HasSubstr("kind must be from 1 to 10"));
}

TEST(FromIdl, RefusesMissingIdentities) {
  EXPECT_THAT(refusal<msg::Hello>([](auto& m) { m.peer = {}; }), HasSubstr("Hello.peer must not be none"));
  EXPECT_THAT(refusal<msg::AgentReply>([](auto& m) { m.header.sender = {}; }),
              HasSubstr("header.sender must not be none"));
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { m.place = {}; }),
              HasSubstr("place must not be none when localised"));
  EXPECT_THAT(refusal<msg::BatchAck>([](auto& m) { m.to = {}; }), HasSubstr("needs an addressee"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.places[2] = {}; }),
              HasSubstr("route.places must not be none"));
  EXPECT_THAT(refusal<msg::ExperienceBatch>([](auto& m) { m.batch.robot.bytes.fill(9); }),
              HasSubstr("robot must be the sender"));
}

TEST(FromIdl, RefusesChunksOutsideTheirContent) {
  EXPECT_THAT(refusal<msg::Chunk>([](auto& m) { m.offset = m.total; }), HasSubstr("must end within total"));
  EXPECT_THAT(refusal<msg::Chunk>([](auto& m) { m.offset = ~0ULL - 2; }), HasSubstr("must end within total"));
  EXPECT_THAT(refusal<msg::Chunk>([](auto& m) { m.total = msg::kContentBytes + 1; }),
              HasSubstr("total must be at most"));
  EXPECT_THAT(refusal<msg::Chunk>([](auto& m) {
                m.data.resize(msg::kChunkBytes + 1);
                m.total = 2 * m.data.size();
              }),
              HasSubstr("data must be at most 65536 bytes"));
}

TEST(FromIdl, RefusesListsAndNumbersOutOfBounds) {
  EXPECT_THAT(refusal<msg::Hello>([](auto& m) { m.protocol_min = 3; }), HasSubstr("protocol_max must be at least"));
  EXPECT_THAT(refusal<msg::WindowRequest>([](auto& m) { m.definition.cap = 0; }), HasSubstr("cap must be from 1"));
  EXPECT_THAT(refusal<msg::WindowPatch>([](auto& m) { m.part = m.parts; }), HasSubstr("part must be below parts"));
  EXPECT_THAT(refusal<msg::WindowPatch>([](auto& m) { m.patch.removed.resize(501, m.patch.removed[0]); }),
              HasSubstr("must be at most 500 together"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.relations.pop_back(); }),
              HasSubstr("one fewer than places"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.released = 4; }),
              HasSubstr("released must be the index"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.limits[1].to = 4; }),
              HasSubstr("route.limits must be of places of the route"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.limits[0].from = m.route.limits[0].to = 2; }),
              HasSubstr("route.limits must be in the order"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.limits[1].from = 9; }),
              HasSubstr("limits[1].last must not be before first"));
  EXPECT_THAT(refusal<msg::RouteOrder>([](auto& m) { m.route.limits[1].limit_m_s = 0.0; }),
              HasSubstr("limit_m_s must be above 0"));
  EXPECT_THAT(refusal<msg::RobotPower>([](auto& m) { m.share = 1.5; }), HasSubstr("share must be from 0 to 1"));
  EXPECT_THAT(refusal<msg::RobotPower>([](auto& m) { m.minutes = -1.0; }), HasSubstr("minutes must be finite"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.priority = 10; }),
              HasSubstr("priority must be at most 9"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.within_m = 1001.0; }),
              HasSubstr("rule.within_m must be at most 1000"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.kind = RuleKind{9}; }),
              HasSubstr("rule.kind must be from 1 to 8"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.area->corners.pop_back(); }),
              HasSubstr("rule.area.corners must be 3 or more"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.area->corners.resize(101); }),
              HasSubstr("rule.area.corners has more than 100 entries"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.area->corners[1].y() = std::nan(""); }),
              HasSubstr("rule.area.corners[1] must be finite"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.rule.area->plan = std::string(65, 'a'); }),
              HasSubstr("rule.area.plan"));
  EXPECT_THAT(refusal<msg::ExperienceBatch>([](auto& m) { m.batch.sequence = 0; }), HasSubstr("at least 1"));
  EXPECT_THAT(refusal<msg::Query>([](auto& m) { m.header.signature.resize(65); }), HasSubstr("more than 64 entries"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.work.what.places[0].last = 2; }),
              HasSubstr("work.places[0].last must not be before first"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.work.what.places[0].experience = {}; }),
              HasSubstr("experience must not be none"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.work.within_m = std::nan(""); }),
              HasSubstr("work.within_m must be finite"));
  EXPECT_THAT(refusal<msg::OperatorRequest>([](auto& m) { m.work.within_rad = 4.0; }), HasSubstr("at most pi"));
  EXPECT_THAT(refusal<msg::OperatorReply>([](auto& m) { m.outcome = msg::Outcome{6}; }),
              HasSubstr("outcome must be from 1 to 5"));
  EXPECT_THAT(refusal<msg::ContentRequest>([](auto& m) { m.items.resize(4097, m.items[0]); }),
              HasSubstr("more than 4096 entries"));
}

TEST(FromIdl, RefusesSignaturesThatAreNone) {
  EXPECT_EQ(refusal<msg::Recognise>([](auto& m) { m.seen.clear(); }), "Recognise.seen must have at least 1 number");
  EXPECT_EQ(refusal<msg::Recognise>([](auto& m) { m.seen[3] = std::numeric_limits<float>::infinity(); }),
            "Recognise.seen must be finite");
  EXPECT_THAT(refusal<msg::Recognise>([](auto& m) { m.seen.resize(msg::kSignatureNumbers + 1, 0.0F); }),
              HasSubstr("seen has more than 1024 entries"));
  EXPECT_THAT(refusal<msg::Recognise>([](auto& m) { m.most = 0; }), HasSubstr("most must be from 1 to 200"));
  EXPECT_THAT(refusal<msg::Recognise>([](auto& m) { m.most = 201; }), HasSubstr("most must be from 1 to 200"));
  EXPECT_THAT(refusal<msg::Recognise>([](auto& m) { m.after = 10'001; }), HasSubstr("after must be at most 10000"));
  EXPECT_THAT(refusal<msg::Recognise>([](auto& m) { m.method = std::string(65, 'x'); }), HasSubstr("method"));
}

TEST(FromIdl, RefusesProposalsOutOfBounds) {
  EXPECT_THAT(refusal<msg::Recognised>([](auto& m) { m.places[1] = {}; }), HasSubstr("places must not be none"));
  EXPECT_THAT(refusal<msg::Recognised>([](auto& m) { m.places.resize(msg::kRecognisedPlaces + 1, m.places[0]); }),
              HasSubstr("places has more than 200 entries"));
  EXPECT_THAT(refusal<msg::Recognised>([](auto& m) { m.outcome = msg::Outcome::under_way; }),
              HasSubstr("outcome must be from 1 to 4"));
}

TEST(FromIdl, RefusesDiagnosticsOutOfBounds) {
  EXPECT_EQ(refusal<msg::RobotState>([](auto& m) { m.diagnostics[1].sigma = -0.1; }),
            "RobotState.diagnostics[1].sigma must be finite and not negative");
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { m.diagnostics[0].bound = kNan; }),
              HasSubstr("diagnostics[0].bound must be finite"));
  EXPECT_THAT(refusal<msg::RobotState>([](auto& m) { m.diagnostics.resize(17, m.diagnostics[0]); }),
              HasSubstr("diagnostics has more than 16 entries"));
}

TEST(FromIdl, RefusesReportsOutOfBounds) {
  EXPECT_EQ(refusal<msg::AgentReply>([](auto& m) { m.report[1].found[2].value = 1.01; }),
            "AgentReply.report[1].found[2].value must be from 0 to 1");
  EXPECT_THAT(refusal<msg::AgentReply>([](auto& m) { m.report[0].found[0].value = kNan; }),
              HasSubstr("found[0].value must be finite"));
  EXPECT_THAT(refusal<msg::AgentReply>([](auto& m) { m.report[0].found.resize(5, m.report[0].found[0]); }),
              HasSubstr("found has more than 4 entries"));
  EXPECT_THAT(refusal<msg::AgentReply>([](auto& m) { m.report[0].first = {}; }), HasSubstr("first must not be none"));
  EXPECT_THAT(refusal<msg::AgentReply>([](auto& m) { m.counts.resize(1001, m.counts[0]); }),
              HasSubstr("counts has more than 1000 entries"));
  EXPECT_THAT(refusal<msg::OperatorReply>([](auto& m) { m.report[1].to_m = 9.0; }),
              HasSubstr("to_m must not be before from_m"));
  EXPECT_THAT(refusal<msg::OperatorReply>([](auto& m) { m.report[1].sigma_m = -0.1; }), HasSubstr("sigma_m"));
  EXPECT_THAT(refusal<msg::OperatorReply>([](auto& m) { m.report.resize(1001, m.report[0]); }),
              HasSubstr("report has more than 1000 entries"));
}

TEST(Encode, RefusesWhatTheTopicDoesNotTake) {
  EXPECT_THAT(refusal<msg::Query>([](auto& m) { m.robot = kLong; }),
              HasSubstr("not sent: weft/1/query: a message of"));
  const Result<Encoded> wrong_role = encode(msg::BatchAck{}, msg::Role::agent);
  ASSERT_FALSE(wrong_role);
  EXPECT_EQ(wrong_role.error().message, "weft/1/batch_ack is not written by this role");
}

TEST(Decode, RefusesATopicThatDoesNotExist) {
  const Result<msg::Message> decoded = decode(TopicId{kTopics}, Bytes(4));
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().message, "topic " + std::to_string(kTopics) + " does not exist");
}

// A robot is known by its hello before it has described itself: its row is still an answer.
TEST(FromIdl, RowsMayLackWhatHasNotComeYet) {
  EXPECT_EQ(refusal<msg::QueryReply>([](auto& m) {
              m.robots[0].description = {};
              m.robots[0].state = {};
            }),
            "accepted");
}

}  // namespace
}  // namespace weft::bus
