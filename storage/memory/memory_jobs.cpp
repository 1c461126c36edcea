#include "storage/memory/memory_jobs.hpp"

#include "core/network/codec.hpp"
#include "storage/memory/one_step.hpp"

namespace weft::storage {
namespace {

/// Looks at everything in the order of the tables that a store on disk would have.
class Check {
 public:
  explicit Check(const MemoryDisk& disk) : disk_(disk) {}

  JobProgress run() {
    for (const auto& [hash, content] : disk_.contents) {
      const auto bytes = coder_.decode(content.coding, *content.bytes, content.size);
      if (!bytes) found("content " + to_string(hash) + ": " + bytes.error().message);
      if (bytes && hash_bytes(*bytes) != hash) found("content " + to_string(hash) + ": its SHA-256 differs");
    }
    for (const MemoryDisk::Step& step : disk_.history) {
      if (const auto* const batch = std::get_if<Batch>(&step.change)) look(*batch);
      if (const auto* const put = std::get_if<PutLabel>(&step.change)) look(*put);
      if (const auto* const put = std::get_if<PutApart>(&step.change)) look(*put);
      if (const auto* const known = known_anew(step)) look(*known);
    }
    for (const auto& [id, facts] : disk_.experiences) look(id, facts);
    if (disk_.notes.size() != disk_.revision.value) found("revision: the notes have a gap");
    progress_.unit = "rows";
    progress_.done = progress_.total = disk_.contents.size() + disk_.history.size() + disk_.experiences.size();
    progress_.summary = std::to_string(progress_.done) + " rows read, " +
                        (found_ == 0 ? "nothing is damaged" : std::to_string(found_) + " found damaged");
    return progress_;
  }

 private:
  void found(std::string what) {
    progress_.findings.push_back(std::move(what));
    ++found_;
  }
  void look(const Batch& batch) {
    const auto stored = disk_.batch_hashes.find({batch.experience, batch.sequence});
    if (stored == disk_.batch_hashes.end()) {
      found("batch " + std::to_string(batch.sequence) + " of experience " + to_string(batch.experience) +
            ": its hash is not stored");
    }
    look(batch.places);
    for (const Edge& edge : batch.edges) {
      for (const PlaceId& end : {edge.id.a, edge.id.b}) {
        if (has_place(end)) continue;
        found("edge " + to_string(edge.id.a) + " - " + to_string(edge.id.b) + ": its place " + to_string(end) +
              " is not stored");
      }
    }
  }
  void look(const std::vector<Place>& places) {
    for (const Place& place : places) {
      if (disk_.contents.contains(place.content.hash)) continue;
      found("place " + to_string(place.id) + ": its content " + to_string(place.content.hash) + " is not stored");
    }
  }
  void look(const PutLabel& put) {
    if (put.place.experience && !has_place(put.place)) {
      found("label " + put.label + ": its place " + to_string(put.place) + " is not stored");
    }
  }
  void look(const PutApart& put) {
    for (const Stretch& stretch : {put.apart.one, put.apart.other}) {
      if (has_place({stretch.experience, stretch.last})) continue;
      found("apart " + to_string(put.apart) + ": the places of " + to_string(stretch) + " are not stored");
    }
  }
  void look(const ExperienceId& id, const ExperienceFacts& facts) {
    for (std::uint64_t sequence = 1; sequence <= facts.durable_through; ++sequence) {
      if (disk_.batch_hashes.contains({id, sequence})) continue;
      found("batch " + std::to_string(sequence) + " of experience " + to_string(id) + ": it is not stored");
    }
  }
  bool has_place(const PlaceId& place) const {
    const auto experience = disk_.experiences.find(place.experience);
    return experience != disk_.experiences.end() && place.index < experience->second.places;
  }

  const MemoryDisk& disk_;
  ContentCoder coder_;
  JobProgress progress_;
  std::uint64_t found_ = 0;
};

}  // namespace

std::unique_ptr<StoreJob> make_memory_check(const MemoryDisk& disk) {
  return std::make_unique<OneStep>([&disk] { return Check(disk).run(); });
}

std::unique_ptr<StoreJob> make_memory_stats(const MemoryDisk& disk) {
  return std::make_unique<OneStep>([&disk] {
    JobProgress progress;
    std::uint64_t clouds = 0;
    std::uint64_t cloud_bytes = 0;
    for (const auto& [hash, content] : disk.contents) {
      if (content.kind != msg::ContentKind::cloud) continue;
      ++clouds;
      cloud_bytes += content.size;
    }
    const std::uint64_t bytes = disk.content_bytes - cloud_bytes;
    progress.space = {{"contents", disk.contents.size() - clouds, bytes, bytes},
                      {"clouds", clouds, cloud_bytes, cloud_bytes},
                      {"history", disk.history.size(), 0, 0},
                      {"events", disk.events.size(), 0, 0}};
    progress.unit = "rows";
    progress.done = progress.total = disk.contents.size() + disk.history.size() + disk.events.size();
    progress.summary = std::to_string(disk.content_bytes / 1'000'000) + " MB of contents in memory";
    return progress;
  });
}

}  // namespace weft::storage
