#include "clients/evaluate/odometry/row_file.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::odometry {
namespace {

using nlohmann::json;

json json_of_row(const Row& row) {
  return {{"floor", row.kind},
          {"seed", row.seed},
          {"drive", row.drive},
          {"observer", row.observer},
          {"speed_percent", row.speed_percent},
          {"drift_mm", row.drift_mm},
          {"drift_deg", row.drift_deg},
          {"blind_percent", row.blind_percent},
          {"ms_a_view", row.ms_a_view},
          {"over_1m", row.over_1m},
          {"over_10m", row.over_10m}};
}

Row row_from(const json& row) {
  return {row.at("floor").get<std::string>(),
          row.at("seed").get<std::uint64_t>(),
          row.at("drive").get<std::string>(),
          row.at("observer").get<std::string>(),
          number_from(row.at("speed_percent")),
          number_from(row.at("drift_mm")),
          number_from(row.at("drift_deg")),
          number_from(row.at("blind_percent")),
          number_from(row.at("ms_a_view")),
          row.at("over_1m").get<std::vector<double>>(),
          row.at("over_10m").get<std::vector<double>>()};
}

std::filesystem::path rows_in(const std::filesystem::path& folder) {
  return folder / "odometry.json";
}

}  // namespace

Result<std::vector<Row>> read_odometry_rows(const std::filesystem::path& folder, const floor::Study& study) {
  std::vector<Row> rows;
  const Result<void> read = read_rows_of(rows_in(folder), floor::json_of(study), "rows", [&](const json& document) {
    for (const json& row : document.at("rows")) rows.push_back(row_from(row));
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_odometry_rows(const std::filesystem::path& folder, const floor::Study& study,
                                 const std::vector<Row>& rows) {
  json document = {{"study", floor::json_of(study)}, {"rows", json::array()}};
  for (const Row& row : rows) document["rows"].push_back(json_of_row(row));
  if (const Result<void> kept = write_text(rows_in(folder), document.dump() + "\n"); !kept) return kept;
  return write_text(folder / "odometry.csv", csv_of(rows));
}

}  // namespace weft::evaluate::odometry
