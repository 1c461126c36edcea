#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/clients/cli/fleet.hpp"

/// Tests what was taught and imported, and the labels on it, as an operator sees and changes them.
namespace weft::cli::test {
namespace {

nlohmann::json listed(Fleet& fleet) {
  return fleet.weft({"map", "list", "--json"}).json()["experiences"];
}

const nlohmann::json& one_of(const nlohmann::json& all, const std::string& id) {
  return *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one["id"] == id; });
}

/// Writes two chains of ten places that nothing joins: two experiences of one import. Returns the file.
std::string two_chains() {
  std::string text;
  for (const int first : {0, 100}) {
    for (int i = first; i < first + 9; ++i) {
      text += "EDGE_SE2 " + std::to_string(i) + " " + std::to_string(i + 1) + " 1 0 0 100 0 0 100 0 400\n";
    }
  }
  const std::string file = (folder() / "two-chains.g2o").string();
  std::ofstream(file) << text;
  return file;
}

TEST(MapList, HasEachExperienceWithItsLengthLabelsAndWhatItIsJoinedTo) {
  Fleet fleet;
  const nlohmann::json all = listed(fleet);
  ASSERT_EQ(all.size(), 2U);
  const nlohmann::json& first = one_of(all, to_string(fleet.first));
  const Snapshot map = fleet.service->snapshot();
  EXPECT_EQ(first["places"], map.experience(fleet.first)->places.size());
  EXPECT_GT(first["metres"].get<double>(), 1.0);
  EXPECT_EQ(first["joined"], nlohmann::json::array({to_string(fleet.second)}));
  const ExperienceId labelled = map.labels().at("dock").experience;
  EXPECT_EQ(one_of(all, to_string(labelled))["labels"], nlohmann::json::array({"dock"}));
  const Said said = fleet.weft({"map", "list"});
  EXPECT_NE(said.out.find("JOINED TO"), std::string::npos);
  EXPECT_NE(said.out.find("dock"), std::string::npos);
}

TEST(MapList, NamesLabelsThatWaitForTheirPlace) {
  Fleet fleet;
  Puppet& robot = fleet.add_robot("r1");
  const PlaceId kept{ExperienceId{0xC3}, 2};
  robot.state.mode = msg::RobotMode::teaching;
  robot.how = [&](const msg::AgentCommand&, msg::AgentReply& reply) { reply.place = kept; };
  fleet.run(std::chrono::seconds(3));
  fleet.weft({"map", "label", "here", "--robot", "r1", "gate", "--timeout", "2"});
  const nlohmann::json rows = fleet.weft({"map", "list", "--json"}).json()["awaited_labels"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["label"], "gate");
  EXPECT_EQ(rows[0]["place"], to_string(kept));
  EXPECT_EQ(rows[0]["robot"], "r1");
  const Said said = fleet.weft({"map", "list"});
  EXPECT_NE(said.out.find("label gate, given by tester, waits for place " + to_string(kept)), std::string::npos)
      << said.out;
  ASSERT_EQ(fleet.weft({"map", "unlabel", "gate"}).exit, Exit::done);
  EXPECT_TRUE(fleet.weft({"map", "list", "--json"}).json()["awaited_labels"].empty());
}

TEST(MapList, AnImportIsNoRobotsAndIsUndoneAsAWholeByItsName) {
  Fleet fleet;
  const std::size_t before = fleet.service->snapshot().place_count();
  ASSERT_EQ(fleet.weft({"map", "import", two_chains(), "--as", "hall"}).exit, Exit::done);
  const nlohmann::json all = listed(fleet);
  EXPECT_EQ(all.size(), 4U);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& one) { return one["name"] == "hall"; }), 2);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& one) { return !one.contains("robot"); }), 2);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& one) { return one.contains("begun"); }), 2) << "only its";
  const nlohmann::json log = fleet.weft({"map", "log", "--most", "1", "--json"}).json()["revisions"];
  EXPECT_EQ(log[0]["who"], "tester") << "whoever imported it";
  EXPECT_NE(log[0]["cause"].get<std::string>().find("of experience hall ("), std::string::npos) << log[0]["cause"];
  const std::string file = (folder() / "named.json").string();
  ASSERT_EQ(fleet.weft({"map", "export", file}).exit, Exit::done);
  const nlohmann::json exported = nlohmann::json::parse(std::ifstream(file))["experiences"];
  EXPECT_EQ(std::ranges::count_if(exported, [](const auto& one) { return one["name"] == "hall"; }), 2);
  const Said which = fleet.weft({"map", "export", (folder() / "a.tum").string(), "--experience", "hall"});
  EXPECT_NE(which.err.find("2 fit: give --experience NAME or ID"), std::string::npos) << which.err;
  const Said undone = fleet.weft({"map", "undo", "hall"});
  EXPECT_EQ(undone.exit, Exit::done) << undone.err;
  EXPECT_EQ(fleet.service->snapshot().place_count(), before);
  EXPECT_EQ(listed(fleet).size(), 2U);
}

TEST(MapLabel, IsRemovedRenamedAndUndone) {
  Fleet fleet;
  const PlaceId dock = fleet.service->snapshot().labels().at("dock");
  EXPECT_EQ(fleet.weft({"map", "relabel", "dock", "Halle-süd"}).exit, Exit::done);
  EXPECT_EQ(fleet.service->snapshot().labels().at("Halle-süd"), dock);
  EXPECT_FALSE(fleet.service->snapshot().labels().contains("dock"));
  const auto renamed = fleet.weft({"map", "log", "--most", "1", "--json"}).json()["revisions"][0];
  EXPECT_EQ(renamed["who"], "tester");
  EXPECT_EQ(fleet.weft({"map", "unlabel", "dock"}).exit, Exit::refused) << "it is called otherwise";
  EXPECT_EQ(fleet.weft({"map", "unlabel", "Halle-süd"}).exit, Exit::done);
  EXPECT_FALSE(fleet.service->snapshot().labels().contains("Halle-süd"));
  const std::uint64_t removed = fleet.weft({"map", "info", "--json"}).json()["revision"];
  EXPECT_EQ(fleet.weft({"map", "undo", "--revision", std::to_string(removed)}).exit, Exit::done);
  EXPECT_EQ(fleet.service->snapshot().labels().at("Halle-süd"), dock);
}

TEST(MapLabel, OfAnotherPlaceIsNotTakenByARename) {
  Fleet fleet;
  ASSERT_EQ(fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "gate"}).exit, Exit::done);
  const Said said = fleet.weft({"map", "relabel", "gate", "dock"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("label dock is there already"), std::string::npos) << said.err;
  EXPECT_EQ(fleet.weft({"map", "relabel", "gate", "a b"}).exit, Exit::usage);
}

TEST(MapLabel, ThatMovesSaysFromWhere) {
  Fleet fleet;
  const PlaceId dock = fleet.service->snapshot().labels().at("dock");
  const Said said = fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "dock"});
  EXPECT_NE(said.out.find("no longer " + to_string(dock)), std::string::npos) << said.out;
}

}  // namespace
}  // namespace weft::cli::test
