#include "tests/crashes/round.hpp"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "tests/crashes/keeper.hpp"
#include "tests/crashes/power_vfs.hpp"
#include "tests/crashes/producer.hpp"

namespace weft::crashes {
namespace {

struct Ends {
  int ours = -1;
  int theirs = -1;
};

Ends make_pipe() {
  int ends[2] = {-1, -1};
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

/// Holds all descriptors and children of a round; both are gone with it.
class Processes {
 public:
  Processes() : watch_(make_pipe()) {
    for (Ends& line : lines_) {
      int ends[2] = {-1, -1};
      if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) throw std::runtime_error("no socket");
      line = {ends[0], ends[1]};
    }
  }
  ~Processes() {
    for (const pid_t child : children_) ::kill(child, SIGKILL);
    for (const pid_t child : children_) ::waitpid(child, nullptr, 0);
    close_all();
    ::close(watch_.ours);
  }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  void start(const RoundPlan& plan, const Promised& promised, const std::string& vfs) {
    for (std::uint32_t producer = 0; producer < kProducers; ++producer) {
      fork_to([&] {
        const int line = ::dup(lines_[producer].theirs);
        const int watcher = ::dup(watch_.theirs);
        close_all();
        produce(plan.seed, producer, promised.durable_through[producer] + 1, line, watcher);
      });
    }
    keeper_ = fork_to([&] {
      std::array<int, kProducers> lines{};
      for (std::uint32_t at = 0; at < kProducers; ++at) {
        lines[at] = lines_[at].ours;
        ::close(lines_[at].theirs);
      }
      keep({plan.directory, plan.snapshot, vfs, plan.seed ^ (plan.round << 20U)}, lines, watch_.theirs);
    });
    close_all();
  }

  int watch() const { return watch_.ours; }
  void kill_keeper() const { ::kill(keeper_, SIGKILL); }
  /// Waits for the keeper. Returns how it ended.
  int wait_for_keeper() {
    int status = 0;
    ::waitpid(keeper_, &status, 0);
    std::erase(children_, keeper_);
    return status;
  }

 private:
  template <class Work>
  pid_t fork_to(const Work& work) {
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::signal(SIGPIPE, SIG_IGN);
      work();
      ::_exit(0);
    }
    children_.push_back(child);
    return child;
  }
  void close_all() {
    for (Ends& line : lines_) {
      ::close(line.ours);
      ::close(line.theirs);
      line = {};
    }
    ::close(watch_.theirs);
    watch_.theirs = -1;
  }

  Ends watch_;
  std::array<Ends, kProducers> lines_;
  std::vector<pid_t> children_;
  pid_t keeper_ = -1;
};

void note(const Report& report, Promised& promised) {
  promised.revision = std::max(promised.revision, report.revision);
  switch (report.kind) {
    case Report::Kind::acknowledged:
      promised.durable_through.at(report.producer) = report.number;
      return;
    case Report::Kind::edited:
      promised.edits[report.revision] = static_cast<Edit>(report.number);
      return;
    case Report::Kind::floored:
      promised.floor = report.revision;
      return;
    case Report::Kind::snapshot:
      promised.has_snapshot = true;
      promised.snapshot_revision = report.revision;
      return;
  }
}

/// Draws how the power fails: in a power loss the layer itself decides when.
PowerPlan power_plan(Random& random) {
  PowerPlan plan{random.next(), 20 + random.below(1500), 0, 0};
  if (random.chance(0.3)) {
    plan.full_from = 15 + random.below(plan.after);
    plan.full_to = plan.full_from + 1 + random.below(200);
  }
  return plan;
}

}  // namespace

std::string run_round(const RoundPlan& plan, Promised& promised) {
  Random random = Random(plan.seed).fork(plan.round);
  promised.has_snapshot = false;
  Processes processes;
  const PowerPlan power = power_plan(random);
  const bool is_killed = plan.death == Death::killed;
  std::uint64_t left = 1 + random.below(120);
  const auto wait_us = static_cast<unsigned>(random.below(3000));
  // The layer is registered in every child, and used by the keeper.
  processes.start(plan, promised, is_killed ? "" : register_power_vfs(power));
  Report report;
  bool is_dead = false;
  while (receive(processes.watch(), report)) {
    note(report, promised);
    if (is_killed && !is_dead && --left == 0) {
      ::usleep(wait_us);  // the moment of death is this round's input
      processes.kill_keeper();
      is_dead = true;
    }
  }
  const int status = processes.wait_for_keeper();
  if (is_killed ? WIFSIGNALED(status) : WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "the keeper gave up (status " + std::to_string(status) + ")";
}

}  // namespace weft::crashes
