#include "agents/agent/process/options.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "tests/agents/agent/process/folder.hpp"
#include "tests/agents/agent/process/programs.hpp"

namespace weft::agents::test {
namespace {

std::variant<Options, Leave> parsed(const std::vector<std::string>& arguments, const Program& program = kSimulator) {
  std::vector<const char*> argv = {program.name};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return parse_options(program, static_cast<int>(argv.size()), argv.data());
}

void expect_left(const std::vector<std::string>& arguments, int exit_code, const std::string& word,
                 const Program& program = kSimulator) {
  const auto result = parsed(arguments, program);
  const auto* const leave = std::get_if<Leave>(&result);
  ASSERT_NE(leave, nullptr) << word;
  EXPECT_EQ(leave->exit_code, exit_code) << leave->text;
  EXPECT_NE(leave->text.find(word), std::string::npos) << leave->text;
  if (exit_code != 0) {
    EXPECT_EQ(leave->text.find('\n'), leave->text.size() - 1) << "one line: " << leave->text;
  }
}

const std::vector<std::string> kEnough = {"--name", "r1", "--state", "s", "--site", "x.toml"};

std::vector<std::string> with(std::vector<std::string> more) {
  more.insert(more.begin(), kEnough.begin(), kEnough.end());
  return more;
}

TEST(AgentOptions, FlagsAndDefaults) {
  const auto result =
      parsed(with({"--dds", "cyclonedds", "--server", "a:3", "--server", "b", "--seed", "7", "--pace", "0"}));
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(options->name, "r1");
  EXPECT_EQ(options->vendor, bus::Vendor::cyclonedds);
  EXPECT_EQ(options->servers, (std::vector<std::string>{"a:3", "b"}));
  EXPECT_EQ(options->seed, 7U);
  EXPECT_EQ(options->pace, 0.0);
  EXPECT_EQ(options->methods, std::vector<std::string>{"floor"});
  EXPECT_FALSE(options->truth.has_value());
  EXPECT_EQ(options->listen, "127.0.0.1");
}

TEST(AgentOptions, HealthNeedsTheStateDirectoryAlone) {
  const auto result = parsed({"--health", "--state", "s"});
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_TRUE(options->asks_health);
  EXPECT_EQ(options->state, "s");
  expect_left({"--health"}, 2, "--state");
  expect_left({"--state", "s"}, 2, "--name");
}

TEST(AgentOptions, TheLogIsTextOrJson) {
  const auto result = parsed(with({"--log-format", "json"}));
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(options->log_format, process::LogFormat::json);
  expect_left(with({"--log-format", "xml"}), 2, "log_format");
}

TEST(AgentOptions, MetricsAreServedAtAPortOrNotAtAll) {
  const auto none = parsed(with({}));
  ASSERT_NE(std::get_if<Options>(&none), nullptr);
  EXPECT_EQ(std::get<Options>(none).metrics, 0);
  const auto result = parsed(with({"--metrics", "9465"}));
  ASSERT_NE(std::get_if<Options>(&result), nullptr);
  EXPECT_EQ(std::get<Options>(result).metrics, 9465);
  expect_left(with({"--metrics", "65536"}), 2, "metrics");
  expect_left(with({"--metrics", "1.5"}), 2, "metrics");
}

TEST(AgentOptions, AMethodsOwnNavigationWinsOverThatOfAll) {
  const Folder folder;
  const std::string file =
      folder.write("a.toml", "[navigation.follow]\nspeed_m_s = 0.4\n[floor.navigation.follow]\nspeed_m_s = 0.3\n");
  const auto result = parsed(with({"--config", file}));
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(options->navigation.follow.speed_m_s, 0.4);
  AllMethods::for_each([&]<class M>() {
    constexpr bool is_own = std::is_same_v<M, Floor>;
    EXPECT_EQ(std::get<Configured<M>>(options->settings).navigation.follow.speed_m_s, is_own ? 0.3 : 0.4) << M::name;
  });
}

TEST(AgentOptions, AWrongSettingOfAllMethodsIsNamedOnce) {
  const Folder folder;
  const std::string file = folder.write("a.toml", "[navigation.follow]\nspeed_m_s = 9\n");
  const auto result = parsed(with({"--config", file}));
  const auto* const left = std::get_if<Leave>(&result);
  ASSERT_NE(left, nullptr);
  const std::size_t first = left->text.find("speed_m_s = 9");
  ASSERT_NE(first, std::string::npos) << left->text;
  EXPECT_EQ(left->text.find("speed_m_s = 9", first + 1), std::string::npos) << left->text;
}

TEST(AgentOptions, FlagWinsOverFile) {
  const Folder folder;
  const std::string file = folder.write("a.toml", "name = \"r9\"\nday = 4\nwindow_hops = 9\n[floor]\ncorners = 99\n");
  const auto result = parsed(with({"--config", file}));
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(options->name, "r1");
  EXPECT_EQ(options->day, 4U);
  EXPECT_EQ(options->window_hops, 9U);
  EXPECT_EQ(std::get<Configured<Floor>>(options->settings).config.corners, 99);
}

TEST(AgentOptions, FileSetsHowItNavigates) {
  const Folder folder;
  const std::string file = folder.write("n.toml",
                                        "footprint_radius_m = 0.3\n"
                                        "[navigation.teach]\nspacing_m = 0.25\n"
                                        "[navigation.belief]\nfuse = false\n"
                                        "[navigation.locate]\nmost_hops = 40\n"
                                        "[navigation.control]\nlag_s = 0.2\n"
                                        "[navigation.control.speed]\nslowest_m_s = 0.1\n");
  const auto result = parsed(with({"--config", file}));
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(options->navigation.teach.spacing_m, 0.25);
  EXPECT_FALSE(options->navigation.belief.fuse);
  EXPECT_EQ(options->navigation.locate.most_hops, 40U);
  EXPECT_EQ(options->navigation.tracker.lag_s, 0.2);
  EXPECT_EQ(options->navigation.tracker.speed.slowest_m_s, 0.1);
  EXPECT_EQ(options->navigation.follow.footprint_radius_m, 0.3);
  EXPECT_EQ(options->navigation.follow.speed_m_s, NavigationConfig{}.follow.speed_m_s);
  EXPECT_TRUE(check(options->navigation).empty());
}

TEST(AgentOptions, MistakesAreUsageInOneLine) {
  expect_left(with({"--colour", "red"}), 2, "--colour");
  expect_left(with({"--dds", "rti"}), 2, "dds");
  expect_left(with({"--domain", "201"}), 2, "domain");
  expect_left(with({"--seed", "many"}), 2, "seed");
  expect_left(with({"--pace", "-1"}), 2, "pace");
  std::string methods;
  for (const std::string_view name : AllMethods::names) methods += (methods.empty() ? "" : ", ") + std::string(name);
  expect_left(with({"--method", "marks"}), 2, "there is no method \"marks\"; there are " + methods);
  expect_left(with({"--method", "floor,floor"}), 2, "\"floor\" is named twice");
  expect_left(with({"--method", "floor,"}), 2, "there is no method \"\"");
  expect_left({"--state", "s", "--site", "x"}, 2, "--name");
  expect_left({"--name", "r1", "--site", "x"}, 2, "--state");
  expect_left({"--name", "r1", "--state", "s"}, 2, "--site");
  expect_left({"--name", "r1", "--state", "s", "--body", "replay"}, 2, "--recording");
}

TEST(AgentOptions, MistakesInTheFileNameItsLine) {
  const Folder folder;
  expect_left(with({"--config", folder.file("none.toml")}), 2, "none.toml");
  expect_left(with({"--config", folder.write("a.toml", "colour = 1\n")}), 2,
              "a.toml:1: colour: unknown key; there are bearing");
  expect_left(with({"--config", folder.write("b.toml", "\n[floor]\ncorners = 2\n")}), 2, "b.toml:3: floor.corners");
  expect_left(with({"--config", folder.write("c.toml", "[navigation.follow]\nspeed_m_s = 9\n")}), 2,
              "c.toml:2: navigation.follow.speed_m_s");
  expect_left(with({"--config", folder.write("d.toml", "[navigation.folow]\nspeed_m_s = 0.5\n")}), 2,
              "navigation.folow");
  expect_left(with({"--config", folder.write("e.toml", "server = [\"a\", \"b:many\"]\n")}), 2, "e.toml:1: server");
  expect_left(with({"--config", folder.write("f.toml", "name = \"r/1\"\n")}), 2, "f.toml:1: name");
  expect_left(with({"--config", folder.write("g.toml", "name = \n")}), 2, "g.toml:1: no TOML");
}

TEST(AgentOptions, SettingsThatContradictEachOtherAreNamedWithTheirFile) {
  const Folder folder;
  const std::string text = "[navigation.follow]\nsure_m = 3\nblind_limit_m = 2\n";
  const std::string file = folder.write("a.toml", text);
  expect_left(with({"--config", file}), 2, "a.toml: navigation: follow.sure_m is 3");
  const std::string own = folder.write("b.toml", "[bearing." + text.substr(1));
  expect_left(with({"--config", own, "--method", "bearing"}), 2, "b.toml: navigation: follow.sure_m is 3");
}

TEST(AgentOptions, TheExampleOfThePackageIsGood) {
  const std::string file = std::string(WEFT_SITES) + "/../packages/agent.toml";
  const auto result = parsed({"--state", "s", "--site", "x", "--config", file});
  ASSERT_TRUE(std::holds_alternative<Options>(result)) << std::get<Leave>(result).text;
  EXPECT_EQ(std::get<Options>(result).servers, std::vector<std::string>{"10.0.0.5"});
}

TEST(AgentOptions, HelpAndVersion) {
  expect_left({"--help"}, 0, "--records");
  expect_left({"--help"}, 0, "sim | replay [sim]");
  expect_left({"--version"}, 0, "weft-agent-sim 0.");
  expect_left({"--version"}, 0, "weft-agent 0.", kRobotsAgent);
  const auto help = parsed({"--help"}, kRobotsAgent);
  EXPECT_EQ(std::get<Leave>(help).text.find("--site"), std::string::npos);
}

TEST(AgentOptions, WithoutTheSimulatorItsFlagsNameTheProgramThatHasIt) {
  const std::string said = "there is no body sim in this program; start weft-agent-sim, with the same words";
  const std::vector<std::string> enough = {"--name", "r1", "--state", "s", "--recording", "drive"};
  const auto result = parsed(enough, kRobotsAgent);
  ASSERT_TRUE(std::holds_alternative<Options>(result)) << std::get<Leave>(result).text;
  EXPECT_EQ(std::get<Options>(result).body, "replay");
  expect_left(kEnough, 2, said, kRobotsAgent);
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--body", "sim"},
                                                                                    {"--seed", "3"},
                                                                                    {"--day", "1"},
                                                                                    {"--floors", "f"},
                                                                                    {"--hall", "h"},
                                                                                    {"--truth", "t"}}) {
    std::vector<std::string> words = enough;
    words.insert(words.end(), more.begin(), more.end());
    expect_left(words, 2, said, kRobotsAgent);
  }
  const Folder folder;
  std::vector<std::string> words = enough;
  words.insert(words.end(), {"--config", folder.write("a.toml", "\nsite = \"x.toml\"\n")});
  expect_left(words, 2, "a.toml:2: site = 'x.toml': " + said, kRobotsAgent);
}

}  // namespace
}  // namespace weft::agents::test
