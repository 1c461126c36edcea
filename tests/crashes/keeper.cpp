#include "tests/crashes/keeper.hpp"

#include <poll.h>

#include <iostream>
#include <optional>
#include <vector>

#include "core/network/codec.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/crashes/wire.hpp"

namespace weft::crashes {
namespace {

using namespace storage;

/// Ends the process at a failure of the store that is none of this round's faults.
[[noreturn]] void give_up(const Error& error) {
  std::cerr << "keeper: " << to_string(error.code) << ": " << error.message << '\n';
  ::_exit(3);
}

class Keeper {
 public:
  Keeper(const KeeperPlan& plan, MapStore& store, const Stored& stored, int watcher)
      : plan_(plan), store_(store), random_(plan.seed), watcher_(watcher), newest_(stored.snapshot.revision()) {
    for (const auto& [id, experience] : stored.snapshot.experiences()) extents_[id] = experience->extent;
  }

  void take(const sample::Delivery& delivery, int producer) {
    const auto committed = commit(sample::transaction(delivery));
    if (!committed) give_up(committed.error());
    extents_[delivery.batch.experience] = delivery.batch.places.back().id.index + 1;
    if (!send(producer, Answer{delivery.batch.sequence, committed->revision.value})) ::_exit(0);
    for (std::uint64_t edits = random_.below(8); edits > 6; --edits) edit();
    upkeep();
  }

 private:
  /// Commits; waits for room on a full disk, as the server does.
  Result<Commit> commit(const Transaction& transaction) {
    for (;;) {
      Result<Commit> done = store_.commit(transaction);
      if (done) newest_ = done->revision;
      if (done || done.error().code != ErrorCode::exhausted) return done;
    }
  }

  void edit() {
    const Transaction transaction = draw();
    if (transaction.changes.empty()) return;
    const auto committed = commit(transaction);
    if (!committed) {  // a compaction has deleted it
      if (committed.error().code != ErrorCode::conflict) give_up(committed.error());
      return;
    }
    if (!send(watcher_, Report{Report::Kind::edited, 0, static_cast<std::uint64_t>(edit_), newest_.value}))
      ::_exit(0);
  }

  Transaction draw() {
    const auto experience = extents_.find(experience_of(static_cast<std::uint32_t>(random_.below(kProducers))));
    if (experience == extents_.end()) return {};
    const auto first = static_cast<std::uint32_t>(random_.below(experience->second));
    const auto last =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(first + random_.below(6), experience->second - 1));
    switch (random_.below(6)) {
      case 0:
        if (out_.empty()) return {};
        edit_ = Edit::back;
        return {{BringBack{out_[random_.below(out_.size())]}}, {}};
      case 1: {
        const std::uint64_t oldest = store_.size().floor.value;
        if (newest_.value < oldest + 4) return {};
        edit_ = Edit::rollback;
        return {{RollBack{{newest_.value - 1 - random_.below(3)}}}, {}};
      }
      case 2:
        edit_ = Edit::label;
        return {{PutLabel{"label" + std::to_string(random_.below(3)), {experience->first, first}}}, {}};
      default:
        edit_ = Edit::out;
        out_.push_back({{{experience->first, first, last}}, {}});
        return {{TakeOut{out_.back()}}, {}};
    }
  }

  void upkeep() {
    if (!job_) begin_job();
    for (int steps = 0; job_ && steps < 3; ++steps) step_job();
  }

  void begin_job() {
    const std::uint64_t kind = random_.below(12);
    const std::uint64_t floor = store_.size().floor.value;
    is_snapshot_ = kind == 1;
    auto begun = kind == 0 && newest_.value > floor + 20 ? store_.compact({newest_.value - random_.below(15)})
                 : kind == 1                             ? store_.snapshot_to(plan_.snapshot)
                 : kind == 2                             ? store_.check()
                                                         : Result<std::unique_ptr<StoreJob>>(nullptr);
    if (begun) job_ = std::move(*begun);
    if (kind == 0) report_floor();
  }

  void report_floor() {
    const Report floor{Report::Kind::floored, 0, 0, store_.size().floor.value};
    if (floor.revision > 0 && !send(watcher_, floor)) ::_exit(0);
  }

  void step_job() {
    const auto progress = job_->step();
    if (!progress) {  // a full disk; the next one goes on
      if (progress.error().code != ErrorCode::exhausted) give_up(progress.error());
      job_.reset();
    } else if (progress->finished) {
      if (!progress->findings.empty()) give_up({ErrorCode::corrupt, progress->findings.front()});
      if (is_snapshot_ && !send(watcher_, Report{Report::Kind::snapshot, 0, 0, newest_.value})) ::_exit(0);
      job_.reset();
    }
  }

  const KeeperPlan& plan_;
  MapStore& store_;
  Random random_;
  int watcher_;
  Revision newest_;
  std::map<ExperienceId, std::uint32_t> extents_;
  std::vector<Removal> out_;
  Edit edit_ = Edit::out;
  std::unique_ptr<StoreJob> job_;
  bool is_snapshot_ = false;
};

/// Opens the store; waits for room on a full disk, as the epoch needs a write, too.
Stored open_patiently(MapStore& store) {
  for (;;) {
    auto stored = store.open();
    if (stored) return std::move(*stored);
    if (stored.error().code != ErrorCode::exhausted) give_up(stored.error());
  }
}

}  // namespace

void keep(const KeeperPlan& plan, const std::array<int, kProducers>& producers, int watcher) {
  // As the server has it; the file layer that takes the power away draws its faults for one thread.
  const SqliteOptions options{.vfs = plan.vfs, .empties_log_aside = plan.vfs.empty()};
  auto store = open_sqlite(plan.directory, options);
  while (!store && store.error().code == ErrorCode::exhausted) store = open_sqlite(plan.directory, options);
  if (!store) give_up(store.error());
  Keeper keeper(plan, **store, open_patiently(**store), watcher);
  std::array<pollfd, kProducers> ends{};
  for (std::uint32_t at = 0; at < kProducers; ++at) ends[at] = {producers[at], POLLIN, 0};
  for (;;) {
    if (::poll(ends.data(), ends.size(), -1) < 0) return;
    for (const pollfd& end : ends) {
      if ((end.revents & (POLLIN | POLLHUP)) == 0) continue;
      sample::Delivery delivery;
      if (!receive_delivery(end.fd, delivery)) return;
      keeper.take(delivery, end.fd);
    }
  }
}

}  // namespace weft::crashes
