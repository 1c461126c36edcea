#include "server/windows/patch_parts.hpp"

namespace weft::server {
namespace {

/// Fills parts one after the other.
class Cutter {
 public:
  Cutter(const Patch& whole, std::size_t entities) : whole_(whole), entities_(entities) { open(); }

  Patch& room_for_one() {
    if (used_ == entities_) open();
    ++used_;
    return parts_.back();
  }
  std::vector<Patch> take() { return std::move(parts_); }

 private:
  void open() {
    Patch part;
    part.base = whole_.base;
    part.target = whole_.target;
    part.digest = whole_.digest;
    parts_.push_back(std::move(part));
    used_ = 0;
  }

  const Patch& whole_;
  std::size_t entities_;
  std::size_t used_ = 0;
  std::vector<Patch> parts_;
};

}  // namespace

std::vector<Patch> parts_of(const Patch& patch, std::size_t entities) {
  Cutter cutter(patch, entities);
  for (const Place& place : patch.added) cutter.room_for_one().added.push_back(place);
  for (const Place& place : patch.changed) cutter.room_for_one().changed.push_back(place);
  for (const PlaceId& id : patch.removed) cutter.room_for_one().removed.push_back(id);
  for (const Edge& edge : patch.edges) cutter.room_for_one().edges.push_back(edge);
  for (const EdgeId& id : patch.edges_removed) cutter.room_for_one().edges_removed.push_back(id);
  for (const auto& [label, place] : patch.labels) cutter.room_for_one().labels.emplace(label, place);
  for (const auto& label : patch.labels_removed) cutter.room_for_one().labels_removed.push_back(label);
  return cutter.take();
}

}  // namespace weft::server
