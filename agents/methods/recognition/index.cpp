#include "agents/methods/recognition/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/network/search.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t kSpreadHops = 3;
constexpr std::uint32_t kSpreadPlaces = 256;  // looked at around one, where many robots have driven
constexpr int kTogether = 2;
constexpr std::size_t kKept = 4096;
constexpr std::size_t kKeptForEach = 8;

bool is_before(const Likely& a, const Likely& b) {
  return std::tie(b.likeness, a.place) < std::tie(a.likeness, b.place);
}

}  // namespace

bool RecognitionIndex::put(const PlaceId& id, const Signature& signature) {
  const bool is_one =
      !signature.empty() && signature.size() <= longest_signature &&
      std::all_of(signature.begin(), signature.end(), [](float number) { return std::isfinite(number); });
  if (!is_one || (numbers_ != 0 && signature.size() != numbers_)) return false;
  numbers_ = signature.size();
  const std::size_t bytes = code_bytes(numbers_);
  const auto [at, is_new] = chunks_.try_emplace({id.experience, id.index / chunk_places});
  Chunk& chunk = at->second;
  if (is_new) memory_bytes_ += sizeof(ChunkKey) + sizeof(Chunk);
  const std::size_t place = id.index % chunk_places;
  const std::size_t had = chunk.codes.capacity();
  if (chunk.codes.size() < (place + 1) * bytes) chunk.codes.resize((place + 1) * bytes);
  memory_bytes_ += chunk.codes.capacity() - had;
  const auto code = std::span(chunk.codes).subspan(place * bytes, bytes);
  if (chunk.is_signed[place]) usual_.count(code, -1), --size_;
  write_code(signature, code);
  usual_.count(code, 1);
  ++size_;
  chunk.is_signed.set(place);
  return true;
}

bool RecognitionIndex::has(const PlaceId& id) const {
  const auto found = chunks_.find({id.experience, id.index / chunk_places});
  return found != chunks_.end() && found->second.is_signed[id.index % chunk_places];
}

void RecognitionIndex::forget(ExperienceId experience) {
  const auto first = chunks_.lower_bound({experience, 0});
  auto last = first;
  for (; last != chunks_.end() && last->first.first == experience; ++last) {
    discount(last->second);
    memory_bytes_ -= sizeof(ChunkKey) + sizeof(Chunk) + last->second.codes.capacity();
  }
  chunks_.erase(first, last);
}

void RecognitionIndex::discount(const Chunk& chunk) {
  const std::size_t bytes = code_bytes(numbers_);
  for (std::size_t place = 0; place < chunk_places; ++place) {
    if (!chunk.is_signed[place]) continue;
    usual_.count(std::span(chunk.codes).subspan(place * bytes, bytes), -1);
    --size_;
  }
}

bool RecognitionSearch::step(const RecognitionIndex& index, const Snapshot& now, std::size_t places) {
  auto at = done_ ? index.chunks().upper_bound(*done_) : index.chunks().begin();
  for (std::size_t seen = 0; at != index.chunks().end() && seen < places; ++at) {
    compare(at->first, at->second, now);
    done_ = at->first;
    seen += RecognitionIndex::chunk_places;
  }
  return at != index.chunks().end();
}

void RecognitionSearch::compare(const RecognitionIndex::ChunkKey& key, const RecognitionIndex::Chunk& chunk,
                                const Snapshot& now) {
  likeness_.resize(chunk.codes.size() / query_.bytes());
  query_.compare(chunk.codes, likeness_);
  for (std::uint32_t place = 0; place < likeness_.size(); ++place) {
    if (!chunk.is_signed[place]) continue;
    offer({likeness_[place], {key.first, key.second * RecognitionIndex::chunk_places + place}}, now);
  }
}

void RecognitionSearch::offer(const Likely& likely, const Snapshot& now) {
  const bool is_full = best_.size() >= keep_;
  if (is_full && (best_.empty() || !is_before(likely, best_.front()))) return;
  if (now.place(likely.place) == nullptr) return;
  if (is_full) {
    std::pop_heap(best_.begin(), best_.end(), is_before);
    best_.pop_back();
  }
  best_.push_back(likely);
  std::push_heap(best_.begin(), best_.end(), is_before);
}

std::vector<PlaceId> RecognitionSearch::ranked() const {
  std::vector<Likely> sorted = best_;
  std::sort(sorted.begin(), sorted.end(), is_before);
  std::vector<PlaceId> places;
  places.reserve(sorted.size());
  for (const Likely& likely : sorted) places.push_back(likely.place);
  return places;
}

std::size_t kept_for(const Wanted& wanted) {
  return kKept + kKeptForEach * wanted.after;
}

std::vector<PlaceId> spread_out(const Snapshot& snapshot, const std::vector<PlaceId>& ranked, const Wanted& wanted) {
  std::vector<PlaceId> chosen;
  std::map<PlaceId, int> around;  // how many of those that were passed lie near
  std::size_t passed = 0;
  for (const PlaceId& place : ranked) {
    if (chosen.size() >= wanted.most) break;
    if (const auto near = around.find(place); near != around.end() && near->second >= kTogether) continue;
    for (const PlaceId& id : neighbourhood(snapshot, place, kSpreadHops, kSpreadPlaces)) ++around[id];
    if (passed++ >= wanted.after) chosen.push_back(place);
  }
  return chosen;
}

std::vector<PlaceId> likeliest(const RecognitionIndex& index, const Snapshot& snapshot, const Signature& seen,
                               const Wanted& wanted) {
  RecognitionSearch search(index, seen, kept_for(wanted));
  search.step(index, snapshot, std::numeric_limits<std::size_t>::max());
  return spread_out(snapshot, search.ranked(), wanted);
}

}  // namespace weft::agents
