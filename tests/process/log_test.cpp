#include "process/log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ringbuffer_sink.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

namespace weft::process::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::SizeIs;

constexpr WallTime kAt{Duration(1'772'357'405s + 250ms)};

LogLine assigned() {
  return {.at = kAt,
          .level = "info",
          .program = "weft-server",
          .event = "goal.assigned",
          .message = "r1 is the nearest",
          .fields = {{"who", "operator"}, {"robot", ""}, {"goal", "4f2c"}}};
}

TEST(LogLine, TextHasTimeZoneLevelAndWhatItIsAbout) {
  EXPECT_EQ(to_text(assigned()),
            "2026-03-01T09:30:05.250Z info weft-server: goal.assigned: r1 is the nearest (who operator, goal 4f2c)");
  LogLine plain = assigned();
  plain.event = {};
  plain.fields = {};
  EXPECT_EQ(to_text(plain), "2026-03-01T09:30:05.250Z info weft-server: r1 is the nearest");
}

TEST(LogLine, JsonIsOneObjectWithTheSame) {
  const auto object = nlohmann::json::parse(to_json(assigned()));
  EXPECT_EQ(object, (nlohmann::json{{"time", "2026-03-01T09:30:05.250Z"},
                                    {"level", "info"},
                                    {"program", "weft-server"},
                                    {"event", "goal.assigned"},
                                    {"message", "r1 is the nearest"},
                                    {"who", "operator"},
                                    {"goal", "4f2c"}}));
}

TEST(LogLine, StaysOneLineWhateverItIsGiven) {
  LogLine awkward = assigned();
  awkward.message = "a\nb \"c\" \xFF";
  EXPECT_EQ(to_text(awkward).find('\n'), std::string::npos);
  EXPECT_EQ(to_json(awkward).find('\n'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(to_json(awkward))["message"], "a\nb \"c\" \xEF\xBF\xBD");
}

TEST(Log, WritesALineForEachCall) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(8);
  Log log("weft-agent", LogFormat::json, said);
  log.always_about({{"robot", "r1"}});
  log.warn("{} stays as it is");
  log.event("robot.lost", "it stands", {{"goal", "4f2c"}});
  const std::vector<std::string> lines = said->last_formatted();
  ASSERT_THAT(lines, SizeIs(2));
  const auto first = nlohmann::json::parse(lines[0]);
  EXPECT_EQ(first["level"], "warning");
  EXPECT_EQ(first["message"], "{} stays as it is");
  EXPECT_EQ(first["robot"], "r1");
  EXPECT_THAT(first["time"].get<std::string>(), testing::EndsWith("Z"));
  EXPECT_EQ(nlohmann::json::parse(lines[1])["goal"], "4f2c");
}

TEST(Log, TextDoesNotRepeatWhoseLogItIs) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(8);
  Log log("weft-agent", LogFormat::text, said);
  log.always_about({{"robot", "r1"}});
  log.info("ready");
  ASSERT_THAT(said->last_formatted(), SizeIs(1));
  EXPECT_THAT(said->last_formatted()[0], testing::EndsWith("Z info weft-agent: ready\n"));
}

}  // namespace
}  // namespace weft::process::test
