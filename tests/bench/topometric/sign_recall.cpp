#include "tests/bench/topometric/sign_recall.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <span>

#include "agents/methods/recognition/code.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::bench {
namespace {

using namespace agents;

constexpr double kRightM = 0.6;    // of the place: its neighbour leads there
constexpr double kRightRad = 0.6;  // and the view has most of its features

bool is_right(const RunPlace& known, const RunPlace& seen) {
  if (known.site != seen.site) return false;
  const Pose2 apart = known.at.inverse() * seen.at;
  return apart.translation().norm() < kRightM && std::abs(apart.heading) < kRightRad;
}

/// Holds how many places look likelier than the right ones, a question each.
struct Ranks {
  std::vector<std::size_t> all;
  double within(std::size_t most) const {
    const auto found = std::count_if(all.begin(), all.end(), [most](std::size_t rank) { return rank < most; });
    return 100.0 * static_cast<double>(found) / static_cast<double>(all.size());
  }
  void print(const char* what) const {
    std::vector<std::size_t> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    std::printf("  %-8s first %5.1f %%, of 12 %5.1f %%, of 64 %5.1f %%; 90 %% %zu, worst %zu\n", what, within(1),
                within(12), within(64), sorted[sorted.size() * 9 / 10], sorted.back());
  }
};

/// Compares what is seen with all places that are signed.
class Recall {
 public:
  explicit Recall(const std::vector<RunPlace>& known) : known_(known) {
    for (const RunPlace& place : known) signatures_.push_back(Topometric::sign_bytes(place.bytes));
    const auto first = std::find_if(signatures_.begin(), signatures_.end(), [](const auto& one) { return !!one; });
    numbers_ = first == signatures_.end() ? 0 : (*first)->size();
    codes_.resize(known.size() * code_bytes(numbers_));
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!signatures_[i]) continue;
      write_code(*signatures_[i], code(i));
      usual_.count(code(i), 1);
    }
  }
  std::size_t signed_places() const {
    return static_cast<std::size_t>(
        std::count_if(signatures_.begin(), signatures_.end(), [](const auto& one) { return !!one; }));
  }
  void ask(const RunPlace& seen, Ranks& numbers, Ranks& codes) const {
    const std::optional<Signature> signature = Topometric::sign_bytes(seen.bytes);
    std::vector<double> apart(known_.size(), 1e18);
    std::vector<std::int32_t> likeness(known_.size());
    if (signature) {
      for (std::size_t i = 0; i < known_.size(); ++i)
        if (signatures_[i]) apart[i] = distance2(*signature, *signatures_[i]);
      CodeQuery(*signature, usual_).compare(codes_, likeness);
    }
    std::vector<double> unlike(known_.size(), 1e18);
    for (std::size_t i = 0; i < known_.size(); ++i)
      if (signature && signatures_[i]) unlike[i] = -1.0 * likeness[i];
    numbers.all.push_back(rank(seen, apart));
    codes.all.push_back(rank(seen, unlike));
  }
  bool has_right(const RunPlace& seen) const {
    return std::any_of(known_.begin(), known_.end(), [&](const RunPlace& one) { return is_right(one, seen); });
  }
  /// Returns the chance that a right place is among 64 that are drawn.
  double by_chance(const RunPlace& seen) const {
    const auto right = static_cast<double>(
        std::count_if(known_.begin(), known_.end(), [&](const RunPlace& one) { return is_right(one, seen); }));
    return 1.0 - std::pow(1.0 - 64.0 / static_cast<double>(known_.size()), right);
  }

 private:
  std::span<std::uint8_t> code(std::size_t i) {
    return std::span(codes_).subspan(i * code_bytes(numbers_), code_bytes(numbers_));
  }
  std::size_t rank(const RunPlace& seen, const std::vector<double>& unlike) const {
    double best = 1e18;
    for (std::size_t i = 0; i < known_.size(); ++i)
      if (is_right(known_[i], seen)) best = std::min(best, unlike[i]);
    return static_cast<std::size_t>(
        std::count_if(unlike.begin(), unlike.end(), [&](double one) { return one < best; }));
  }

  const std::vector<RunPlace>& known_;
  std::vector<std::optional<Signature>> signatures_;
  std::size_t numbers_ = 0;
  std::vector<std::uint8_t> codes_;
  UsualLevels usual_;
};

}  // namespace

void print_sign_recall(const PlaceRuns& runs) {
  const Recall recall(runs.known);
  std::map<std::string, std::pair<Ranks, Ranks>> sites;
  Ranks numbers, codes;
  double chance = 0.0;
  for (const RunPlace& seen : runs.seen) {
    if (!recall.has_right(seen)) continue;
    recall.ask(seen, numbers, codes);
    recall.ask(seen, sites[seen.site].first, sites[seen.site].second);
    chance += recall.by_chance(seen);
  }
  if (numbers.all.empty()) return;
  std::printf("%zu places, %zu signed; %zu views of another robot on another day\n", runs.known.size(),
              recall.signed_places(), numbers.all.size());
  for (const auto& [site, ranks] : sites) {
    std::printf(" %s, %zu views\n", site.c_str(), ranks.first.all.size());
    ranks.first.print("numbers");
    ranks.second.print("codes");
  }
  std::printf(" all; by chance of 64 %.1f %%\n", 100.0 * chance / static_cast<double>(numbers.all.size()));
  numbers.print("numbers");
  codes.print("codes");
}

}  // namespace weft::bench
