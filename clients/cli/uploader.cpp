#include "clients/cli/uploader.hpp"

#include <algorithm>
#include <chrono>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr std::size_t kInFlight = 4;
constexpr Duration kRepeatUpload = 2s;

void add_chunks(std::vector<msg::Message>& out, const ContentHash& hash, const Bytes& bytes) {
  for (std::size_t offset = 0; offset < bytes.size(); offset += msg::kChunkBytes) {
    const std::size_t size = std::min(msg::kChunkBytes, bytes.size() - offset);
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    msg::Chunk chunk;
    chunk.hash = hash;
    chunk.total = bytes.size();
    chunk.offset = offset;
    chunk.data.assign(from, from + static_cast<std::ptrdiff_t>(size));
    out.emplace_back(std::move(chunk));
  }
}

}  // namespace

Uploader::Uploader(const std::vector<Batch>& batches, const std::map<ContentHash, Bytes>& contents)
    : batches_(batches), contents_(contents) {}

std::size_t Uploader::end_of_experience() const {
  std::size_t end = next_;
  while (end < batches_.size() && batches_[end].experience == batches_[next_].experience) ++end;
  return end;
}

std::vector<msg::Message> Uploader::due(SteadyTime now) {
  std::vector<msg::Message> out;
  if (now >= repeat_at_ && !progressed_) {
    sent_ = next_;
    answered_.clear();
  }
  if (now >= repeat_at_ || progressed_) repeat_at_ = now + kRepeatUpload;
  progressed_ = false;
  for (const ContentHash& hash : wanted_) {
    const auto content = contents_.find(hash);
    // Each of several batches in flight is answered with the same list.
    if (content != contents_.end() && answered_.insert(hash).second) add_chunks(out, hash, content->second);
  }
  wanted_.clear();
  const std::size_t end = std::min(end_of_experience(), next_ + kInFlight);
  for (sent_ = std::max(sent_, next_); sent_ < end; ++sent_) {
    out.emplace_back(msg::ExperienceBatch{.header = {}, .batch = batches_[sent_]});
  }
  return out;
}

Result<void> Uploader::hear(const msg::BatchAck& ack) {
  if (done() || ack.experience != batches_[next_].experience) return {};
  if (ack.refused_sequence != 0) {
    return fail(ErrorCode::refused, "the server refuses batch " + std::to_string(ack.refused_sequence) +
                                        " of experience " + to_string(ack.experience) + ": " + ack.refusal);
  }
  const std::size_t end = end_of_experience();
  for (; next_ < end && batches_[next_].sequence <= ack.durable_through; ++next_) progressed_ = true;
  wanted_ = ack.missing;
  return {};
}

}  // namespace weft::cli
