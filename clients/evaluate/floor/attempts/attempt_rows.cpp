#include "clients/evaluate/floor/attempts/attempt_rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/study_in.hpp"

namespace weft::evaluate::floor {
namespace {

using nlohmann::json;

json json_of(const AttemptsStudy& of) {
  json study = json_of(of.study);
  study["attempts_a_row"] = of.attempts_a_row;
  return study;
}

json json_of(const Pose2& pose) {
  return {pose.x, pose.y, pose.heading};
}
Pose2 pose_from(const json& pose) {
  return {pose.at(0).get<double>(), pose.at(1).get<double>(), pose.at(2).get<double>()};
}

json json_of(const Tally& tally) {
  json row = {{"sorts", json::object()}, {"recall", json::object()}, {"wrong", json::array()}};
  for (const auto& [sort, outcomes] : tally.sorts)
    row["sorts"][sort] = {{"right", outcomes.right}, {"wrong", outcomes.wrong}, {"refused", outcomes.refused}};
  for (const auto& [sort, recall] : tally.recalls) {
    row["recall"][sort] = {{"tried_by_metres", recall.tried_by_metres},
                           {"right_by_metres", recall.right_by_metres},
                           {"tried_by_heading", recall.tried_by_heading},
                           {"right_by_heading", recall.right_by_heading}};
  }
  for (const WrongOne& one : tally.wrong_ones) {
    row["wrong"].push_back({{"sort", one.sort},
                            {"off_m", one.off_m},
                            {"off_rad", one.off_rad},
                            {"site_from_robot", json_of(one.site_from_robot)},
                            {"site_from_place", json_of(one.site_from_place)},
                            {"place_from_robot", json_of(one.place_from_robot)}});
  }
  return row;
}

Tally tally_from(const json& row) {
  Tally tally;
  for (const auto& [sort, outcomes] : row.at("sorts").items()) {
    tally.sorts[sort] = {outcomes.at("right").get<std::size_t>(), outcomes.at("wrong").get<std::size_t>(),
                         outcomes.at("refused").get<std::map<std::string, std::size_t>>()};
  }
  for (const auto& [sort, recall] : row.at("recall").items()) {
    Recall& into = tally.recalls[sort];
    recall.at("tried_by_metres").get_to(into.tried_by_metres);
    recall.at("right_by_metres").get_to(into.right_by_metres);
    recall.at("tried_by_heading").get_to(into.tried_by_heading);
    recall.at("right_by_heading").get_to(into.right_by_heading);
  }
  for (const json& one : row.at("wrong")) {
    tally.wrong_ones.push_back({one.at("sort").get<std::string>(), number_from(one.at("off_m")),
                                number_from(one.at("off_rad")), pose_from(one.at("site_from_robot")),
                                pose_from(one.at("site_from_place")), pose_from(one.at("place_from_robot"))});
  }
  return tally;
}

std::filesystem::path json_in(const std::filesystem::path& folder) {
  return folder / "attempts.json";
}

}  // namespace

Result<AttemptRows> read_attempts(const std::filesystem::path& folder, const AttemptsStudy& study) {
  AttemptRows rows;
  const Result<void> read = read_rows_of(json_in(folder), json_of(study), "attempts", [&](const json& document) {
    for (const json& row : document.at("rows")) {
      rows.insert_or_assign(RowKey{row.at("floor").get<std::string>(), row.at("light").get<std::string>(),
                                   row.at("seed").get<std::uint64_t>()},
                            tally_from(row));
    }
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<std::optional<AttemptsStudy>> attempts_study_in(const std::filesystem::path& folder) {
  return study_in<AttemptsStudy>(json_in(folder), [](const json& study) {
    return AttemptsStudy{study_from(study), study.at("attempts_a_row").get<std::size_t>()};
  });
}

Result<void> write_attempts(const std::filesystem::path& folder, const AttemptsStudy& study,
                            const AttemptRows& rows) {
  json document = {{"study", json_of(study)}, {"rows", json::array()}};
  for (const auto& [key, tally] : rows) {
    json row = json_of(tally);
    row["floor"] = key.kind;
    row["light"] = key.part;
    row["seed"] = key.seed;
    document["rows"].push_back(std::move(row));
  }
  return write_text(json_in(folder), document.dump(1) + "\n");
}

Result<void> write_attempts_csv(const std::filesystem::path& folder, const AttemptRows& rows) {
  CsvText csv({"floor", "light", "seed", "attempt", "outcome", "count"});
  for (const auto& [key, tally] : rows) {
    const auto line = [&](const std::string& sort, const std::string& outcome, std::size_t count) {
      if (count == 0) return;
      csv.words(key.kind).words(key.part).value(key.seed).words(sort).words(outcome).value(count).end_row();
    };
    for (const auto& [sort, outcomes] : tally.sorts) {
      line(sort, "right", outcomes.right);
      line(sort, "WRONG", outcomes.wrong);
      for (const auto& [reason, count] : outcomes.refused) line(sort, reason, count);
    }
  }
  return write_text(folder / "attempts.csv", csv.text());
}

}  // namespace weft::evaluate::floor
