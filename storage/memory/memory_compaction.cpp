#include <algorithm>
#include <set>

#include "core/network/index_of.hpp"
#include "storage/memory/memory_jobs.hpp"
#include "storage/memory/one_step.hpp"
#include "storage/retention.hpp"

namespace weft::storage {
namespace {

class MemoryCompaction {
 public:
  MemoryCompaction(MemoryDisk& disk, Revision floor) : disk_(disk), retention_(floor, disk.bases) {
    for (const MemoryDisk::Step& step : disk_.history) {
      if (const auto* const out = std::get_if<TakeOut>(&step.change)) remember(out->what, step.revision, false);
    }
    for (const MemoryDisk::Step& step : disk_.history) {
      if (const auto* const back = std::get_if<BringBack>(&step.change)) remember(back->what, step.revision, true);
    }
    const auto is_before = [](const Moved& left, const Moved& right) {
      return std::pair(left.revision, left.is_back) < std::pair(right.revision, right.is_back);
    };
    for (auto& [id, moves] : places_) std::ranges::stable_sort(moves, is_before);
    for (auto& [id, moves] : stitches_) std::ranges::stable_sort(moves, is_before);
  }

  JobProgress run() {
    mark();
    for (auto step = disk_.history.rbegin(); step != disk_.history.rend(); ++step) {
      if (auto* const batch = std::get_if<Batch>(&step->change)) thin(*batch, step->revision);
      if (auto* const put = std::get_if<PutPlaces>(&step->change)) thin(put->places, step->revision);
    }
    thin_latest();
    for (MemoryDisk::Step& step : disk_.history) {
      if (step.revision > retention_.floor()) break;
      if (auto* const out = std::get_if<TakeOut>(&step.change)) thin(out->what);
      if (auto* const back = std::get_if<BringBack>(&step.change)) thin(back->what);
    }
    drop_contents();
    drop_passes();
    progress_.unit = "rows";
    progress_.done = progress_.total = disk_.history.size();
    progress_.summary = "revision " + std::to_string(retention_.floor().value) + " is the oldest that is kept";
    return progress_;
  }

 private:
  void remember(const Removal& removal, Revision revision, bool is_back) {
    for (const Stretch& stretch : removal.places) {
      places_[stretch.experience].push_back({{revision.value, is_back}, stretch.first, stretch.last});
    }
    for (const EdgeId& stitch : removal.stitches) stitches_[stitch].push_back({revision.value, is_back});
  }

  bool is_deleted(const PlaceId& place) const {
    const auto found = disk_.deleted.find(place.experience);
    return found != disk_.deleted.end() && std::ranges::any_of(found->second, [&](const Stretch& stretch) {
             return stretch.first <= place.index && place.index <= stretch.last;
           });
  }

  /// Returns whether all of the stretch is deleted.
  bool is_deleted(const Stretch& stretch) const {
    const auto found = disk_.deleted.find(stretch.experience);
    return found != disk_.deleted.end() && std::ranges::any_of(found->second, [&](const Stretch& gone) {
             return gone.first <= stretch.first && stretch.last <= gone.last;
           });
  }

  void mark() {
    std::map<ExperienceId, PlaceRetention> retentions;
    for (const MemoryDisk::Step& step : disk_.history) {
      const auto* const batch = std::get_if<Batch>(&step.change);
      if (batch == nullptr) continue;
      const auto places = retentions.try_emplace(batch->experience, retention_, places_[batch->experience]).first;
      for (const Place& place : batch->places) {
        if (places->second.keeps(place.id.index, step.revision.value)) continue;
        disk_.deleted[batch->experience].push_back({batch->experience, place.id.index, place.id.index});
      }
    }
    for (auto& [id, stretches] : disk_.deleted) stretches = joined(std::move(stretches));
  }

  void thin(Batch& batch, Revision revision) {
    std::erase_if(batch.places, [&](const Place& place) { return is_deleted(place.id); });
    std::erase_if(batch.edges, [&](const Edge& edge) {
      const auto rows = latest_.try_emplace(edge.id, retention_).first;
      const bool is_latest = rows->second.keeps(revision.value, stitches_[edge.id]);
      const bool goes = (!is_latest && !is_hop(edge.id)) || is_deleted(edge.id.a) || is_deleted(edge.id.b);
      if (goes && --disk_.edges[edge.id] == 0) disk_.edges.erase(edge.id);
      return goes;
    });
    thin(batch.learned, revision);
  }

  /// Drops versions of places between the first and the last, except those that a kept map has.
  void thin(std::vector<Place>& known_anew, Revision revision) {
    std::erase_if(known_anew, [&](const Place& place) {
      const bool is_latest = known_.try_emplace(place.id, retention_).first->second.keeps(revision.value);
      return !is_latest || is_deleted(place.id);
    });
  }

  /// Deletes labels, rules, registrations, and words on what is apart that no kept map needs.
  void thin_latest() {
    std::map<std::string, LatestRetention> labels;
    std::map<std::string, LatestRetention> rules;
    std::map<std::string, LatestRetention> registrations;
    std::map<Apart, LatestRetention> aparts;
    std::vector<MemoryDisk::Step> kept;
    for (auto step = disk_.history.rbegin(); step != disk_.history.rend(); ++step) {
      if (const auto* const put = std::get_if<PutLabel>(&step->change)) {
        if (!labels.try_emplace(put->label, retention_).first->second.keeps(step->revision.value)) continue;
      }
      if (const auto* const put = std::get_if<PutRule>(&step->change)) {
        if (!rules.try_emplace(put->rule.name, retention_).first->second.keeps(step->revision.value)) continue;
      }
      if (const auto* const put = std::get_if<PutRegistration>(&step->change)) {
        const std::string& plan = put->registration.plan;
        if (!registrations.try_emplace(plan, retention_).first->second.keeps(step->revision.value)) continue;
      }
      if (const auto* const put = std::get_if<PutApart>(&step->change)) {
        const bool is_latest = aparts.try_emplace(put->apart, retention_).first->second.keeps(step->revision.value);
        if (!is_latest || is_deleted(put->apart.one) || is_deleted(put->apart.other)) continue;
      }
      kept.push_back(std::move(*step));
    }
    std::ranges::reverse(kept);
    disk_.history = std::move(kept);
  }

  void thin(Removal& removal) const {
    std::erase_if(removal.places, [&](const Stretch& stretch) { return is_deleted(stretch); });
    std::erase_if(removal.stitches, [&](const EdgeId& stitch) { return !disk_.edges.contains(stitch); });
  }

  static void use(const std::vector<Place>& places, std::set<ContentHash>& used) {
    for (const Place& place : places) used.insert(place.content.hash);
  }

  void drop_contents() {
    std::set<ContentHash> used;
    for (const MemoryDisk::Step& step : disk_.history) {
      if (const auto* const batch = std::get_if<Batch>(&step.change)) use(batch->places, used);
      if (const auto* const known = known_anew(step)) use(*known, used);
    }
    std::erase_if(disk_.contents, [&](const auto& entry) {
      const auto& [hash, content] = entry;
      const bool goes = content.kind == msg::ContentKind::content && !used.contains(hash);
      if (goes) disk_.content_bytes -= content.size;
      return goes;
    });
  }

  void drop_passes() {
    std::erase_if(disk_.passes, [&](const auto& entry) {
      const RunPiece& piece = entry.first;
      const auto known = disk_.experiences.find(piece.experience);
      const std::uint64_t places = known == disk_.experiences.end() ? 0 : known->second.places;
      const std::uint32_t first = piece.number * kPlacesOfPiece;
      for (std::uint32_t at = first; at < first + kPlacesOfPiece && at < places; ++at) {
        if (!is_deleted(PlaceId{piece.experience, at})) return false;
      }
      return true;
    });
  }

  MemoryDisk& disk_;
  Retention retention_;
  std::map<ExperienceId, std::vector<MovedStretch>> places_;
  std::map<EdgeId, std::vector<Moved>> stitches_;
  std::map<EdgeId, LatestRetention> latest_;
  std::map<PlaceId, LatestRetention> known_;
  JobProgress progress_;
};

}  // namespace

std::unique_ptr<StoreJob> make_memory_compaction(MemoryDisk& disk, Revision before) {
  disk.floor = before;
  return std::make_unique<OneStep>([&disk, before] { return MemoryCompaction(disk, before).run(); });
}

}  // namespace weft::storage
