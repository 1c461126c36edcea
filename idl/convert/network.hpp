#pragma once
#include "idl/convert/common.hpp"
#include "wire/network.h"

namespace weft::convert {

/// Describes the places of a batch: those of other experiences that it knows better travel behind its own.
template <class Io>
void places_of_batch(Io& io, Value<Io, Batch>& batch, Wire<Io, std::vector<idl::Place>>& wire) {
  std::vector<Place> all;
  for_each_place(batch, [&](const Place& place) { all.push_back(place); });
  io.each("places", all, wire, kBatchPlaces);
  if constexpr (Io::kReads) set_places(batch, std::move(all));
}

template <class Io>
void describe(Io& io, Value<Io, msg::ExperienceBatch>& value, Wire<Io, idl::ExperienceBatch>& wire) {
  auto& batch = value.batch;
  io.in("header", value.header, wire.header());
  io.some("experience", batch.experience, wire.experience());
  io.any(batch.sequence, wire.batch_number());
  io.require(batch.sequence > 0, "batch_number", "must be at least 1");
  io.some("robot", batch.robot, wire.robot());
  io.require(batch.robot == value.header.sender, "robot", "must be the sender");
  io.text("name", batch.name, wire.name(), kNameLength);
  io.text("method", batch.method, wire.method(), kNameLength);
  places_of_batch(io, batch, wire.places());
  io.each("edges", batch.edges, wire.edges(), kBatchEdges);
  io.any(batch.seal, wire.seal());
  io.text("seal_reason", batch.seal_reason, wire.seal_reason(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::BatchAck>& value, Wire<Io, idl::BatchAck>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.some("experience", value.experience, wire.experience());
  io.any(value.durable_through, wire.durable_through());
  const std::size_t missing = io.entries("missing", value.missing, wire.missing(), kHashes);
  for (std::size_t i = 0; i < missing; ++i) io.some("missing", value.missing[i], wire.missing()[i].bytes());
  io.any(value.refused_sequence, wire.refused_number());
  io.text("refusal", value.refusal, wire.refusal(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Chunk>& value, Wire<Io, idl::Chunk>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.to, wire.to());
  io.choice("kind", value.kind, wire.kind(), msg::ContentKind::content, msg::ContentKind::cloud);
  io.choice("coding", value.coding, wire.coding(), msg::Coding::raw, msg::Coding::cloud);
  io.some("hash", value.hash, wire.hash());
  io.any(value.total, wire.total());
  io.require_at_most(value.total, msg::kContentBytes, "total", " bytes");
  io.any(value.offset, wire.offset());
  io.any(value.data, wire.data());
  io.require_at_most(value.data.size(), msg::kChunkBytes, "data", " bytes");
  io.require(value.offset <= value.total && value.data.size() <= value.total - value.offset, "offset",
             "and data must end within total");
}

template <class Io>
void describe(Io& io, Value<Io, msg::ContentRequest>& value, Wire<Io, idl::ContentRequest>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.to, wire.to());
  const std::size_t size = io.entries("items", value.items, wire.items(), kHashes);
  for (std::size_t i = 0; i < size; ++i) {
    auto& item = value.items[i];
    io.any(item.offset, wire.items()[i].offset());
    io.require(item.offset <= msg::kContentBytes, "items.offset", "must be within the largest content");
    io.some("items.hash", item.hash, wire.items()[i].hash());
  }
}

template <class Io>
void describe(Io& io, Value<Io, msg::WindowRequest>& value, Wire<Io, idl::WindowRequest>& wire) {
  auto& definition = value.definition;
  io.in("header", value.header, wire.header());
  io.any(value.definition_id, wire.definition_id());
  io.maybe("centre", definition.centre, wire.has_centre(), wire.centre());
  io.at_most("hops", definition.hops, wire.hops(), kHops);
  io.between("cap", definition.cap, wire.cap(), 1, kWindowCap);
  places(io, "route", definition.route, wire.route(), kRoutePlaces);
  io.any(value.held, wire.held_revision());
  io.any(value.held_digest, wire.held_digest());
}

template <class Io>
void describe(Io& io, Value<Io, msg::WindowPatch>& value, Wire<Io, idl::WindowPatch>& wire) {
  auto& patch = value.patch;
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.definition_id, wire.definition_id());
  part_of(io, value, wire);
  io.any(patch.base, wire.base_revision());
  io.any(patch.target, wire.target_revision());
  io.require_at_most(wire.added().size() + wire.changed().size() + wire.removed().size() + wire.edges().size() +
                         wire.edges_removed().size(),
                     msg::kPatchEntities, "places, edges and removals", " together");
  io.each("added", patch.added, wire.added(), msg::kPatchEntities);
  io.each("changed", patch.changed, wire.changed(), msg::kPatchEntities);
  places(io, "removed", patch.removed, wire.removed(), msg::kPatchEntities);
  io.each("edges", patch.edges, wire.edges(), msg::kPatchEntities);
  io.each("edges_removed", patch.edges_removed, wire.edges_removed(), msg::kPatchEntities);
  labels(io, patch.labels, wire.labels(), kLabels);
  io.texts("labels_removed", patch.labels_removed, wire.labels_removed(), kLabels, kNameLength);
  io.any(patch.digest, wire.digest());
}

template <class Io>
void describe(Io& io, Value<Io, msg::Recognise>& value, Wire<Io, idl::Recognise>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.request, wire.request());
  io.text("method", value.method, wire.method(), kNameLength);
  io.any(value.content_format, wire.content_format());
  io.list("seen", value.seen, wire.seen(), msg::kSignatureNumbers);
  io.require(!value.seen.empty(), "seen", "must have at least 1 number");
  for (const float number : value.seen) io.require(std::isfinite(number), "seen", "must be finite");
  io.between("most", value.most, wire.most(), 1, msg::kRecognisedPlaces);
  io.at_most("after", value.after, wire.after(), msg::kRecognisedRank);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Recognised>& value, Wire<Io, idl::Recognised>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.request, wire.request());
  io.choice("outcome", value.outcome, wire.outcome(), msg::Outcome::done, msg::Outcome::failed);
  io.text("message", value.message, wire.message(), kTextLength);
  places(io, "places", value.places, wire.places(), msg::kRecognisedPlaces);
  io.any(value.signed_places, wire.signed_places());
  io.any(value.unsigned_places, wire.unsigned_places());
}

}  // namespace weft::convert
