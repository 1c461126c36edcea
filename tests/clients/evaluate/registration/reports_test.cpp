#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "clients/evaluate/registration/pair_report.hpp"
#include "clients/evaluate/registration/rooms_report.hpp"
#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate::registration {
namespace {

Pose3 moved_by(double x) {
  Pose3 pose;
  pose.translation.x() = x;
  return pose;
}

TEST(PairReport, OursIsHeldAgainstTheTruth) {
  const std::vector<Answer> answers = {{"ours", moved_by(1.01), "", 2.0},
                                       {"GICP", std::nullopt, "not converged", 3.0}};
  const PairReport report = compared(answers, moved_by(1.0), {10, 20});
  EXPECT_TRUE(report.is_met);
  EXPECT_NEAR(report.rows[0].metres, 0.01, 1e-9);
  EXPECT_NE(table_of(report).find("met: ours within 0.02 m and 0.4 degrees of the truth"), std::string::npos);
  EXPECT_FALSE(compared(answers, moved_by(1.1), {10, 20}).is_met);
}

TEST(PairReport, WhereNobodyKnowsTheTruthOursIsHeldAgainstGicp) {
  const std::vector<Answer> answers = {{"ours", moved_by(1.025), "", 2.0}, {"GICP", moved_by(1.0), "", 3.0}};
  EXPECT_TRUE(compared(answers, std::nullopt, {}).is_met);
  const Answer refused{"ours", std::nullopt, "slides", 2.0};
  EXPECT_FALSE(compared({refused, answers[1]}, std::nullopt, {}).is_met);
}

TEST(PairReport, IsOneDocument) {
  const PairReport report = compared({{"ours", moved_by(1.5), "", 2.0}, {"GICP", std::nullopt, "not converged", 3.0}},
                                     moved_by(1.0), {10, 20});
  const auto document = nlohmann::json::parse(json_of(report));
  EXPECT_EQ(document.at("points").at("b"), 20);
  EXPECT_EQ(document.at("against"), "truth");
  EXPECT_EQ(document.at("rows").at(0).at("off_m"), 0.5);
  EXPECT_TRUE(document.at("rows").at(0).at("refused").is_null());
  EXPECT_TRUE(document.at("rows").at(1).at("off_m").is_null());
  EXPECT_EQ(document.at("rows").at(1).at("refused"), "not converged");
  EXPECT_EQ(document.at("asked").at("off_m"), 0.02);
  EXPECT_EQ(document.at("is_met"), false);
}

/// Returns a trial that took an error across the way to another one.
Trial trial_of(double before_m, double after_m, const std::string& refused = {}) {
  Trial trial;
  trial.before = {0.1, before_m, 0.01};
  trial.after = {0.1, after_m, 0.01};
  trial.refused = refused;
  return trial;
}

RoomsReport report_of(double after_m) {
  RoomsReport::Row row{"room", {}, {}};
  row.edges = over_seeds({summary_of({trial_of(0.1, after_m), trial_of(0.1, after_m)})});
  Trial joined = trial_of(0.1, 0.02);
  joined.after.along_m = 0.0;
  joined.after.heading_rad = 0.0;
  row.stitches.add({joined, trial_of(0.1, 0.1, "slides")});
  return {{row}};
}

TEST(RoomsReport, EdgesThatRegistrationMakesWorseMissTheBounds) {
  EXPECT_TRUE(report_of(0.05).is_met());
  EXPECT_FALSE(report_of(0.09).is_met()) << "0.9 of what it was";
  EXPECT_NE(tables_of(report_of(0.09)).find("NOT MET"), std::string::npos);
}

TEST(RoomsReport, IsOneDocument) {
  const auto document = nlohmann::json::parse(json_of(report_of(0.05)));
  const auto& edges = document.at("edges").at(0);
  EXPECT_EQ(edges.at("scene"), "room");
  EXPECT_EQ(edges.at("edges"), 2);
  EXPECT_NEAR(edges.at("across_ratio").at("median").get<double>(), 0.5, 1e-9);
  const auto& stitches = document.at("stitches").at(0);
  EXPECT_EQ(stitches.at("joined"), 1);
  EXPECT_EQ(stitches.at("refused").at("slides"), 1);
  EXPECT_NEAR(stitches.at("off_m").at("worst").get<double>(), 0.02, 1e-9);
  EXPECT_EQ(document.at("asked").at("off_m").at("worst"), 0.08);
  EXPECT_EQ(document.at("is_met"), true);
}

TEST(RoomsReport, WithoutStitchesTheirNumbersAreNull) {
  RoomsReport report = report_of(0.05);
  report.rows[0].stitches = {};
  const auto document = nlohmann::json::parse(json_of(report));
  EXPECT_TRUE(document.at("stitches").at(0).at("off_m").at("median").is_null());
}

TEST(RegistrationInvocation, JsonIsAFlag) {
  EXPECT_FALSE(std::get<RegisterOptions>(parsed({"register", "a.pcd", "b.pcd"})).json);
  EXPECT_TRUE(std::get<RegisterOptions>(parsed({"register", "a.pcd", "b.pcd", "--json"})).json);
  EXPECT_FALSE(std::get<RegisterRoomsOptions>(parsed({"register-rooms"})).json);
  EXPECT_TRUE(std::get<RegisterRoomsOptions>(parsed({"register-rooms", "--json"})).json);
}

}  // namespace
}  // namespace weft::evaluate::registration
