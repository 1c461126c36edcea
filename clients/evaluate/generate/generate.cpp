#include "clients/evaluate/generate/generate.hpp"

#include <algorithm>
#include <cmath>

#include "core/network/codec.hpp"

namespace weft::evaluate {
namespace {

constexpr double kBetweenLines_s = 2.0;

/// Prints a line now and then.
class Progress {
 public:
  Progress(const GenerationWatch& watch, std::uint64_t all)
      : watch_(watch), all_(all), began_s_(watch.steady_s()), said_s_(began_s_) {}

  void tell(std::uint64_t made, std::uint64_t written) {
    const double now_s = watch_.steady_s();
    if (now_s - said_s_ < kBetweenLines_s) return;
    said_s_ = now_s;
    const double rate = static_cast<double>(written) / std::max(1e-3, now_s - began_s_);
    watch_.progress << made << " of " << all_ << " places";
    if (written > 0) {
      watch_.progress << ", " << std::llround(rate) << " a second, "
                      << std::llround(static_cast<double>(all_ - made) / rate) << " s remain";
    }
    watch_.progress << std::endl;
  }

 private:
  const GenerationWatch& watch_;
  std::uint64_t all_;
  double began_s_;
  double said_s_;
};

storage::Transaction transaction(const SiteGenerator& generator, Batch batch, const ContentHash& hash) {
  storage::Transaction made;
  for (const Place& place : batch.places) {
    made.changes.emplace_back(
        storage::PutContent{place.content.hash, msg::ContentKind::content, generator.content(place.id)});
  }
  made.changes.emplace_back(storage::AppendBatch{std::move(batch), hash});
  return made;
}

Result<void> write_labels(storage::MapStore& store, const Snapshot::Labels& known, const SiteGenerator& generator) {
  storage::Transaction labels;
  for (const auto& [label, place] : generator.labels()) {
    const auto found = known.find(label);
    if (found != known.end() && found->second == place) continue;
    if (found != known.end()) {
      return fail(ErrorCode::conflict, "site: label \"" + label + "\" stands elsewhere in this store; use a new one");
    }
    labels.changes.emplace_back(storage::PutLabel{label, place});
  }
  if (labels.changes.empty()) return {};
  const auto done = store.commit(labels);
  if (!done) return fail(done.error());
  return {};
}

}  // namespace

Result<Generated> generate_site(storage::MapStore& store, const storage::Stored& stored, const SitePlan& plan,
                                const GenerationWatch& watch) {
  if (const auto good = check(plan); !good) return fail(good.error());
  SiteGenerator generator(plan);
  Generated result;
  Progress progress(watch, plan.places);
  while (!generator.is_done()) {
    if (watch.asked_to_stop()) return result;
    Batch batch = generator.next();
    const ContentHash its_hash = hash(batch);
    const auto there = store.batch_hash(batch.experience, batch.sequence);
    if (there && *there != its_hash) {
      return fail(ErrorCode::conflict,
                  "site: experience " + to_string(batch.experience) +
                      " is in the store with other places; use a new store, or the same numbers");
    }
    if (!there) {
      const auto done = store.commit(transaction(generator, std::move(batch), its_hash));
      if (!done) return fail(done.error());
      result.written += generator.made() - result.places;
    }
    result.places = generator.made();
    progress.tell(result.places, result.written);
  }
  if (const auto labelled = write_labels(store, stored.snapshot.labels(), generator); !labelled) {
    return fail(labelled.error());
  }
  result.is_complete = true;
  return result;
}

}  // namespace weft::evaluate
