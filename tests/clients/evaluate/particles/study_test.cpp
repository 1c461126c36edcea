#include "clients/evaluate/particles/study.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate::particles {
namespace {

/// Returns how far a wall of an L-shaped hall is: 10 by 6 m, the corner beyond (6, 3) walled off.
double to_wall_m(double x, double y, double heading) {
  const auto is_inside = [](double px, double py) {
    return px > 0.0 && px < 10.0 && py > 0.0 && py < 6.0 && !(px > 6.0 && py > 3.0);
  };
  double range = 0.0;
  while (range < 20.0 && is_inside(x + range * std::cos(heading), y + range * std::sin(heading))) range += 0.01;
  return range;
}

/// Writes the log of a laser that is driven through that hall.
void write_hall(const std::filesystem::path& file) {
  std::ofstream out(file);
  double x = 1.0;
  double y = 0.6;
  double heading = 0.0;
  for (int i = 0; i < 120; ++i) {
    out << "FLASER 90";
    for (int k = 0; k < 90; ++k)
      out << ' ' << to_wall_m(x, y, heading + std::numbers::pi * (static_cast<double>(k) / 90.0 - 0.5));
    out << ' ' << x << ' ' << y << ' ' << heading << " 0 0 0 " << i << " host " << i << '\n';
    const double step = i < 60 ? 0.12 : 0.05;
    heading += i < 60 ? 0.0 : 0.05;
    x += step * std::cos(heading);
    y += step * std::sin(heading);
  }
}

class ParticleStudy : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / ("particles" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    write_hall(folder_ / "hall.log");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  Result<Ended> study(const ParticlesOptions& options, int stop_after = 1 << 30) {
    out_.str("");
    int asked = 0;
    const Surroundings around{out_, progress_, [] { return 0.0; }, [&] { return ++asked > stop_after; }};
    return study_particles(options, around);
  }
  ParticlesOptions options() const { return {folder_ / "hall.log", {1, 2}, 0.2, false, folder_ / "out", false}; }

  std::filesystem::path folder_;
  std::ostringstream out_;
  std::ostringstream progress_;
};

TEST_F(ParticleStudy, LocatesALaserInAHall) {
  const Result<Ended> ended = study(options());
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete) << out_.str();
  EXPECT_EQ(out_.str().find("LOST"), std::string::npos) << out_.str();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/particles.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/series/particles.json"));
}

TEST_F(ParticleStudy, GoesOnWhereItWasStopped) {
  const Result<Ended> stopped = study(options(), 80);
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_EQ(*stopped, Ended::stopped);
  progress_.str("");
  ASSERT_TRUE(study(options()));
  EXPECT_NE(progress_.str().find("2 rows to measure, 1 of them are there already"), std::string::npos)
      << progress_.str();
  const std::string table = out_.str();
  std::filesystem::remove_all(folder_ / "out");
  ASSERT_TRUE(study(options()));
  EXPECT_EQ(out_.str(), table) << "as measured at once";
}

TEST_F(ParticleStudy, SaysTheSameInOneDocument) {
  ParticlesOptions in_json = options();
  in_json.json = true;
  const Result<Ended> ended = study(in_json);
  ASSERT_TRUE(ended) << ended.error().message;
  const auto document = nlohmann::json::parse(out_.str());
  EXPECT_EQ(document.at("is_met"), *ended == Ended::complete);
  EXPECT_EQ(document.at("study").at("log"), "hall.log");
  ASSERT_EQ(document.at("rows").size(), 2U);
  EXPECT_EQ(document.at("rows")[1].at("seed"), 2);
  EXPECT_GT(document.at("rows")[1].at("mean_m"), 0.0);
}

TEST_F(ParticleStudy, FindsItselfFromAnywhere) {
  ParticlesOptions anywhere = options();
  anywhere.is_anywhere = true;
  anywhere.seeds = {1, 1};
  const Result<Ended> ended = study(anywhere);
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete) << out_.str();
}

TEST_F(ParticleStudy, AnotherAlphaIsAnotherStudy) {
  ASSERT_TRUE(study(options()));
  ParticlesOptions other = options();
  other.alpha = 0.1;
  const Result<Ended> ended = study(other);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, ErrorCode::conflict);
  EXPECT_NE(ended.error().message.find("alpha"), std::string::npos) << ended.error().message;
}

TEST_F(ParticleStudy, ALogThatIsNoneIsNamed) {
  ParticlesOptions bad = options();
  bad.log = folder_ / "none.log";
  EXPECT_EQ(study(bad).error().code, ErrorCode::not_found);
  std::ofstream(folder_ / "bad.log.gz") << "\x1f\x8b"
                                        << "no gzip";
  bad.log = folder_ / "bad.log.gz";
  const Result<Ended> ended = study(bad);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, ErrorCode::corrupt);
  EXPECT_NE(ended.error().message.find("bad.log.gz"), std::string::npos);
}

TEST(ParticlesInvocation, FlagsAndDefaults) {
  const auto plain = std::get<ParticlesOptions>(parsed({"particles", "data/intel-corrected.log.gz"}));
  EXPECT_EQ(plain.seeds.last, 3U);
  EXPECT_EQ(plain.alpha, 0.2);
  EXPECT_FALSE(plain.is_anywhere);
  EXPECT_FALSE(plain.json);
  EXPECT_EQ(plain.out, "out/particles/intel-corrected");
  const auto given = std::get<ParticlesOptions>(
      parsed({"particles", "a.log", "--alpha", "0.1", "--global", "--seeds", "4", "--out", "o", "--json"}));
  EXPECT_TRUE(given.json);
  EXPECT_EQ(given.alpha, 0.1);
  EXPECT_TRUE(given.is_anywhere);
  EXPECT_EQ(given.seeds.first, 4U);
  EXPECT_EQ(given.out, "o");
  EXPECT_EQ(std::get<NotRun>(parsed({"particles"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"particles", "a.log", "--alpha", "0"})).exit_code, 2);
}

}  // namespace
}  // namespace weft::evaluate::particles
