#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>

#include "clients/cli/files.hpp"
#include "core/text.hpp"
#include "storage/formats/gzip.hpp"
#include "tests/clients/cli/one_robot.hpp"

/// Tests `weft bundle`.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

/// Reads the files of an archive, by name.
std::map<std::string, std::string> unpack(const std::string& file) {
  std::map<std::string, std::string> files;
  const auto bytes = read_file(file);  // *.gz: unpacked
  EXPECT_TRUE(bytes) << bytes.error().message;
  const std::string_view all = text_in(*bytes);
  for (std::size_t at = 0; at + 512 <= all.size() && all[at] != '\0';) {
    const std::string name(all.substr(at, 100).data());
    const std::size_t size = std::stoull(std::string(all.substr(at + 124, 11)), nullptr, 8);
    files[name] = std::string(all.substr(at + 512, size));
    at += 512 + (size + 511) / 512 * 512;
  }
  return files;
}

struct Bundled : testing::Test {
  OneRobot fleet;
  std::string out = [] {
    std::filesystem::remove_all(folder());
    return (folder() / "report.tar.gz").string();
  }();
};

TEST_F(Bundled, HasWhatTheCommandsSayAndNoSecrets) {
  const std::string settings = (folder() / "agent.toml").string();
  ASSERT_TRUE(write_file(std::string("name = \"r1\"\ntoken = \"hunter2\"\n"), settings));
  const Said said = fleet.weft({"bundle", out, "--settings", settings, "--log", (folder() / "no.log").string()});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_THAT(said.err, HasSubstr("robots.json, ")) << "says how far it is";
  EXPECT_THAT(said.err, HasSubstr("no.log: is no file that can be read"));
  auto files = unpack(out);
  for (const char* const name : {"doctor", "robots", "alarms", "goals", "map-info", "map-stats", "versions"}) {
    const std::string& text = files[std::string("weft-report/") + name + ".json"];
    EXPECT_TRUE(nlohmann::json::accept(text)) << name << ": " << text;
  }
  EXPECT_THAT(files["weft-report/events.jsonl"], HasSubstr("server.started"));
  EXPECT_THAT(files["weft-report/versions.json"], HasSubstr("\"r1\""));
  EXPECT_THAT(files["weft-report/README.txt"], HasSubstr("no.log: is no file"));
  std::string all_settings;
  for (const auto& [name, text] : files) {
    EXPECT_EQ(text.find("hunter2"), std::string::npos) << name;
    if (name.starts_with("weft-report/settings/")) all_settings += text;
  }
  EXPECT_THAT(all_settings, HasSubstr("token = (left out)"));
}

TEST_F(Bundled, RefusesToOverwriteAndWritesNothing) {
  ASSERT_TRUE(write_file(std::string("mine"), out));
  const Said said = fleet.weft({"bundle", out});
  EXPECT_EQ(said.exit, Exit::usage);
  EXPECT_THAT(said.err, HasSubstr("is there already"));
  EXPECT_EQ(std::filesystem::file_size(out), 4U);
  EXPECT_THAT(fleet.weft({"bundle", (folder() / "report.zip").string()}).err, HasSubstr("must end in .tar.gz"));
  EXPECT_THAT(fleet.weft({"bundle", (folder() / "no" / "report.tar.gz").string()}).err, HasSubstr("no folder"));
}

TEST_F(Bundled, WithoutAServerHasWhatThisMachineHas) {
  fleet.server_lives = false;
  const Said said = fleet.weft({"bundle", out, "--json"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.json()["missing"][0]["what"], "all that the server says");
  EXPECT_TRUE(unpack(out).contains("weft-report/machine.txt"));
}

TEST_F(Bundled, InterruptedLeavesNothing) {
  int asked = 0;
  fleet.interrupted = [&asked] { return ++asked > 5; };
  const Said said = fleet.weft({"bundle", out});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_THAT(said.err, HasSubstr("interrupted"));
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
}

}  // namespace
}  // namespace weft::cli::test
