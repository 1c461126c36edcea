#include "clients/evaluate/floor/trace_file.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <system_error>
#include <vector>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr const char* kHeading =
    "frame,true_s,sensor_s,x,y,heading,odometry_x,odometry_y,odometry_heading,seen,matches,lost,kept,fix,fix_x,fix_y,"
    "fix_heading,believed_x,believed_y,believed_heading";
constexpr std::size_t kFields = 20;

std::string text_of(const Pose2& pose) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.6f,%.6f,%.7f", pose.x, pose.y, pose.heading);
  return text.data();
}

std::string row_of(const Moment& moment) {
  std::array<char, 96> times{};
  std::snprintf(times.data(), times.size(), "%llu,%.6f,%.6f,", static_cast<unsigned long long>(moment.frame),
                moment.true_s, moment.sensor_s);
  const std::string row = times.data() + text_of(moment.site_from_robot) + "," + text_of(moment.start_from_robot) +
                          "," + (moment.seen ? "1," : "0,") + std::to_string(moment.matches) +
                          (moment.lost ? ",1," : ",0,") + (moment.kept ? to_string(*moment.kept) : "") + ",";
  if (!moment.fix) return row + ",,,,,,";
  return row + to_string(moment.fix->place) + "," + text_of(moment.fix->measured) + "," +
         text_of(moment.fix->believed);
}

Pose2 pose_at(const std::vector<std::string>& fields, std::size_t at) {
  return {std::stod(fields[at]), std::stod(fields[at + 1]), std::stod(fields[at + 2])};
}

/// Throws what std::stod throws.
std::optional<Moment> moment_of(const std::string& row) {
  const std::vector<std::string> fields = csv_cells(row);
  if (fields.size() != kFields) return std::nullopt;
  Moment moment;
  moment.frame = std::stoull(fields[0]);
  moment.true_s = std::stod(fields[1]);
  moment.sensor_s = std::stod(fields[2]);
  moment.site_from_robot = pose_at(fields, 3);
  moment.start_from_robot = pose_at(fields, 6);
  moment.seen = fields[9] == "1";
  moment.matches = std::stoull(fields[10]);
  moment.lost = fields[11] == "1";
  moment.kept = parse_place_id(fields[12]);
  if (const std::optional<PlaceId> place = parse_place_id(fields[13])) {
    moment.fix = FixSeen{*place, pose_at(fields, 14), pose_at(fields, 17)};
  }
  return moment;
}

}  // namespace

Result<void> write_trace(const std::filesystem::path& file, const std::string& stamp, const Trace& trace) {
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  if (problem) return fail(ErrorCode::unavailable, file.parent_path().string() + ": " + problem.message());
  std::string text = "# " + stamp + "\n" + kHeading + "\n";
  for (const Moment& moment : trace.moments) text += row_of(moment) + "\n";
  return write_text(file, text);
}

std::optional<Trace> read_trace(const std::filesystem::path& file, const std::string& stamp) {
  std::ifstream in(file, std::ios::binary);
  std::string row;
  if (!std::getline(in, row) || row != "# " + stamp) return std::nullopt;
  if (!std::getline(in, row) || row != kHeading) return std::nullopt;
  Trace trace;
  try {
    while (std::getline(in, row)) {
      const std::optional<Moment> moment = moment_of(row);
      if (!moment) return std::nullopt;
      trace.moments.push_back(*moment);
    }
  } catch (const std::exception&) {
    return std::nullopt;  // not a number
  }
  if (trace.moments.empty()) return std::nullopt;
  return trace;
}

}  // namespace weft::evaluate::floor
