#include "clients/evaluate/bearing/relocalise/led_rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::bearing {
namespace {

using LedJson = nlohmann::json;

LedJson led_study(const Study& study) {
  return {{"software", study.software}, {"scenes_sha256", study.scenes_sha256}};
}

LedJson json_of(const Led& led) {
  const Pose2& at = led.site_from_robot;
  return {{"x", at.x},
          {"y", at.y},
          {"heading", at.heading},
          {"found_m", led.found_m ? LedJson(*led.found_m) : LedJson()},
          {"along_m", led.along_m},
          {"aside_m", led.aside_m},
          {"turned_rad", led.turned_rad},
          {"sigma_m", led.sigma_m},
          {"refused", led.refused}};
}

Led led_from(const LedJson& row) {
  Led led;
  led.site_from_robot = {row.at("x").get<double>(), row.at("y").get<double>(), row.at("heading").get<double>()};
  if (!row.at("found_m").is_null()) led.found_m = row.at("found_m").get<double>();
  led.along_m = row.at("along_m").get<double>();
  led.aside_m = row.at("aside_m").get<double>();
  led.turned_rad = row.at("turned_rad").get<double>();
  led.sigma_m = row.at("sigma_m").get<double>();
  led.refused = row.at("refused").get<std::string>();
  return led;
}

std::filesystem::path led_in(const std::filesystem::path& folder) {
  return folder / "relocalise.json";
}

}  // namespace

Result<LedRows> read_led(const std::filesystem::path& folder, const Study& study) {
  LedRows rows;
  const Result<void> read = read_rows_of(led_in(folder), led_study(study), "trials", [&](const LedJson& document) {
    for (const LedJson& row : document.at("rows")) {
      std::vector<Led>& trials =
          rows.trials[LedKey{row.at("kind").get<std::string>(), row.at("light").get<std::string>(),
                             row.at("seed").get<std::uint64_t>()}];
      for (const LedJson& trial : row.at("trials")) trials.push_back(led_from(trial));
    }
    for (const LedJson& row : document.at("pairs"))
      rows.pairs[{row.at("loads").get<std::string>(), row.at("seed").get<std::uint64_t>()}] = {
          row.at("tried").get<std::size_t>(), row.at("voted").get<std::size_t>(),
          row.at("related").get<std::size_t>()};
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_led(const std::filesystem::path& folder, const Study& study, const LedRows& rows) {
  LedJson document = {{"study", led_study(study)}, {"rows", LedJson::array()}, {"pairs", LedJson::array()}};
  for (const auto& [key, trials] : rows.trials) {
    LedJson row = {{"kind", key.kind}, {"light", key.light}, {"seed", key.seed}, {"trials", LedJson::array()}};
    for (const Led& led : trials) row["trials"].push_back(json_of(led));
    document["rows"].push_back(std::move(row));
  }
  for (const auto& [key, pairs] : rows.pairs)
    document["pairs"].push_back({{"loads", key.first},
                                 {"seed", key.second},
                                 {"tried", pairs.tried},
                                 {"voted", pairs.voted},
                                 {"related", pairs.related}});
  return write_text(led_in(folder), document.dump() + "\n");
}

Result<void> write_led_csv(const std::filesystem::path& folder, const LedRows& rows) {
  CsvText csv({"kind", "light", "seed", "x", "y", "heading", "found_m", "right", "along_m", "aside_m", "turned_rad",
               "sigma_m", "refused"});
  for (const auto& [key, trials] : rows.trials) {
    for (const Led& led : trials) {
      const Pose2& at = led.site_from_robot;
      csv.value(key.kind).value(key.light).value(key.seed).value(at.x).value(at.y).value(at.heading);
      if (led.found_m) {
        csv.value(*led.found_m).value(is_right(led) ? 1 : 0).value(led.along_m).value(led.aside_m);
        csv.value(led.turned_rad).value(led.sigma_m).empty().end_row();
      } else {
        csv.empty(6).value(led.refused).end_row();
      }
    }
  }
  return write_text(folder / "relocalise.csv", csv.text());
}

}  // namespace weft::evaluate::bearing
