#include "clients/evaluate/floor/relocalise/trial_rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/study_in.hpp"

namespace weft::evaluate::floor {
namespace {

using nlohmann::json;

json json_of(const Trial& trial) {
  const Pose2& at = trial.site_from_robot;
  return {{"along", name_of(trial.along)},
          {"x", at.x},
          {"y", at.y},
          {"heading", at.heading},
          {"found_m", trial.found_m ? json(*trial.found_m) : json()},
          {"wrong", trial.is_wrong},
          {"refused", trial.refused}};
}

Trial trial_from(const json& row) {
  Trial trial;
  trial.along = row.at("along").get<std::string>() == name_of(Along::forwards) ? Along::forwards : Along::backwards;
  trial.site_from_robot = {row.at("x").get<double>(), row.at("y").get<double>(), row.at("heading").get<double>()};
  if (!row.at("found_m").is_null()) trial.found_m = row.at("found_m").get<double>();
  trial.is_wrong = row.at("wrong").get<bool>();
  trial.refused = row.at("refused").get<std::string>();
  return trial;
}

std::filesystem::path trials_in(const std::filesystem::path& folder) {
  return folder / "relocalise.json";
}

}  // namespace

Result<TrialRows> read_trials(const std::filesystem::path& folder, const Study& study) {
  TrialRows rows;
  const Result<void> read = read_rows_of(trials_in(folder), json_of(study), "trials", [&](const json& document) {
    for (const json& row : document.at("rows")) {
      std::vector<Trial>& trials = rows[RowKey{row.at("floor").get<std::string>(), row.at("light").get<std::string>(),
                                               row.at("seed").get<std::uint64_t>()}];
      for (const json& trial : row.at("trials")) trials.push_back(trial_from(trial));
    }
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<std::optional<Study>> trials_study_in(const std::filesystem::path& folder) {
  return study_in<Study>(trials_in(folder), study_from);
}

Result<void> write_trials(const std::filesystem::path& folder, const Study& study, const TrialRows& rows) {
  json document = {{"study", json_of(study)}, {"rows", json::array()}};
  for (const auto& [key, trials] : rows) {
    json row = {{"floor", key.kind}, {"light", key.part}, {"seed", key.seed}, {"trials", json::array()}};
    for (const Trial& trial : trials) row["trials"].push_back(json_of(trial));
    document["rows"].push_back(std::move(row));
  }
  return write_text(trials_in(folder), document.dump() + "\n");
}

Result<void> write_trials_csv(const std::filesystem::path& folder, const TrialRows& rows) {
  CsvText csv({"floor", "light", "seed", "along", "x", "y", "heading", "found_m", "wrong", "refused"});
  for (const auto& [key, trials] : rows) {
    for (const Trial& trial : trials) {
      const Pose2& at = trial.site_from_robot;
      csv.words(key.kind).words(key.part).value(key.seed).value(name_of(trial.along));
      csv.value(at.x).value(at.y).value(at.heading);
      trial.found_m ? csv.value(*trial.found_m) : csv.empty();
      csv.value(trial.is_wrong ? 1 : 0).value(trial.refused).end_row();
    }
  }
  return write_text(folder / "relocalise.csv", csv.text());
}

}  // namespace weft::evaluate::floor
