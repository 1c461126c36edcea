#include "clients/evaluate/floor/attempts/attempts_study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/attempts/attempt_report.hpp"
#include "clients/evaluate/floor/attempts/attempt_rows.hpp"
#include "clients/evaluate/floor/attempts/known_places.hpp"
#include "clients/evaluate/floor/attempts/navigating.hpp"
#include "clients/evaluate/floor/attempts/passages.hpp"
#include "clients/evaluate/floor/attempts/relating.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr double kMostAsideM = 1.2;          // of the middles of what view and place see
constexpr std::uint64_t kOtherPatch = 7919;  // added to a floor's seed
constexpr double kBinDegrees = 180.0 / std::numbers::pi * Recall::kBinRad;
constexpr std::size_t kOneInOther = 5;  // passages on another floor of the kind

/// Holds what all lights of a floor and seed share.
struct Ground {
  Scenario scenario;
  Taught taught;
};

/// Teaches a robot the floor of that kind and seed. None: stopped.
Result<std::optional<Ground>> ground_of(const Stage& stage, const std::string& kind, std::uint64_t seed) {
  Result<Scenario> scenario = Scenario::make(stage, kind, seed);
  if (!scenario) return fail(scenario.error());
  Taught taught;
  const Result<bool> done = teach(scenario->first(), scenario->line(), taught);
  if (!done) return fail(done.error());
  if (!*done) return std::optional<Ground>();
  return std::optional(Ground{std::move(*scenario), std::move(taught)});
}

agents::Twist some_motion(Random& random) {
  return {random.uniform(0.3, 0.8), random.uniform(-0.3, 0.3)};
}

/// Makes one row: passages of another robot on another day, until there are enough attempts. None: stopped.
class RowOfAttempts {
 public:
  /// Makes the other robot. Errors of the bodies, the method and the contents.
  static Result<RowOfAttempts> make(const Ground& ground, const std::string& light, Random random) {
    const Result<Drive> drive = ground.scenario.second(light);
    if (!drive) return fail(drive.error());
    Result<Passages> here = Passages::make(drive->body);
    if (!here) return fail(here.error());
    agents::sim::SimBodyConfig elsewhere = drive->body;
    elsewhere.site.floor.seed += kOtherPatch;
    Result<Passages> other = Passages::make(elsewhere);
    if (!other) return fail(other.error());
    Result<KnownPlaces> places = KnownPlaces::make(ground.taught, here->method());
    if (!places) return fail(places.error());
    return RowOfAttempts(*drive, std::move(*here), std::move(*other), std::move(*places), random);
  }

  Result<std::optional<Tally>> measure(const Ground& ground, std::size_t attempts) {
    Navigating navigating(here_.method(), ground.taught, places_);
    Tally tally;
    for (std::size_t i = 0; tally.attempts() < attempts; ++i) {
      if (drive_.asked_to_stop()) return std::optional<Tally>();
      const auto& place = places_.all()[random_.below(places_.all().size())].shows;
      const std::optional<Pose2> spot = spot_near(place, drive_.body.site, kMostAsideM, random_);
      if (!spot) continue;
      const bool is_other = i % kOneInOther == kOneInOther - 1;
      const Result<Passage> passage = (is_other ? other_ : here_).pass(*spot, some_motion(random_));
      if (!passage) return fail(passage.error());
      relate_passage(here_.method(), places_, *passage, is_other, random_, tally);
      navigating.navigate(*passage, is_other, random_, tally);
    }
    return std::optional(std::move(tally));
  }

 private:
  RowOfAttempts(Drive drive, Passages here, Passages other, KnownPlaces places, Random random)
      : drive_(std::move(drive)),
        here_(std::move(here)),
        other_(std::move(other)),
        places_(std::move(places)),
        random_(random) {}

  Drive drive_;
  Passages here_;
  Passages other_;
  KnownPlaces places_;
  Random random_;
};

std::vector<RowKey> keys_of(const Subject& subject, Seeds seeds) {
  std::vector<RowKey> keys;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    for (const std::string& kind : subject.kinds) {
      for (const std::string& light : subject.lights) keys.push_back({kind, light, seed});
    }
  }
  return keys;
}

/// Returns the generator of a row, so that each light has passages of its own.
Random random_of(const RowKey& key) {
  Random random(key.seed);
  const std::vector<std::string>& all = lights();
  const auto light = std::find(all.begin(), all.end(), key.part) - all.begin();
  return random.fork(static_cast<std::uint64_t>(light) + 1);
}

Result<Ended> attempt_all(const Subject& subject, const AttemptsStudy& study, const AttemptsOptions& options,
                          AttemptRows& rows, RowsMeasured& progress) {
  std::optional<Ground> ground;
  RowKey of_ground;
  for (const RowKey& key : keys_of(subject, options.seeds)) {
    if (rows.contains(key)) continue;
    if (!ground || of_ground.kind != key.kind || of_ground.seed != key.seed) {
      Result<std::optional<Ground>> made = ground_of(subject.stage, key.kind, key.seed);
      if (!made) return fail(made.error());
      if (!*made) return Ended::stopped;
      ground = std::move(**made);
      of_ground = key;
    }
    Result<RowOfAttempts> row = RowOfAttempts::make(*ground, key.part, random_of(key));
    if (!row) return fail(row.error());
    Result<std::optional<Tally>> tally = row->measure(*ground, study.attempts_a_row);
    if (!tally) return fail(tally.error());
    if (!*tally) return Ended::stopped;
    progress.row(key.kind + ", " + key.part + ", seed " + std::to_string(key.seed) + ": " +
                 std::to_string((*tally)->attempts()) + " attempts, " + std::to_string((*tally)->wrong()) + " WRONG");
    rows.insert_or_assign(key, std::move(**tally));
    if (const Result<void> kept = write_attempts(options.out, study, rows); !kept) return fail(kept.error());
  }
  return Ended::complete;
}

Result<Ended> report(const std::vector<RowKey>& keys, const AttemptRows& rows, const Subject& subject,
                     const AttemptsOptions& options, const Surroundings& around) {
  AttemptRows asked;
  Tally all;
  for (const RowKey& key : keys) {
    asked.emplace(key, rows.at(key));
    all.add(rows.at(key));
  }
  if (const Result<void> csv = write_attempts_csv(options.out, asked); !csv) return fail(csv.error());
  const std::string about = "site " + subject.stage.site.name + ", method floor, " + words_of(options.seeds) + ", " +
                            std::to_string(all.attempts()) + " attempts, " + std::to_string(all.wrong()) + " wrong";
  const nlohmann::json series = {{"about", about}, {"bin_m", Recall::kBinM}, {"bin_deg", kBinDegrees}};
  if (const Result<void> kept = write_series(options.out, "floor-attempts", series); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("floor-attempts", options.out, around);
  around.out << tables_of(asked) << std::flush;
  around.progress << "weft-evaluate: attempts.csv, attempts.json and " << words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  if (all.wrong() == 0) return Ended::complete;
  return fail(ErrorCode::refused, std::to_string(all.wrong()) + " of " + std::to_string(all.attempts()) +
                                      " attempts gave a wrong place; " + (options.out / "attempts.json").string() +
                                      " names each");
}

}  // namespace

Result<Ended> study_attempts(const AttemptsOptions& options, const Surroundings& around) {
  const Result<Subject> subject = subject_of(options, around.asked_to_stop);
  if (!subject) return fail(subject.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  const std::vector<RowKey> keys = keys_of(*subject, options.seeds);
  const AttemptsStudy study{subject->study, (options.attempts + keys.size() - 1) / keys.size()};
  Result<AttemptRows> rows = read_attempts(options.out, study);
  if (!rows) return fail(rows.error());
  const auto kept = std::count_if(keys.begin(), keys.end(), [&](const RowKey& key) { return rows->contains(key); });
  RowsMeasured progress(keys.size(), static_cast<std::size_t>(kept), around);
  const Result<Ended> ended = attempt_all(*subject, study, options, *rows, progress);
  if (!ended || *ended == Ended::stopped) return ended;
  return report(keys, *rows, *subject, options, around);
}

}  // namespace weft::evaluate::floor
