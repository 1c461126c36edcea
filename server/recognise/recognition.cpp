#include "server/recognise/recognition.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "server/base/repeating.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr std::size_t kSigned = 8;  ///< contents a piece: about 1 ms
constexpr Duration kBetweenSignings = 3ms;
constexpr std::size_t kCompared = 8'192;             ///< signatures a piece: about 1 ms
constexpr std::uint64_t kMostBytes = 512ULL << 20U;  ///< of signatures; a million of the floor method take 260 MB

std::string name_of(const std::string& method, std::uint32_t format) {
  return "'" + method + "' of format " + std::to_string(format);
}

}  // namespace

bool Recognition::can_sign(const std::string& method) const {
  const Signers& signers = context_.config.signers;
  const auto found = signers.lower_bound({method, 0});
  return found != signers.end() && found->first.first == method;
}

/// Looks for what has changed since it was looked at last: experiences that grew, went, or came back.
void Recognition::look_for_work() {
  const Snapshot& snapshot = context_.snapshots.current();
  if (context_.config.signers.empty() || looked_at_ == snapshot.revision()) return;
  looked_at_ = snapshot.revision();
  std::erase_if(progress_, [&](const auto& entry) {
    if (snapshot.experience(entry.first) != nullptr) return false;
    for (auto& [key, index] : indexes_) index.forget(entry.first);
    return true;
  });
  for (const auto& [id, experience] : snapshot.experiences()) note_experience(experience);
}

void Recognition::note_experience(const std::shared_ptr<const Experience>& experience) {
  if (!can_sign(experience->method)) return;
  Progress& progress = progress_[experience->id];
  if (progress.experience == experience) return;
  const bool was_done = progress.experience == nullptr || progress.walked == progress.experience->places.size();
  const auto& places = experience->places;
  // Otherwise something before has gone or come back: what is signed is passed over quickly.
  const bool goes_on = progress.walked == 0 ||
                       (progress.walked <= places.size() && places[progress.walked - 1].id == progress.last_walked);
  progress.experience = experience;
  if (!goes_on) progress.walked = 0, progress.is_signed = 0;
  if (was_done && progress.walked < places.size()) to_sign_.push_back(experience->id);
}

void Recognition::sign_piece() {
  std::size_t read = 0;
  constexpr std::size_t kPassedOver = 50;  // for the price of one that is read
  for (std::size_t passed = 0; !to_sign_.empty() && read < kSigned && passed < kSigned * kPassedOver; ++passed) {
    const auto found = progress_.find(to_sign_.front());
    if (found == progress_.end() || found->second.walked >= found->second.experience->places.size()) {
      to_sign_.pop_front();
      continue;
    }
    Progress& progress = found->second;
    const Place& place = progress.experience->places[progress.walked];
    const auto index = indexes_.find({place.method, place.content_format});
    const bool is_there = index != indexes_.end() && index->second.has(place.id);
    if (!is_there) ++read;
    if (is_there || sign(place)) ++progress.is_signed;
    progress.last_walked = place.id;
    ++progress.walked;
  }
  show();
}

bool Recognition::sign(const Place& place) {
  const Key key{place.method, place.content_format};
  const auto signer = context_.config.signers.find(key);
  if (signer == context_.config.signers.end()) {
    ++context_.counters["recognise: contents of a format that is not signed"];
    return false;
  }
  std::uint64_t bytes = 0;
  for (const auto& [known, index] : indexes_) bytes += index.memory_bytes();
  if (bytes >= kMostBytes) {
    ++context_.counters["recognise: places left out for want of memory"];
    return false;
  }
  const Result<Bytes> content = context_.store.content(place.content.hash);
  std::optional<agents::Signature> signature;
  if (content) signature = signer->second(*content);
  const bool is_signed = signature && indexes_[key].put(place.id, *signature);
  if (!is_signed) ++context_.counters["recognise: contents without a signature"];
  return is_signed;
}

/// Shows the counts in `map info`.
void Recognition::show() {
  std::uint64_t is_signed = 0;
  std::uint64_t bytes = 0;
  for (const auto& [key, index] : indexes_) {
    is_signed += index.size();
    bytes += index.memory_bytes();
  }
  context_.counters["recognise: places signed"] = is_signed;
  context_.counters["recognise: bytes of signatures"] = bytes;
}

void Recognition::on_question(const msg::Recognise& asked, SteadyTime now) {
  const Key key{asked.method, asked.content_format};
  if (!context_.config.signers.contains(key)) {
    return refuse(asked, "this server does not sign contents of " + name_of(key.first, key.second) +
                             ": update it, or give the robot a seed");
  }
  const agents::RecognitionIndex& index = indexes_[key];
  if (index.size() == 0) return answer(asked, {});
  if (!index.fits(asked.seen)) {
    return refuse(asked, "signatures of " + name_of(key.first, key.second) + " have " +
                             std::to_string(index.numbers()) + " numbers, not " + std::to_string(asked.seen.size()));
  }
  std::erase_if(searches_, [&](const Search& other) { return other.asked.header.sender == asked.header.sender; });
  if (searches_.size() >= kMostPeers) return refuse(asked, "too many robots look for themselves: ask again later");
  const agents::Wanted wanted{.most = asked.most, .after = asked.after};
  searches_.push_back({asked, agents::RecognitionSearch(index, asked.seen, agents::kept_for(wanted))});
  asked_at_ = now;
}

void Recognition::search_piece() {
  const Snapshot& snapshot = context_.snapshots.current();
  Search& first = searches_.front();
  const auto index = indexes_.find({first.asked.method, first.asked.content_format});
  if (index != indexes_.end() && first.search.step(index->second, snapshot, kCompared)) {
    // Whoever came later gets the next piece.
    std::rotate(searches_.begin(), searches_.begin() + 1, searches_.end());
    return;
  }
  const Search done = std::move(first);
  searches_.pop_front();
  msg::Recognised found;
  found.places =
      agents::spread_out(snapshot, done.search.ranked(), {.most = done.asked.most, .after = done.asked.after});
  answer(done.asked, std::move(found));
}

void Recognition::answer(const msg::Recognise& asked, msg::Recognised answer) {
  answer.to = asked.header.sender;
  answer.request = asked.request;
  for (const auto& [id, progress] : progress_) {
    if (progress.experience->method != asked.method) continue;
    answer.signed_places += progress.is_signed;
    answer.unsigned_places += progress.experience->places.size() - progress.walked;
  }
  context_.out.send(std::move(answer));
}

void Recognition::refuse(const msg::Recognise& asked, std::string why) {
  msg::Recognised refusal;
  refusal.outcome = msg::Outcome::refused;
  refusal.message = std::move(why);
  answer(asked, std::move(refusal));
}

void Recognition::tick(Now now) {
  look_for_work();
  if (!searches_.empty()) search_piece();
  if (to_sign_.empty() || now.steady < next_piece_) return;
  sign_piece();
  next_piece_ = now.steady + kBetweenSignings;
}

std::optional<SteadyTime> Recognition::next() const {
  if (!searches_.empty()) return asked_at_;
  const bool has_changed = !context_.config.signers.empty() && looked_at_ != context_.snapshots.current().revision();
  if (has_changed || !to_sign_.empty()) return next_piece_;
  return std::nullopt;
}

}  // namespace weft::server
