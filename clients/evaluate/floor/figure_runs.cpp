#include "clients/evaluate/floor/figure_runs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "clients/evaluate/floor/trace_file.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr std::array kRates = {60.0, 30.0, 15.0, 7.5};
constexpr double kRatesOverM = 12.0;
constexpr const char* kTwoRepeated = "both-repeated";

std::string rate_run(double fps) {
  return std::to_string(static_cast<int>(10.0 * fps)) + "-in-10s";
}
std::string two_run(std::size_t i) {
  return "both-taught-" + std::to_string(i + 1);
}

/// Adds the beginning of the line led at several frame rates. Returns false when it was stopped.
Result<bool> add_rates(const Scenario& scenario, const Shelf& shelf, Shown& shown) {
  const std::vector<agents::SitePoint> line = scenario.line_beginning(kRatesOverM);
  for (const double fps : kRates) {
    std::optional<Trace> trace = shelf.find(rate_run(fps));
    if (!trace) {
      Result<std::optional<Trace>> led = lead(scenario.at_rate(fps), line);
      if (!led) return fail(led.error());
      if (!*led) return false;
      if (const Result<void> kept = shelf.keep(rate_run(fps), **led); !kept) return fail(kept.error());
      trace = std::move(*led);
    }
    shown.at_rates[fps] = std::move(*trace);
  }
  return true;
}

/// Adds the taught way and its repeat under a light. Returns false when it was stopped.
Result<bool> add_way(const Scenario& scenario, const std::string& light, const Shelf& shelf, Shown& shown) {
  std::optional<Trace> taught = shelf.find(kTaughtRun);
  std::optional<Trace> repeated = shelf.find(light);
  if (!taught || !repeated) {
    Taught map;
    const Result<bool> done = teach(scenario.first(), scenario.line(), map);
    if (!done || !*done) return done;
    const Result<Drive> drive = scenario.second(light);
    if (!drive) return fail(drive.error());
    Result<std::optional<Repeated>> driven = repeat(*drive, map);
    if (!driven) return fail(driven.error());
    if (!*driven) return false;
    taught = std::move(map.traces.front());
    repeated = std::move((*driven)->trace);
    if (const Result<void> kept = shelf.keep(kTaughtRun, *taught); !kept) return fail(kept.error());
    if (const Result<void> kept = shelf.keep(light, *repeated); !kept) return fail(kept.error());
  }
  shown.taught = std::move(*taught);
  shown.repeated = std::move(*repeated);
  return true;
}

/// Adds a robot taught from the middle of the first one's way on, and a third that drives over both. False: stopped.
Result<bool> add_two(const Scenario& scenario, const Shelf& shelf, Shown& shown) {
  std::optional<Trace> first = shelf.find(two_run(0));
  std::optional<Trace> second = shelf.find(two_run(1));
  std::optional<Trace> repeated = shelf.find(kTwoRepeated);
  if (!first || !second || !repeated) {
    Taught map;
    const Result<bool> one = teach(scenario.first(), scenario.first_part(), map);
    if (!one || !*one) return one;
    const Result<bool> two = teach(scenario.other_on_second_part(), scenario.second_part(), map);
    if (!two && two.error().code != ErrorCode::refused) return two;
    if (two && !*two) return two;
    const Result<Drive> drive = scenario.second(lights().front());
    if (!drive) return fail(drive.error());
    Result<std::optional<Repeated>> driven = repeat(*drive, map);
    if (!driven) return fail(driven.error());
    if (!*driven) return false;
    first = std::move(map.traces.front());
    second = two ? std::move(map.traces.back()) : Trace{{Moment{}}, {}, 0.0};
    repeated = std::move((*driven)->trace);
    if (const Result<void> kept = shelf.keep(two_run(0), *first); !kept) return fail(kept.error());
    if (const Result<void> kept = shelf.keep(two_run(1), *second); !kept) return fail(kept.error());
    if (const Result<void> kept = shelf.keep(kTwoRepeated, *repeated); !kept) return fail(kept.error());
  }
  shown.two_taught = {std::move(*first), std::move(*second)};
  shown.two_repeated = std::move(*repeated);
  return true;
}

}  // namespace

std::filesystem::path Shelf::file(const std::string& what) const {
  return folder / (kind + "-" + what + "-" + std::to_string(seed) + ".csv");
}

std::optional<Trace> Shelf::find(const std::string& what) const {
  return read_trace(file(what), stamp);
}

Result<void> Shelf::keep(const std::string& what, const Trace& trace) const {
  return write_trace(file(what), stamp, trace);
}

bool has_shown(const std::string& light, const Shelf& shelf) {
  std::vector<std::string> runs = {kTaughtRun, light, two_run(0), two_run(1), kTwoRepeated};
  for (const double fps : kRates) runs.push_back(rate_run(fps));
  return std::all_of(runs.begin(), runs.end(), [&](const std::string& run) { return shelf.find(run).has_value(); });
}

Result<std::optional<Shown>> shown_of(const Scenario& scenario, const std::string& light, const Shelf& shelf) {
  Shown shown;
  shown.kind = shelf.kind;
  const Result<bool> way = add_way(scenario, light, shelf, shown);
  if (!way) return fail(way.error());
  const Result<bool> rates = *way ? add_rates(scenario, shelf, shown) : way;
  if (!rates) return fail(rates.error());
  const Result<bool> two = *rates ? add_two(scenario, shelf, shown) : rates;
  if (!two) return fail(two.error());
  if (!*two) return std::optional<Shown>();
  return std::optional(std::move(shown));
}

}  // namespace weft::evaluate::floor
