// tests/crash: a store under eight producers, killed or cut off from power at any moment, round after round; after
// each everything that it has promised is looked at.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>

#include "tests/crashes/verify.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace {

using namespace weft::crashes;

constexpr std::uint64_t kRoundsAStore = 40;  // each looks at all that came before: a new store keeps rounds short
constexpr std::size_t kShown = 10;

struct Totals {
  std::uint64_t batches = 0;
  std::uint64_t edits = 0;
  std::uint64_t kills = 0;
  std::uint64_t power_losses = 0;
  std::uint64_t snapshots = 0;
};

std::uint64_t batches_of(const Promised& promised) {
  return std::accumulate(promised.durable_through.begin(), promised.durable_through.end(), std::uint64_t{0});
}

/// Tells how far the rounds are: one line over the last on a terminal; now and then a line of its own elsewhere.
class Progress {
 public:
  explicit Progress(std::uint64_t rounds) : rounds_(rounds) {}
  void tell(std::uint64_t round, std::uint64_t batches) {
    const auto now = Clock::now();
    if (round < rounds_ && now - last_ < std::chrono::seconds(is_terminal_ ? 1 : 10)) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - begun_).count();
    const double rate = static_cast<double>(round) / std::max(seconds, 1e-3);
    std::cout << (is_terminal_ ? "\r" : "") << "round " << round << " of " << rounds_ << ", " << batches
              << " batches acknowledged, " << std::fixed << std::setprecision(1) << rate << " rounds/s, "
              << std::setprecision(0) << static_cast<double>(rounds_ - round) / rate << " s left "
              << (is_terminal_ && round < rounds_ ? "" : "\n") << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::uint64_t rounds_;
  bool is_terminal_ = ::isatty(STDOUT_FILENO) == 1;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
};

/// Plays a round. Returns how many things were lost in it.
std::size_t play(const RoundPlan& plan, Promised& promised) {
  const std::string failure = run_round(plan, promised);
  std::vector<std::string> losses = verify(plan, promised);
  if (!failure.empty()) losses.push_back(failure);
  for (std::size_t at = 0; at < std::min(kShown, losses.size()); ++at) {
    std::cout << "\nseed " << plan.seed << " round " << plan.round << " ("
              << (plan.death == Death::killed ? "killed" : "power lost") << "): " << losses[at];
  }
  if (!losses.empty()) std::cout << '\n';
  return losses.size();
}

int crash(std::uint64_t rounds, std::uint64_t seed) {
  Totals totals;
  Progress progress(rounds);
  std::size_t losses = 0;
  for (std::uint64_t first = 1; first <= rounds; first += kRoundsAStore) {
    const weft::storage::TemporaryDirectory directory;
    Promised promised;
    std::uint64_t batches = 0;
    for (std::uint64_t round = first; round < first + kRoundsAStore && round <= rounds; ++round) {
      const RoundPlan plan{directory.path() / "store", directory.path() / ("snapshot-" + std::to_string(round)), seed,
                           round, round % 2 == 0 ? Death::power : Death::killed};
      const std::size_t lost = play(plan, promised);
      losses += lost;
      ++(plan.death == Death::killed ? totals.kills : totals.power_losses);
      totals.snapshots += promised.has_snapshot ? 1 : 0;
      batches = batches_of(promised);
      progress.tell(round, totals.batches + batches);
      if (lost > 0) break;  // the rest would only say it again
    }
    totals.batches += batches;
    totals.edits += promised.edits.size();
    if (losses > 0) break;
  }
  std::cout << totals.kills + totals.power_losses << " of " << rounds << " rounds, seed " << seed << ": "
            << totals.batches << " batches, " << totals.edits << " edits and " << totals.snapshots
            << " snapshots acknowledged, " << totals.kills << " kills, " << totals.power_losses << " power losses, "
            << losses << " losses\n";
  return losses == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) try {
  CLI::App app{"Kills a store's process and takes its power, and looks for what was lost.", "tests/crash"};
  std::uint64_t rounds = 50;
  std::uint64_t seed = 1;
  app.add_option("--rounds", rounds, "how often")->check(CLI::Range(1, 1'000'000))->capture_default_str();
  app.add_option("--seed", seed, "of contents, edits and moments")->capture_default_str();
  CLI11_PARSE(app, count, arguments);
  return crash(rounds, seed);
} catch (const std::exception& error) {
  std::cerr << "tests/crash: " << error.what() << '\n';
  return 1;
}
