#include "storage/formats/trajectory.hpp"

#include <array>
#include <cmath>

#include "storage/formats/lines.hpp"
#include "storage/formats/unit.hpp"

namespace weft::formats {
namespace {

constexpr std::size_t kNumbers = 8;
using Numbers = std::array<double, kNumbers>;

/// Bounds the times in seconds that are believed, by one in the year 2286; counted in milliseconds or finer, nearly
/// every time since 1970 is above it.
constexpr double kLatest_s = 1e10;

/// Returns the unit that a time above `kLatest_s` seems to be counted in, and what to do about it.
const char* seeming_unit(double time) {
  constexpr double kMicroseconds = 1e14;
  constexpr double kNanoseconds = 1e17;
  if (time >= kNanoseconds) return "nanoseconds; divide them by 1e9";
  return time >= kMicroseconds ? "microseconds; divide them by 1e6"
                               : "milliseconds, or nanoseconds since a start; turn them into seconds";
}

/// Adds samples and holds them to what a trajectory is.
class TrajectoryBuilder {
 public:
  TrajectoryBuilder(const Lines& lines, std::string_view file) : lines_(lines), file_(file) {}

  tl::unexpected<Error> wrong(const std::string& what) const { return fail_at(file_, lines_.number(), what); }

  Result<Numbers> numbers_of(const std::vector<std::string_view>& words) const {
    Numbers numbers{};
    for (std::size_t i = 0; i < kNumbers; ++i) {
      const std::optional<double> number = parse_finite(words[i]);
      if (!number.has_value()) return wrong(cited(words[i]) + " is no finite number");
      numbers[i] = *number;
    }
    return numbers;
  }

  Result<void> add(double time_s, const Numbers& numbers, const std::array<std::size_t, 4>& wxyz) {
    if (!trajectory.samples.empty() && time_s == trajectory.samples.back().time_s) {
      leftovers.note("a second pose of one time", lines_.number());
      return {};
    }
    if (!trajectory.samples.empty() && time_s < trajectory.samples.back().time_s) {
      return wrong("time " + text_of(time_s) + " is before the last one, " +
                   text_of(trajectory.samples.back().time_s));
    }
    const std::optional<Eigen::Quaterniond> unit =
        unit_quaternion(numbers[wxyz[0]], numbers[wxyz[1]], numbers[wxyz[2]], numbers[wxyz[3]]);
    if (!unit.has_value()) return wrong("the quaternion is not unit within 1e-3");
    trajectory.samples.push_back({time_s, {*unit, {numbers[1], numbers[2], numbers[3]}}});
    return {};
  }

  Trajectory trajectory;
  Leftovers leftovers;

 private:
  const Lines& lines_;
  std::string_view file_;
};

}  // namespace

Result<Read<Trajectory>> read_tum(std::string_view text, std::string_view file) {
  Lines lines(text);
  TrajectoryBuilder builder(lines, file);
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::vector<std::string_view> words = words_of(*line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (words.size() != kNumbers) {
      return builder.wrong(std::to_string(words.size()) + " numbers; a pose has 8: t x y z qx qy qz qw");
    }
    const Result<Numbers> numbers = builder.numbers_of(words);
    if (!numbers) return fail(numbers.error());
    const double time_s = numbers->front();
    if (std::abs(time_s) > kLatest_s) {
      return builder.wrong("time " + std::string(words.front()) + " is not within +-1e10 s; these seem to be " +
                           seeming_unit(std::abs(time_s)));
    }
    if (const Result<void> added = builder.add(time_s, *numbers, {7, 4, 5, 6}); !added) return fail(added.error());
  }
  return Read<Trajectory>{std::move(builder.trajectory), builder.leftovers.take()};
}

Result<Read<Trajectory>> read_euroc_csv(std::string_view text, std::string_view file) {
  Lines lines(text);
  TrajectoryBuilder builder(lines, file);
  while (const std::optional<std::string_view> line = lines.next()) {
    if (trimmed(*line).empty() || trimmed(*line).starts_with('#')) continue;
    const std::vector<std::string_view> cells = cells_of(*line, ',');
    if (cells.size() < kNumbers) {
      return builder.wrong(std::to_string(cells.size()) +
                           " cells; a pose has 8: nanoseconds, x, y, z, qw, qx, qy, qz");
    }
    if (!parse_unsigned(cells.front()).has_value()) {
      return builder.wrong(cited(cells.front()) + " is no time in whole nanoseconds");
    }
    const Result<Numbers> numbers = builder.numbers_of(cells);
    if (!numbers) return fail(numbers.error());
    if (const Result<void> added = builder.add((*numbers)[0] / 1e9, *numbers, {4, 5, 6, 7}); !added) {
      return fail(added.error());
    }
    if (cells.size() > kNumbers) builder.leftovers.note("columns after the quaternion", lines.number());
  }
  return Read<Trajectory>{std::move(builder.trajectory), builder.leftovers.take()};
}

std::string tum_text(const Trajectory& trajectory) {
  std::string text = "# t x y z qx qy qz qw\n";
  for (const auto& [time_s, pose] : trajectory.samples) {
    text += text_of(time_s);
    for (const double value : pose.translation) text += " " + text_of(value);
    for (const double value : pose.rotation.coeffs()) text += " " + text_of(value);
    text += '\n';
  }
  return text;
}

}  // namespace weft::formats
