#include "clients/evaluate/bearing/relocalise/led_study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "clients/evaluate/bearing/chosen.hpp"
#include "clients/evaluate/bearing/relocalise/kinds.hpp"
#include "clients/evaluate/bearing/relocalise/led_report.hpp"
#include "clients/evaluate/bearing/relocalise/led_rows.hpp"
#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::bearing {
namespace {

using agents::sim::Site;

/// Holds what a study needs at every step, beside its options.
struct Trying {
  const BearingRelocaliseOptions& options;
  const Site& like;
  const Study& study;
  std::vector<LookAlikes> kinds;
  LedRows& rows;
  RowsMeasured& progress;
  const Surroundings& around;
};

struct Hall {
  Aisles aisles;
  TaughtAisles taught;
};

Result<Site> site_from(const std::filesystem::path& file, std::string& text) {
  const Result<std::string> read = read_text(file, "site file; deploy/sites/bearing has some");
  if (!read) return fail(read.error());
  text = *read;
  Result<Site> site = agents::sim::parse_site(text, file.string());
  if (!site) return site;
  if (site->robots.empty() || site->robots.front().looks != std::vector<agents::Gaze>{agents::Gaze::ahead})
    return fail(ErrorCode::invalid,
                file.string() + ": its first [[robot]] does not look ahead alone (looks = [\"ahead\"])");
  return site;
}

std::size_t trials_in(const LedRows& rows, const LedKey& key) {
  const auto found = rows.trials.find(key);
  return found == rows.trials.end() ? 0 : found->second.size();
}

Drive drive_in(const Site& site, std::uint64_t seed, std::uint64_t day, const Trying& trying) {
  Drive drive;
  drive.body.site = site;
  drive.body.robot = site.robots.front().name;
  drive.body.seed = seed;
  drive.body.day = day;
  drive.asked_to_stop = trying.around.asked_to_stop;
  return drive;
}

PutDown put_down_for(const LookAlikes& kind, const Aisles& aisles, Random& random) {
  if (kind.where == LookAlikes::Where::anywhere) return anywhere(random);
  if (kind.where == LookAlikes::Where::not_taught) return on_the_line(aisles.left_out, random);
  const std::vector<std::size_t> taught = aisles.taught();
  return on_the_line(taught[random.below(taught.size())], random);
}

/// Tries what a row lacks of its trials, and keeps the row.
Result<Ended> fill_row(const Trying& trying, const LedKey& key, const LookAlikes& kind, const Hall& hall,
                       Leading& robot) {
  std::vector<Led>& trials = trying.rows.trials[key];
  while (trials.size() < trying.options.trials) {
    Random random = Random(key.seed).fork(trials.size());
    const Result<std::optional<Led>> led = robot.lead(put_down_for(kind, hall.aisles, random), hall.taught);
    if (!led) return fail(led.error());
    if (!*led) return Ended::stopped;
    trials.push_back(**led);
  }
  const auto found = std::count_if(trials.begin(), trials.end(), [](const Led& led) { return bool(led.found_m); });
  const auto wrong =
      std::count_if(trials.begin(), trials.end(), [](const Led& led) { return led.found_m && !is_right(led); });
  trying.progress.row(kind.name + ", " + key.light + ", seed " + std::to_string(key.seed) + ": " +
                      std::to_string(found - wrong) + " of " + std::to_string(trials.size()) + " found, " +
                      std::to_string(wrong) + " WRONG");
  if (const Result<void> kept = write_led(trying.options.out, trying.study, trying.rows); !kept)
    return fail(kept.error());
  return Ended::complete;
}

/// Tries a hall in one light, with another robot than the one that was taught in it.
Result<Ended> try_light(const Trying& trying, const std::vector<LookAlikes>& kinds, const OtherLight& light,
                        std::uint64_t seed, const Hall& hall) {
  constexpr std::uint64_t kOtherRobot = 1'000'000;
  Site site = hall.aisles.site;
  light.as(site);
  Result<Leading> robot = Leading::make(drive_in(site, seed + kOtherRobot, 1, trying));
  if (!robot) return fail(robot.error());
  for (const LookAlikes& kind : kinds) {
    const LedKey key{kind.name, light.name, seed};
    if (trials_in(trying.rows, key) >= trying.options.trials) continue;
    const Result<Ended> ended = fill_row(trying, key, kind, hall, *robot);
    if (!ended || *ended == Ended::stopped) return ended;
  }
  return Ended::complete;
}

Result<void> hold_hall(const Trying& trying, const Hall& hall, Loads loads, std::uint64_t seed) {
  constexpr std::size_t kPairs = 60;
  const auto body = agents::sim::make_sim_body(drive_in(hall.aisles.site, seed, 0, trying).body);
  if (!body) return fail(body.error());
  const Result<Pairs> pairs = hold_pairs((*body)->rig().camera(), hall.taught, kPairs, seed);
  if (!pairs) return fail(pairs.error());
  trying.rows.pairs[{name_of(loads), seed}] = *pairs;
  return {};
}

/// Teaches one hall and drives in it all kinds of trials that rows still lack.
Result<Ended> try_hall(const Trying& trying, const std::vector<LookAlikes>& kinds, std::uint64_t seed) {
  const bool has_all = std::all_of(kinds.begin(), kinds.end(), [&](const LookAlikes& kind) {
    return std::all_of(other_lights().begin(), other_lights().end(), [&](const OtherLight& light) {
      return trials_in(trying.rows, {kind.name, light.name, seed}) >= trying.options.trials;
    });
  });
  if (kinds.empty() || has_all) return Ended::complete;
  const Aisles aisles = aisles_like(trying.like, kinds.front().loads, seed);
  Result<std::optional<TaughtAisles>> taught = teach(drive_in(aisles.site, seed, 0, trying), aisles);
  if (!taught) return fail(taught.error());
  if (!*taught) return Ended::stopped;
  const Hall hall{aisles, std::move(**taught)};
  if (const Result<void> held = hold_hall(trying, hall, kinds.front().loads, seed); !held) return fail(held.error());
  for (const OtherLight& light : other_lights()) {
    const Result<Ended> ended = try_light(trying, kinds, light, seed, hall);
    if (!ended || *ended == Ended::stopped) return ended;
  }
  return Ended::complete;
}

Result<Ended> try_all(const Trying& trying) {
  for (std::uint64_t seed = trying.options.seeds.first; seed <= trying.options.seeds.last; ++seed) {
    for (const Loads loads : {Loads::other, Loads::one_side, Loads::same}) {
      std::vector<LookAlikes> kinds = trying.kinds;
      std::erase_if(kinds, [&](const LookAlikes& kind) { return kind.loads != loads; });
      const Result<Ended> ended = try_hall(trying, kinds, seed);
      if (!ended || *ended == Ended::stopped) return ended;
    }
  }
  return Ended::complete;
}

LedRows asked_for(const Trying& trying) {
  LedRows asked;
  const Seeds seeds = trying.options.seeds;
  for (const auto& [key, pairs] : trying.rows.pairs)
    if (key.second >= seeds.first && key.second <= seeds.last) asked.pairs.emplace(key, pairs);
  for (const auto& [key, trials] : trying.rows.trials) {
    const bool is_kind = std::any_of(trying.kinds.begin(), trying.kinds.end(),
                                     [&name = key.kind](const LookAlikes& kind) { return kind.name == name; });
    if (is_kind && key.seed >= seeds.first && key.seed <= seeds.last) asked.trials.emplace(key, trials);
  }
  return asked;
}

/// Writes for the picture the kinds in their order, and those of which no answer is right.
Result<void> write_kinds(const std::filesystem::path& out, const std::string& about) {
  nlohmann::json series = {{"about", about}, {"led_m", kLedM}, {"kinds", nlohmann::json::array()}};
  for (const LookAlikes& kind : look_alikes()) {
    const bool is_without_answer = kind.where == LookAlikes::Where::not_taught;
    series["kinds"].push_back({{"name", kind.name}, {"is_without_answer", is_without_answer}});
  }
  return write_series(out, "bearing-relocalise", series);
}

Result<Ended> report_led(const Trying& trying) {
  const LedRows asked = asked_for(trying);
  const std::filesystem::path& out = trying.options.out;
  if (const Result<void> csv = write_led_csv(out, asked); !csv) return fail(csv.error());
  const std::vector<LedGroup> groups = judge(asked);
  std::size_t count = 0;
  for (const LedGroup& group : groups) count += group.trials();
  const std::string about =
      "method bearing, " + words_of(trying.options.seeds) + ", " + std::to_string(count) + " trials";
  if (const Result<void> kept = write_kinds(out, about); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("bearing-relocalise", out, trying.around);
  trying.around.out << tables_of(asked) << std::flush;
  trying.around.progress << "weft-evaluate: relocalise.csv, relocalise.json and " << words_of(pictures) << " are in "
                         << out.string() << '\n';
  const bool all_met = std::all_of(groups.begin(), groups.end(), [](const LedGroup& group) { return group.met; });
  return all_met ? Ended::complete : Ended::missed;
}

}  // namespace

Result<Ended> study_look_alikes(const BearingRelocaliseOptions& options, const Surroundings& around) {
  Result<std::vector<LookAlikes>> kinds = chosen(look_alikes(), options.kind, "--kind");
  if (!kinds) return fail(kinds.error());
  std::string text;
  const Result<Site> like = site_from(options.site, text);
  if (!like) return fail(like.error());
  const Study study{WEFT_VERSION, sha256_of(text)};
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  Result<LedRows> rows = read_led(options.out, study);
  if (!rows) return fail(rows.error());
  std::size_t all = 0;
  std::size_t kept = 0;
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const LookAlikes& kind : *kinds) {
      for (const OtherLight& light : other_lights()) {
        ++all;
        kept += trials_in(*rows, {kind.name, light.name, seed}) >= options.trials ? 1 : 0;
      }
    }
  }
  RowsMeasured progress(all, kept, around);
  const Trying trying{options, *like, study, std::move(*kinds), *rows, progress, around};
  const Result<Ended> ended = try_all(trying);
  if (!ended || *ended == Ended::stopped) return ended;
  return report_led(trying);
}

}  // namespace weft::evaluate::bearing
