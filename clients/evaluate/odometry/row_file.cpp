#include "clients/evaluate/odometry/row_file.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::odometry {
namespace {

using nlohmann::json;

json number(double value) {
  return std::isfinite(value) ? json(value) : json();
}
double number_from(const json& value) {
  return value.is_null() ? floor::Score::kNothing : value.get<double>();
}

json json_of_row(const Row& row) {
  return {{"floor", row.kind},
          {"seed", row.seed},
          {"drive", row.drive},
          {"observer", row.observer},
          {"speed_percent", number(row.speed_percent)},
          {"drift_mm", number(row.drift_mm)},
          {"drift_deg", number(row.drift_deg)},
          {"blind_percent", number(row.blind_percent)},
          {"ms_a_view", number(row.ms_a_view)},
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
  const std::filesystem::path file = rows_in(folder);
  std::ifstream in(file, std::ios::binary);
  std::vector<Row> rows;
  if (!in) return rows;
  try {
    const json document = json::parse(in);
    if (const std::string differs = difference(document.at("study"), floor::json_of(study)); !differs.empty()) {
      return fail(ErrorCode::conflict, file.string() + ": holds the rows of another study (other " + differs +
                                           "); give another --out, or remove the file");
    }
    for (const json& row : document.at("rows")) rows.push_back(row_from(row));
  } catch (const json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
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
