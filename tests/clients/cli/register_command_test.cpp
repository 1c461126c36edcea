#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/clients/cli/fleet.hpp"

/// Registers floor plans to the map as operators ask, and places robots, files and goals on them.
namespace weft::cli::test {
namespace {

bool mentions(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

/// Writes the picture of the plan, all of one shade.
void write_picture(const std::string& shade) {
  std::ofstream out(folder() / "hall.pgm");
  out << "P2\n8 6\n255\n";
  for (int i = 0; i < 48; ++i) out << shade << ' ';
}

/// Writes a plan of 40 m by 30 m whose lower left corner lies at (-10, -5).
std::string plan_file(const std::string& name = "hall.yaml") {
  write_picture("254");
  const std::filesystem::path file = folder() / name;
  std::ofstream(file) << "image: hall.pgm\nresolution: 5.0\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return file.string();
}

struct RegisterCommand : testing::Test {
  Said put(const std::string& pick = "dock=12,4,0.5") {
    return fleet.weft({"map", "register", plan, "--pick", pick});
  }

  std::string run() const { return to_string(fleet.first); }
  std::vector<Span> spans_of_wet() { return fleet.service->snapshot().rules().at("wet").spans; }
  nlohmann::json area_of_wet() { return fleet.weft({"rule", "list", "--json"}).json()["rules"][0]["area"]; }

  Fleet fleet;
  std::string plan = plan_file();
  /// Lays a rule down for places 28 to 32 of the first loop, where "dock" is place 30.
  std::vector<std::string> wet = {"rule", "add", "wet", "--kind", "closed", "--polygon", "11,3;13,3;13,5;11,5"};
};

TEST_F(RegisterCommand, IsShownLoggedComparedAndRemoved) {
  EXPECT_TRUE(mentions(fleet.weft({"map", "register", "--show"}).out, "no floor plan is registered"));
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  const Said dry = fleet.weft({"map", "register", plan, "--pick", "dock=12,4,0.5", "--dry-run"});
  EXPECT_TRUE(mentions(dry.out, "nothing was changed")) << dry.err;
  const Said said = put();
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_TRUE(mentions(said.out, "held by one pick")) << said.out;
  fleet.run(std::chrono::seconds(3));
  const auto rows = fleet.weft({"map", "register", "--show", "--json"}).json()["registrations"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["plan"], "hall");
  EXPECT_EQ(rows[0]["picks"][0]["name"], "dock");
  EXPECT_EQ(rows[0]["picks"][0]["state"], "counts");
  EXPECT_TRUE(rows[0]["problem"].is_null());
  EXPECT_TRUE(mentions(fleet.weft({"map", "register", "--show"}).out, "plan hall: held by one pick"));
  EXPECT_EQ(fleet.weft({"map", "log", "--json", "--most", "1"}).json()["revisions"][0]["kind"], "register");
  const auto diff = fleet.weft({"map", "diff", std::to_string(before), "--json"}).json();
  EXPECT_EQ(diff["plans"]["came"], nlohmann::json::array({"hall"}));
  EXPECT_TRUE(mentions(fleet.weft({"map", "diff", std::to_string(before)}).out, "hall"));
  EXPECT_EQ(fleet.weft({"map", "register", "hall", "--remove"}).exit, Exit::done);
  EXPECT_TRUE(mentions(fleet.weft({"map", "register", "--remove"}).err, "the map has no registered plan"));
}

TEST_F(RegisterCommand, ShowsThePlanThatIsNamedAlone) {
  ASSERT_EQ(put().exit, Exit::done);
  const std::string yard = plan_file("yard.yaml");
  ASSERT_EQ(fleet.weft({"map", "register", yard, "--pick", "dock=12,4,0.5"}).exit, Exit::done);
  fleet.run(std::chrono::seconds(3));
  EXPECT_EQ(fleet.weft({"map", "register", "--show", "--json"}).json()["registrations"].size(), 2U);
  const auto rows = fleet.weft({"map", "register", yard, "--show", "--json"}).json()["registrations"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["plan"], "yard");
  EXPECT_FALSE(mentions(fleet.weft({"map", "register", "yard", "--show"}).out, "plan hall"));
  const Said unknown = fleet.weft({"map", "register", "shed", "--show"});
  EXPECT_EQ(unknown.exit, Exit::refused);
  EXPECT_TRUE(mentions(unknown.err, "plan shed is not registered; known: hall, yard")) << unknown.err;
}

TEST_F(RegisterCommand, PlacesRobotsOnThePlan) {
  Puppet& r1 = fleet.add_robot("r1");
  r1.state.localised = true;
  r1.state.place = {fleet.first, 30};
  ASSERT_EQ(put().exit, Exit::done);
  fleet.run(std::chrono::seconds(3));
  const auto on_plan = fleet.weft({"robots", "--json"}).json()["robots"][0]["on_plan"];
  EXPECT_EQ(on_plan["plan"], "hall");
  EXPECT_NEAR(on_plan["pose"]["x"].get<double>(), 12.0, 1e-6);
  EXPECT_NEAR(on_plan["pose"]["y"].get<double>(), 4.0, 1e-6);
  EXPECT_NEAR(on_plan["pose"]["heading"].get<double>(), 0.5, 1e-6);
  EXPECT_TRUE(mentions(fleet.weft({"robots"}).out, "hall 12.00,4.00 29 deg"));
}

TEST_F(RegisterCommand, ExportsAndDrawsInThePlansFrame) {
  const std::string graph = (folder() / "registered.geojson").string();
  const std::string picture = (folder() / "registered.svg").string();
  const Said without = fleet.weft({"map", "draw", picture, "--floor-plan", plan});
  EXPECT_TRUE(mentions(without.err, "plan hall is not registered")) << without.err;
  EXPECT_TRUE(mentions(without.err, "--anchor")) << without.err;
  ASSERT_EQ(put().exit, Exit::done);
  const Said exported = fleet.weft({"map", "export", graph});
  EXPECT_TRUE(mentions(exported.out, "in the frame of plan hall, held by one pick")) << exported.out << exported.err;
  std::ifstream in(graph);
  const auto document = nlohmann::json::parse(in);
  bool has_dock = false;
  for (const auto& feature : document["features"]) {
    if (feature["geometry"]["type"] != "Point") continue;
    const double x = feature["geometry"]["coordinates"][0];
    const double y = feature["geometry"]["coordinates"][1];
    has_dock = has_dock || (std::abs(x - 12.0) < 1e-4 && std::abs(y - 4.0) < 1e-4);
  }
  EXPECT_TRUE(has_dock);
  EXPECT_FALSE(mentions(fleet.weft({"map", "export", graph, "--no-plan"}).out, "plan hall"));
  EXPECT_TRUE(mentions(fleet.weft({"map", "export", graph, "--plan", "yard"}).err, "plan yard is not registered"));
  EXPECT_TRUE(mentions(fleet.weft({"map", "draw", picture, "--floor-plan", plan}).out, "in the frame of plan hall"));
  std::ofstream(plan, std::ios::app) << "# edited\n";
  EXPECT_TRUE(mentions(fleet.weft({"map", "draw", picture, "--floor-plan", plan}).err, "is not what was registered"));
}

TEST_F(RegisterCommand, APlanWhosePictureWasEditedIsNotWhatWasRegistered) {
  const std::string picture = (folder() / "upon.svg").string();
  ASSERT_EQ(put().exit, Exit::done);
  ASSERT_EQ(fleet.weft({"map", "draw", picture, "--floor-plan", plan}).exit, Exit::done);
  write_picture("100");
  const Said said = fleet.weft({"map", "draw", picture, "--floor-plan", plan});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_TRUE(mentions(said.err, "or its picture, is not what was registered as plan hall: register it again"))
      << said.err;
  EXPECT_EQ(put().exit, Exit::done) << "it is another plan of that name";
  EXPECT_EQ(fleet.weft({"map", "draw", picture, "--floor-plan", plan}).exit, Exit::done);
}

TEST_F(RegisterCommand, WhatIsRegisteredIsAskedForOnlyWhereAPlanMayBeWanted) {
  ASSERT_EQ(put().exit, Exit::done);
  const auto pages_for = [&](std::vector<std::string> arguments) {
    const std::size_t before = fleet.asked[msg::Query::Kind::network];
    arguments.insert(arguments.begin(), "map");
    EXPECT_EQ(fleet.weft(arguments).exit, Exit::done) << arguments[1];
    return fleet.asked[msg::Query::Kind::network] - before;
  };
  const std::string picture = (folder() / "pages.svg").string();
  const std::string graph = (folder() / "pages.geojson").string();
  const std::size_t network_alone = pages_for({"export", (folder() / "pages.json").string()});
  EXPECT_EQ(pages_for({"draw", picture}), network_alone);
  EXPECT_EQ(pages_for({"draw", picture, "--floor-plan", plan, "--anchor", "dock=12,4,0.5"}), network_alone);
  EXPECT_EQ(pages_for({"export", graph, "--no-plan"}), network_alone);
  EXPECT_GT(pages_for({"export", graph}), network_alone);
  EXPECT_GT(pages_for({"draw", picture, "--floor-plan", plan}), network_alone);
}

TEST_F(RegisterCommand, SendsAGoalToAPointOfThePlan) {
  ASSERT_EQ(put().exit, Exit::done);
  fleet.run(std::chrono::seconds(3));
  const Said sent = fleet.weft({"goal", "send", "--to-plan", "12.1,4", "--no-return", "--json"});
  EXPECT_EQ(sent.exit, Exit::done) << sent.err;
  const auto goal = fleet.weft({"goal", "list", "--json"}).json()["goals"][0];
  EXPECT_EQ(goal["to"], "12.10,4.00");
  EXPECT_EQ(goal["place"], to_string(PlaceId{fleet.first, 30}));
  const Said far = fleet.weft({"goal", "send", "--to-plan", "400,4"});
  EXPECT_EQ(far.exit, Exit::refused);
  EXPECT_TRUE(mentions(far.err, "no place lies within 0.5 m of 400.00,4.00")) << far.err;
  EXPECT_TRUE(mentions(fleet.weft({"goal", "send", "--to-plan", "12"}).err, "is no point: write X,Y"));
  EXPECT_TRUE(mentions(fleet.weft({"goal", "send"}).err, "--to LABEL or --to-plan X,Y"));
}

TEST_F(RegisterCommand, LaysARuleDownForAPolygonOfThePlan) {
  const std::vector<std::string> add = {
      "rule", "add", "wet", "--kind", "closed", "--polygon", "11.6,3.6;12.4,3.6;12.4,4.4;11.6,4.4"};
  EXPECT_TRUE(mentions(fleet.weft(add).err, "no floor plan is registered"));
  ASSERT_EQ(put().exit, Exit::done);
  const Said said = fleet.weft(add);
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_TRUE(mentions(said.out, "weft rule refresh wet covers that too")) << said.out;
  EXPECT_FALSE(
      mentions(fleet.weft({"rule", "add", "slow", "--kind", "speed=0.3", "--label", "dock"}).out, "polygon"));
  const std::vector<Span> spans = fleet.service->snapshot().rules().at("wet").spans;
  const bool has_dock = std::ranges::any_of(spans, [&](const Span& span) {
    return span.from.experience == fleet.first && span.from.index <= 30 && 30 <= span.to.index;
  });
  EXPECT_TRUE(has_dock);
  const Said nothing = fleet.weft({"rule", "add", "dry", "--kind", "closed", "--polygon", "90,90;91,90;91,91"});
  EXPECT_TRUE(mentions(nothing.err, "no place of the map lies within it")) << nothing.err;
  const std::vector<std::string> both = {"rule",    "add",        "wet",       "--kind",     "closed",
                                         "--place", run() + ":1", "--polygon", "0,0;9,0;9,9"};
  EXPECT_TRUE(mentions(fleet.weft(both).err, "not of both: make two rules of it"));
}

TEST_F(RegisterCommand, ARuleCoversWhatComesIntoItsPolygonOnceItIsRefreshed) {
  ASSERT_EQ(put().exit, Exit::done);
  ASSERT_EQ(fleet.weft({"map", "quarantine", run() + ":31..32"}).exit, Exit::done);
  ASSERT_EQ(fleet.weft(wet).exit, Exit::done);
  EXPECT_EQ(spans_of_wet(), (std::vector<Span>{{{fleet.first, 28}, {fleet.first, 30}}}));
  EXPECT_EQ(area_of_wet()["not_covered"], 0);
  EXPECT_FALSE(mentions(fleet.weft({"rule", "list"}).out, "not covered"));
  const std::uint64_t revision = fleet.weft({"map", "info", "--json"}).json()["revision"];
  ASSERT_EQ(fleet.weft({"map", "undo", "--revision", std::to_string(revision - 1)}).exit, Exit::done);
  EXPECT_EQ(area_of_wet()["not_covered"], 2);
  EXPECT_TRUE(
      mentions(fleet.weft({"rule", "list"}).out, "2 places within its polygon not covered: weft rule refresh wet"));
  EXPECT_TRUE(mentions(fleet.weft({"rule", "refresh", "wet", "--dry-run"}).out, "nothing was changed"));
  EXPECT_EQ(area_of_wet()["not_covered"], 2);
  const Said said = fleet.weft({"rule", "refresh", "wet"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.out, "rule wet: added " + run() + ":31..32; removed nothing\n");
  EXPECT_EQ(spans_of_wet(), (std::vector<Span>{{{fleet.first, 28}, {fleet.first, 32}}}));
  EXPECT_EQ(area_of_wet()["not_covered"], 0);
}

TEST_F(RegisterCommand, RefreshingARuleAgainChangesNothing) {
  ASSERT_EQ(put().exit, Exit::done);
  EXPECT_EQ(fleet.weft({"rule", "refresh", "--all"}).out, "no rule has an area\n");
  ASSERT_EQ(fleet.weft(wet).exit, Exit::done);
  ASSERT_EQ(fleet.weft({"map", "quarantine", run() + ":32"}).exit, Exit::done);
  const auto refreshed = fleet.weft({"rule", "refresh", "--all", "--json"}).json()["refreshed"];
  ASSERT_EQ(refreshed.size(), 1U);
  EXPECT_EQ(refreshed[0]["name"], "wet");
  EXPECT_EQ(refreshed[0]["added"], nlohmann::json::array());
  EXPECT_EQ(refreshed[0]["removed"], nlohmann::json::array({run() + ":32..32"}));
  const std::uint64_t revision = fleet.weft({"map", "info", "--json"}).json()["revision"];
  EXPECT_EQ(fleet.weft({"rule", "refresh", "--all"}).out, "rule wet: as it was\n");
  EXPECT_EQ(fleet.weft({"map", "info", "--json"}).json()["revision"], revision);
}

TEST_F(RegisterCommand, ARuleWhosePlanIsGoneOrAnotherSaysSoAndIsNotRefreshed) {
  ASSERT_EQ(put().exit, Exit::done);
  ASSERT_EQ(fleet.weft(wet).exit, Exit::done);
  const std::vector<Span> spans = spans_of_wet();
  EXPECT_EQ(area_of_wet()["plan"], "hall");
  EXPECT_EQ(area_of_wet()["corners"].size(), 4U);
  ASSERT_EQ(fleet.weft({"map", "register", "hall", "--remove"}).exit, Exit::done);
  EXPECT_TRUE(area_of_wet()["not_covered"].is_null());
  EXPECT_TRUE(mentions(area_of_wet()["problem"], "is no longer registered"));
  EXPECT_TRUE(
      mentions(fleet.weft({"rule", "list"}).out, "plan hall, on which its area lies, is no longer registered"));
  const Said said = fleet.weft({"rule", "refresh", "wet"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_TRUE(mentions(said.err, "rule wet: plan hall, on which its area lies, is no longer registered")) << said.err;
  std::ofstream(plan, std::ios::app) << "# edited\n";
  ASSERT_EQ(put().exit, Exit::done);
  EXPECT_TRUE(mentions(fleet.weft({"rule", "refresh", "--all"}).err, "is registered from another file"));
  EXPECT_EQ(spans_of_wet(), spans);
}

TEST_F(RegisterCommand, RulesWithoutAnAreaAreNotRefreshed) {
  ASSERT_EQ(fleet.weft({"rule", "add", "slow", "--kind", "speed=0.3", "--label", "dock"}).exit, Exit::done);
  const Said said = fleet.weft({"rule", "refresh", "slow"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_TRUE(mentions(said.err, "rule slow has no area")) << said.err;
  EXPECT_TRUE(mentions(fleet.weft({"rule", "refresh", "none"}).err, "the map has no rule none"));
  EXPECT_TRUE(mentions(fleet.weft({"rule", "refresh"}).err, "NAME or --all"));
  const auto row = fleet.weft({"rule", "list", "--json"}).json()["rules"][0];
  EXPECT_TRUE(row["area"].is_null());
}

TEST_F(RegisterCommand, WhatCannotBeMeantIsRefusedHere) {
  EXPECT_TRUE(mentions(put("none=12,4,0").err, "--pick none: the map has no such label"));
  EXPECT_TRUE(mentions(put("dock=120,4,0").err, "--pick dock=120,4 lies outside of "));
  EXPECT_TRUE(mentions(put("dock=120,4,0").err, "x -10.00 to 30.00 and y -5.00 to 25.00 m"));
  EXPECT_TRUE(mentions(put("dock").err, "--pick 'dock' is no anchor"));
  EXPECT_TRUE(
      mentions(fleet.weft({"map", "register", plan}).err, "PLAN and --pick LABEL=X,Y, or --show, or --remove"));
  EXPECT_TRUE(mentions(fleet.weft({"map", "register", "/nowhere.yaml", "--pick", "dock=1,2"}).err, "/nowhere.yaml"));
  EXPECT_TRUE(mentions(put("dock=12,4").err, "one pick needs a heading: dock=X,Y,HEADING"));
}

}  // namespace
}  // namespace weft::cli::test
