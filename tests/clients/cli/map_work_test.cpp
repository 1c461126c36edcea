#include <gtest/gtest.h>

#include "clients/cli/progress.hpp"
#include "tests/clients/cli/fleet.hpp"

/// Tests edits of the map and upkeep of the store, as an operator asks for them.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

std::uint64_t places(Fleet& fleet) {
  return fleet.weft({"map", "info", "--json"}).json()["places"];
}

TEST(MapUndo, TakesAnExperienceOutAndBack) {
  Fleet fleet;
  const std::uint64_t all = places(fleet);
  const std::string experience = to_string(fleet.second);
  const Said dry = fleet.weft({"map", "undo", experience, "--dry-run"});
  EXPECT_EQ(dry.exit, Exit::done) << dry.err;
  EXPECT_NE(dry.out.find("nothing was changed"), std::string::npos) << dry.out;
  EXPECT_EQ(places(fleet), all);
  const auto undone = fleet.weft({"map", "undo", experience, "--json"}).json();
  EXPECT_LT(places(fleet), all);
  const auto log = fleet.weft({"map", "log", "--json", "--most", "1"}).json()["revisions"];
  EXPECT_EQ(log[0]["kind"], "undo");
  EXPECT_EQ(log[0]["who"], "tester");
  EXPECT_EQ(log[0]["revision"], undone["revision"]);
  const std::string revision = std::to_string(undone["revision"].get<std::uint64_t>());
  const Said back = fleet.weft({"map", "undo", "--revision", revision});
  EXPECT_EQ(back.exit, Exit::done) << back.err;
  EXPECT_EQ(places(fleet), all);
  EXPECT_EQ(fleet.weft({"map", "undo", "--revision", revision}).exit, Exit::refused);
}

TEST(MapUndo, NamesWhatItCannotRead) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "undo"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "undo", "a:b-c:d"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "undo", to_string(fleet.first) + ":9..3"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "undo", "nowhere"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"map", "undo", "x", "--revision", "3"}).exit, Exit::usage) << "one of both";
}

TEST(MapQuarantine, TakesPlacesAndStitchesByTheirIds) {
  Fleet fleet;
  const std::uint64_t all = places(fleet);
  const std::string experience = to_string(fleet.first);
  EXPECT_EQ(fleet.weft({"map", "quarantine", experience + ":3..5"}).exit, Exit::done);
  EXPECT_EQ(places(fleet), all - 3);
  EXPECT_EQ(fleet.weft({"map", "quarantine", experience + ":6"}).exit, Exit::done);
  EXPECT_EQ(places(fleet), all - 4);
  const Edge stitch = fleet.service->snapshot().experience(fleet.second)->stitches[0];
  const Said said = fleet.weft({"map", "undo", to_string(stitch.id.a) + "-" + to_string(stitch.id.b)});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(said.out.find("1 stitch out of the map"), std::string::npos) << said.out;
}

TEST(MapRollback, IsARevisionOfItsOwn) {
  Fleet fleet;
  const std::uint64_t all = places(fleet);
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  fleet.weft({"map", "undo", to_string(fleet.second)});
  const Said said = fleet.weft({"map", "rollback", std::to_string(before)});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(places(fleet), all);
  EXPECT_EQ(fleet.weft({"map", "rollback", "900"}).exit, Exit::refused);
}

TEST(MapPrune, SaysFirstAndDoesItWhenApplied) {
  Fleet fleet;
  const std::uint64_t all = places(fleet);
  const Said said = fleet.weft({"map", "prune", "--within", "0.6"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(places(fleet), all);
  EXPECT_EQ(fleet.weft({"map", "prune", "--within", "0.6", "--apply"}).exit, Exit::done);
  EXPECT_LE(places(fleet), all);
  EXPECT_EQ(fleet.weft({"map", "prune", "--within", "99"}).exit, Exit::usage);
}

TEST(MapCheck, SaysThatAllIsWell) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "check"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(fleet.weft({"map", "check", "--json"}).json()["counts"]["findings"], 0);
}

TEST(MapStats, HasARowForEachKind) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "stats"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_NE(said.out.find("AS HANDED IN"), std::string::npos) << said.out;
  const auto counts = fleet.weft({"map", "stats", "--json"}).json()["counts"];
  EXPECT_GT(counts["contents: bytes as handed in"], 0) << counts.dump();
}

TEST(MapCompact, LeavesNoWayBackAndSaysSo) {
  Fleet fleet;
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  fleet.weft({"map", "undo", to_string(fleet.second)});
  const std::string now = std::to_string(before + 1);
  const Said said = fleet.weft({"map", "compact", "--before", now});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  const Said back = fleet.weft({"map", "rollback", std::to_string(before)});
  EXPECT_NE(back.exit, Exit::done) << back.out;
  EXPECT_NE(back.err.find("older than what is kept"), std::string::npos) << back.err;
}

TEST(MapApart, IsListedLoggedComparedAndUndone) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "apart", "--list"}).out, "no stretches are apart\n");
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  const std::string one = to_string(fleet.first) + ":1..4";
  const std::string other = to_string(fleet.second) + ":2..6";
  const Said dry = fleet.weft({"map", "apart", one, other, "--dry-run"});
  EXPECT_NE(dry.out.find("nothing was changed"), std::string::npos) << dry.err;
  const Said said = fleet.weft({"map", "apart", other, one});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  const auto pair = nlohmann::json::array({one, other});
  EXPECT_EQ(fleet.weft({"map", "apart", "--list", "--json"}).json()["apart"], nlohmann::json::array({pair}));
  EXPECT_EQ(fleet.weft({"map", "apart", "--list"}).out, one + " " + other + "\n");
  EXPECT_EQ(fleet.weft({"map", "log", "--json", "--most", "1"}).json()["revisions"][0]["kind"], "apart");
  const std::string from = std::to_string(before);
  const auto found = fleet.weft({"map", "diff", from, "--json"}).json();
  EXPECT_EQ(found["aparts"]["came"], nlohmann::json::array({one + " " + other}));
  EXPECT_TRUE(found["aparts"]["went"].empty());
  EXPECT_NE(fleet.weft({"map", "diff", from}).out.find("apart: " + one), std::string::npos);
  EXPECT_EQ(fleet.weft({"map", "undo", "--revision", std::to_string(before + 1)}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"map", "apart", "--list"}).out, "no stretches are apart\n");
}

TEST(MapApart, NamesWhatItCannotRead) {
  Fleet fleet;
  const std::string one = to_string(fleet.first) + ":1..4";
  EXPECT_EQ(fleet.weft({"map", "apart"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "apart", one}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "apart", one, one, one}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "apart", one, "nowhere"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "apart", one, to_string(fleet.second) + ":9..3"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "apart", one, one}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"map", "apart", one, to_string(fleet.second) + ":0..900"}).exit, Exit::refused);
}

TEST(MapSnapshot, IsOnTheServersMachine) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "snapshot", "here.sqlite", "--verify"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"map", "snapshot", "here.sqlite"}).exit, Exit::refused);
}

TEST(ProgressLine, SaysCountRateAndWhatRemains) {
  std::ostringstream out;
  SteadyTime now{};
  ProgressLine line(out, [&] { return now; });
  msg::OperatorReply reply;
  reply.done = 100;
  reply.total = 1000;
  reply.unit = "rows";
  reply.findings = {"content 12: checksum differs"};
  line.show(reply);
  EXPECT_EQ(out.str(), "content 12: checksum differs\n") << "found is said at once, progress now and then";
  now += 10s;
  line.show(reply);
  EXPECT_NE(out.str().find("100 of 1000 rows, 10 a second, 90 s remain"), std::string::npos) << out.str();
  line.rest(reply);
  EXPECT_EQ(out.str().find("checksum"), out.str().rfind("checksum")) << "said once";
}

TEST(Robots, ShowWhatTheyWereSentAndHold) {
  Fleet fleet;
  fleet.add_robot("r7");
  fleet.run(2s);
  const auto row = fleet.weft({"robots", "--json"}).json()["robots"][0];
  EXPECT_TRUE(row.contains("window_bytes_sent"));
  EXPECT_TRUE(row.contains("memory_cap_bytes"));
  EXPECT_NE(fleet.weft({"robots"}).out.find("HOLDS"), std::string::npos);
  EXPECT_NE(fleet.weft({"robots"}).out.find("CHARGE"), std::string::npos);
}

}  // namespace
}  // namespace weft::cli::test
