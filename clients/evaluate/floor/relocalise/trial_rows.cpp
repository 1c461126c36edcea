#include "clients/evaluate/floor/relocalise/trial_rows.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

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
  const std::filesystem::path file = trials_in(folder);
  std::ifstream in(file, std::ios::binary);
  if (!in) return TrialRows{};
  TrialRows rows;
  try {
    const json document = json::parse(in);
    if (const std::string differs = difference(document.at("study"), json_of(study)); !differs.empty()) {
      return fail(ErrorCode::conflict, file.string() + ": holds the trials of another study (other " + differs +
                                           "); give another --out, or remove the file");
    }
    for (const json& row : document.at("rows")) {
      std::vector<Trial>& trials = rows[RowKey{row.at("floor").get<std::string>(), row.at("light").get<std::string>(),
                                               row.at("seed").get<std::uint64_t>()}];
      for (const json& trial : row.at("trials")) trials.push_back(trial_from(trial));
    }
  } catch (const json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
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
  std::ostringstream text;
  text << "floor,light,seed,along,x,y,heading,found_m,wrong,refused\n";
  for (const auto& [key, trials] : rows) {
    for (const Trial& trial : trials) {
      const Pose2& at = trial.site_from_robot;
      text << '"' << key.kind << "\",\"" << key.part << "\"," << key.seed << ',' << name_of(trial.along) << ','
           << at.x << ',' << at.y << ',' << at.heading << ',';
      if (trial.found_m) text << *trial.found_m;
      text << ',' << (trial.is_wrong ? 1 : 0) << ',' << trial.refused << '\n';
    }
  }
  return write_text(folder / "relocalise.csv", text.str());
}

}  // namespace weft::evaluate::floor
