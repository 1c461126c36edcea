#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "clients/evaluate/line.hpp"
#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate {
namespace {

TEST(EvaluateInvocation, FlagsAndDefaults) {
  const auto plain = std::get<DisturbancesOptions>(parsed({"disturbances"}));
  EXPECT_EQ(plain.seeds.first, 1U);
  EXPECT_EQ(plain.seeds.last, 3U);
  EXPECT_EQ(plain.site, "deploy/sites/demo.toml");
  const auto given = std::get<DisturbancesOptions>(
      parsed({"disturbances", "--seeds", "4..9", "--site", "s", "--along", "l", "--metres", "20", "--out", "o"}));
  EXPECT_EQ(given.seeds.first, 4U);
  EXPECT_EQ(given.seeds.last, 9U);
  EXPECT_EQ(given.metres, 20.0);
  EXPECT_EQ(given.along, "l");
  EXPECT_TRUE(given.only.empty());
  EXPECT_EQ(std::get<DisturbancesOptions>(parsed({"disturbances", "--only", "all", "--only", "own shadow"})).only,
            (std::vector<std::string>{"all", "own shadow"}));
  EXPECT_EQ(given.out, "o");
}

TEST(EvaluateInvocation, StudiesTakeUnderAnHourUnlessAllIsAskedForAndMinutesIfQuick) {
  const auto usual = std::get<FloorOptions>(parsed({"floor"}));
  EXPECT_EQ(usual.seeds.last, 4U);
  EXPECT_EQ(usual.usual_lights, (std::vector<std::string>{"same", "halved", "dirt"}));
  const auto whole = std::get<FloorOptions>(parsed({"floor", "--all"}));
  EXPECT_EQ(whole.seeds.last, 10U);
  EXPECT_TRUE(whole.usual_lights.empty());
  EXPECT_EQ(std::get<FloorOptions>(parsed({"floor", "--all", "--seeds", "1..4"})).seeds.last, 4U);
  const auto quick = std::get<FloorOptions>(parsed({"floor", "--quick"}));
  EXPECT_EQ(quick.seeds.last, 1U);
  EXPECT_EQ(quick.kind, "epoxy");
  EXPECT_EQ(quick.light, "same");
  EXPECT_EQ(quick.metres, 6.0);
  EXPECT_TRUE(std::holds_alternative<NotRun>(parsed({"floor", "--quick", "--all"})));
}

TEST(EvaluateInvocation, AttemptsTakeTheFlagsOfFloors) {
  const auto plain = std::get<AttemptsOptions>(parsed({"floor-attempts"}));
  EXPECT_EQ(plain.attempts, 100'000U);
  EXPECT_EQ(plain.site, "deploy/sites/demo.toml");
  EXPECT_EQ(plain.out, "out/floor-attempts");
  const auto given = std::get<AttemptsOptions>(
      parsed({"floor-attempts", "--kind", "k", "--light", "l", "--seeds", "3", "--attempts", "50", "--floors", "f"}));
  EXPECT_EQ(given.kind, "k");
  EXPECT_EQ(given.light, "l");
  EXPECT_EQ(given.floors, "f");
  EXPECT_EQ(given.seeds.last, 3U);
  EXPECT_EQ(given.attempts, 50U);
}

TEST(EvaluateInvocation, RelocalisationHasAHallOfItsOwn) {
  const auto plain = std::get<RelocaliseOptions>(parsed({"floor-relocalise"}));
  EXPECT_EQ(plain.metres, 1000.0);
  EXPECT_EQ(plain.trials, 1000U);
  EXPECT_EQ(plain.seeds.last, 3U);
  EXPECT_EQ(plain.out, "out/floor-relocalise");
  const auto given = std::get<RelocaliseOptions>(parsed({"floor-relocalise", "--metres", "50", "--trials", "7"}));
  EXPECT_EQ(given.metres, 50.0);
  EXPECT_EQ(given.trials, 7U);
}

TEST(EvaluateInvocation, HeadingsAreToldAtTheirBestOrAsRobotsTellThem) {
  const auto plain = std::get<HeadingOptions>(parsed({"heading", "dir"}));
  EXPECT_EQ(plain.features, 2000);
  EXPECT_EQ(plain.cell_widths, 1.0 / 64);
  const auto given = std::get<HeadingOptions>(parsed({"heading", "dir", "--features", "300", "--cell", "0.022"}));
  EXPECT_EQ(given.features, 300);
  EXPECT_EQ(given.cell_widths, 0.022);
  EXPECT_EQ(std::get<NotRun>(parsed({"heading", "dir", "--features", "19"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"heading", "dir", "--cell", "0.06"})).exit_code, 2);
}

TEST(EvaluateInvocation, OdometryAsksForCandidatesByFlag) {
  const auto plain = std::get<OdometryOptions>(parsed({"odometry"}));
  EXPECT_FALSE(plain.candidates);
  EXPECT_EQ(plain.seeds.last, 3U);
  const auto given =
      std::get<OdometryOptions>(parsed({"odometry", "--candidates", "--kind", "epoxy", "--seeds", "7"}));
  EXPECT_TRUE(given.candidates);
  EXPECT_TRUE(std::get<OdometryOptions>(parsed({"odometry", "--regions"})).regions);
  EXPECT_TRUE(std::holds_alternative<NotRun>(parsed({"odometry", "--regions", "--candidates"})));
  EXPECT_EQ(given.kind, "epoxy");
  EXPECT_EQ(given.seeds.first, 7U);
}

TEST(EvaluateInvocation, MistakesAreUsageInOneLineAndSayWhich) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> wrong = {
      {{}, "subcommand"},
      {{"disturbanc"}, "disturbanc"},
      {{"disturbances", "--colour"}, "--colour"},
      {{"disturbances", "more"}, "more"},
      {{"disturbances", "--seeds", "x"}, "'x'"},
      {{"disturbances", "--seeds", "1..y"}, "'1..y'"},
      {{"disturbances", "--seeds", "-1"}, "'-1'"},
      {{"disturbances", "--seeds", "3..1"}, "'3..1'"},
      {{"disturbances", "--seeds", "1..99999"}, "10000"},
      {{"disturbances", "--metres", "10"}, "--metres"},
      {{"disturbances", "--only"}, "--only"},
      {{"disturbances", "--only", "all", "none"}, "none"},
      {{"disturbances", "--out"}, "--out"},
      {{"floor", "--seeds", "2..1"}, "'2..1'"},
      {{"floor", "--metres", "4"}, "--metres"},
      {{"floor", "--metres", "far"}, "--metres"},
      {{"floor", "--kind"}, "--kind"},
      {{"floor", "--heavy"}, "--heavy"},
      {{"floor", "--replay"}, "--replay"},
      {{"floor", "--replay", "r", "--kind", "epoxy"}, "--kind"},
      {{"floor", "--query", "q"}, "--replay"},
      {{"floor", "--mount", "0,0,0.6,45"}, "--replay"},
      {{"floor", "--replay", "r", "--mount", "0,0,0.6"}, "--mount"},
      {{"floor", "--replay", "r", "--mount", "0,0,high,45"}, "--mount"},
      {{"floor-attempts", "--attempts", "0"}, "--attempts"},
      {{"floor-attempts", "--seeds", "x"}, "'x'"},
      {{"floor-relocalise", "--metres", "5"}, "--metres"},
      {{"floor-relocalise", "--along", "l"}, "--along"},
      {{"generate-site", "--places", "0"}, "places is 0"},
      {{"generate-site", "--places", "many"}, "--places"},
      {{"generate-site", "--content-bytes", "2"}, "content bytes"},
  };
  for (const auto& [words, word] : wrong) {
    const auto result = parsed(words);
    const auto* const not_run = std::get_if<NotRun>(&result);
    ASSERT_NE(not_run, nullptr) << word;
    EXPECT_EQ(not_run->exit_code, 2) << word;
    EXPECT_NE(not_run->text.find(word), std::string::npos) << not_run->text;
    EXPECT_EQ(std::count(not_run->text.begin(), not_run->text.end(), '\n'), 1) << not_run->text;
  }
}

TEST(EvaluateInvocation, FloorsToStudy) {
  const auto plain = std::get<FloorOptions>(parsed({"floor"}));
  EXPECT_EQ(plain.seeds.first, 1U);
  EXPECT_EQ(plain.seeds.last, 4U);
  EXPECT_EQ(plain.kind, "");
  EXPECT_EQ(plain.out, "out/floor");
  const auto given = std::get<FloorOptions>(parsed({"floor", "--kind", "epoxy", "--light", "same", "--seeds", "3",
                                                    "--floors", "f", "--metres", "9", "--out", "o"}));
  EXPECT_EQ(given.kind, "epoxy");
  EXPECT_EQ(given.light, "same");
  EXPECT_EQ(given.seeds.last, 3U);
  EXPECT_EQ(given.floors, "f");
  EXPECT_EQ(given.metres, 9.0);
  EXPECT_EQ(given.out, "o");
}

TEST(EvaluateInvocation, RecordingsToReplay) {
  const auto plain = std::get<ReplayOptions>(parsed({"floor", "--replay", "r"}));
  EXPECT_EQ(plain.recording, "r");
  EXPECT_EQ(plain.camera, "cam0");
  EXPECT_FALSE(plain.mount.has_value());
  EXPECT_EQ(plain.out, "out/floor");
  const auto given =
      std::get<ReplayOptions>(parsed({"floor", "--replay", "r", "--query", "q", "--truth", "t.txt", "--camera",
                                      "cam1", "--mount", "0.2,-0.1,0.6,42", "--out", "o"}));
  EXPECT_EQ(given.query, "q");
  EXPECT_EQ(given.truth, "t.txt");
  EXPECT_EQ(given.camera, "cam1");
  ASSERT_TRUE(given.mount.has_value());
  EXPECT_EQ(given.mount->left_m, -0.1);
  EXPECT_EQ(given.mount->pitch_deg, 42.0);
  EXPECT_EQ(given.out, "o");
}

TEST(EvaluateInvocation, SitesToGenerate) {
  const auto plain = std::get<GenerateOptions>(parsed({"generate-site"}));
  EXPECT_EQ(plain.plan.places, 10'000U);
  EXPECT_EQ(plain.out, "out/site");
  const auto given = std::get<GenerateOptions>(
      parsed({"generate-site", "--places", "500", "--seed", "7", "--content-bytes", "20000", "--out", "o"}));
  EXPECT_EQ(given.plan.places, 500U);
  EXPECT_EQ(given.plan.seed, 7U);
  EXPECT_EQ(given.plan.content_bytes, 20'000U);
  EXPECT_EQ(given.out, "o");
}

TEST(EvaluateInvocation, HelpIsNoMistake) {
  const auto help = parsed({"disturbances", "--help"});
  EXPECT_EQ(std::get<NotRun>(help).exit_code, 0);
  EXPECT_NE(std::get<NotRun>(help).text.find("--seeds"), std::string::npos);
  const auto of_floor = parsed({"floor", "--help"});
  EXPECT_NE(std::get<NotRun>(of_floor).text.find("--light"), std::string::npos);
}

TEST(EvaluateLine, WrongRowsAreNamed) {
  const auto good = parse_line("# start\n0 0\n\n3 4 # corner\n", "f");
  ASSERT_TRUE(good.has_value());
  EXPECT_EQ(*good, (std::vector<agents::SitePoint>{{0, 0}, {3, 4}}));
  for (const char* const text : {"0 0\n1\n", "0 0\n1 x\n", "0 0\n1 2 3\n", "0 0\nnan 1\n"}) {
    const auto wrong = parse_line(text, "f");
    ASSERT_FALSE(wrong.has_value()) << text;
    EXPECT_NE(wrong.error().message.find("f:2"), std::string::npos) << wrong.error().message;
  }
}

TEST(EvaluateLine, TheBeginningIsCutToItsLength) {
  const std::vector<agents::SitePoint> line = {{0, 0}, {4, 0}, {4, 6}};
  EXPECT_EQ(first_metres(line, 7.0, "f").value(), (std::vector<agents::SitePoint>{{0, 0}, {4, 0}, {4, 3}}));
  EXPECT_EQ(first_metres(line, 4.0, "f").value(), (std::vector<agents::SitePoint>{{0, 0}, {4, 0}}));
  EXPECT_FALSE(first_metres(line, 10.1, "f").has_value());
  EXPECT_FALSE(first_metres({}, 1.0, "f").has_value());
}

}  // namespace
}  // namespace weft::evaluate
