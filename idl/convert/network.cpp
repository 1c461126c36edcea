#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/messages.hpp"

namespace weft::convert {

idl::ExperienceBatch to_idl(const msg::ExperienceBatch& message) {
  const Batch& batch = message.batch;
  idl::ExperienceBatch wire;
  wire.header(to_idl(message.header));
  wire.experience(batch.experience.value);
  wire.batch_number(batch.sequence);
  wire.robot(batch.robot.bytes);
  wire.name(batch.name);
  wire.method(batch.method);
  std::vector<Place> places;
  for_each_place(batch, [&](const Place& place) { places.push_back(place); });
  wire.places(list_to_idl<idl::Place>(places));
  wire.edges(list_to_idl<idl::Edge>(batch.edges));
  wire.seal(batch.seal);
  wire.seal_reason(batch.seal_reason);
  return wire;
}

Result<msg::ExperienceBatch> from_idl(const idl::ExperienceBatch& wire) {
  Reading reading("ExperienceBatch");
  msg::ExperienceBatch value;
  Batch& batch = value.batch;
  value.header = from_idl(wire.header(), reading.in("header"));
  batch.experience = reading.some("experience", ExperienceId{wire.experience()});
  batch.sequence = wire.batch_number();
  reading.require(batch.sequence > 0, "batch_number", "must be at least 1");
  batch.robot = reading.some("robot", id_from<RobotId>(wire.robot()));
  reading.require(batch.robot == value.header.sender, "robot", "must be the sender");
  batch.name = reading.text("name", wire.name(), kNameLength);
  batch.method = reading.text("method", wire.method(), kNameLength);
  set_places(batch, list_from_idl<Place>(wire.places(), reading, "places", kBatchPlaces));
  batch.edges = list_from_idl<Edge>(wire.edges(), reading, "edges", kBatchEdges);
  batch.seal = wire.seal();
  batch.seal_reason = reading.text("seal_reason", wire.seal_reason(), kTextLength);
  return reading.finish(std::move(value));
}

idl::BatchAck to_idl(const msg::BatchAck& message) {
  idl::BatchAck wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.experience(message.experience.value);
  wire.durable_through(message.durable_through);
  wire.missing().resize(message.missing.size());
  for (std::size_t i = 0; i < message.missing.size(); ++i) wire.missing()[i].bytes(message.missing[i].bytes);
  wire.refused_number(message.refused_sequence);
  wire.refusal(message.refusal);
  return wire;
}

Result<msg::BatchAck> from_idl(const idl::BatchAck& wire) {
  Reading reading("BatchAck");
  msg::BatchAck value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.experience = reading.some("experience", ExperienceId{wire.experience()});
  value.durable_through = wire.durable_through();
  for (const idl::Hash& hash : reading.list("missing", wire.missing(), kHashes)) {
    value.missing.push_back(reading.some("missing", id_from<ContentHash>(hash.bytes())));
  }
  value.refused_sequence = wire.refused_number();
  value.refusal = reading.text("refusal", wire.refusal(), kTextLength);
  return reading.finish(std::move(value));
}

idl::Chunk to_idl(const msg::Chunk& message) {
  idl::Chunk wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.coding(static_cast<std::uint8_t>(message.coding));
  wire.hash(message.hash.bytes);
  wire.total(message.total);
  wire.offset(message.offset);
  wire.data(message.data);
  return wire;
}

Result<msg::Chunk> from_idl(const idl::Chunk& wire) {
  Reading reading("Chunk");
  msg::Chunk value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = id_from<PeerId>(wire.to());
  value.kind = reading.choice("kind", wire.kind(), msg::ContentKind::content, msg::ContentKind::cloud);
  value.coding = reading.choice("coding", wire.coding(), msg::Coding::raw, msg::Coding::cloud);
  value.hash = reading.some("hash", id_from<ContentHash>(wire.hash()));
  value.total = wire.total();
  reading.require(value.total <= msg::kContentBytes, "total",
                  "must be at most " + std::to_string(msg::kContentBytes) + " bytes");
  value.offset = wire.offset();
  reading.require(wire.data().size() <= msg::kChunkBytes, "data",
                  "must be at most " + std::to_string(msg::kChunkBytes) + " bytes");
  reading.require(value.offset <= value.total && wire.data().size() <= value.total - value.offset, "offset",
                  "and data must end within total");
  value.data = wire.data();
  return reading.finish(std::move(value));
}

idl::ContentRequest to_idl(const msg::ContentRequest& message) {
  idl::ContentRequest wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  for (const msg::ContentRequest::Item& item : message.items) {
    idl::ContentItem entry;
    entry.hash(item.hash.bytes);
    entry.offset(item.offset);
    wire.items().push_back(entry);
  }
  return wire;
}

Result<msg::ContentRequest> from_idl(const idl::ContentRequest& wire) {
  Reading reading("ContentRequest");
  msg::ContentRequest value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = id_from<PeerId>(wire.to());
  for (const idl::ContentItem& item : reading.list("items", wire.items(), kHashes)) {
    reading.require(item.offset() <= msg::kContentBytes, "items.offset", "must be within the largest content");
    value.items.push_back({reading.some("items.hash", id_from<ContentHash>(item.hash())), item.offset()});
  }
  return reading.finish(std::move(value));
}

idl::WindowRequest to_idl(const msg::WindowRequest& message) {
  const WindowDefinition& definition = message.definition;
  idl::WindowRequest wire;
  wire.header(to_idl(message.header));
  wire.definition_id(message.definition_id);
  wire.has_centre(definition.centre.has_value());
  wire.centre(to_idl(definition.centre.value_or(PlaceId{})));
  wire.hops(definition.hops);
  wire.cap(definition.cap);
  wire.route(list_to_idl<idl::PlaceId>(definition.route));
  wire.held_revision(message.held.value);
  wire.held_digest(message.held_digest.bytes);
  return wire;
}

Result<msg::WindowRequest> from_idl(const idl::WindowRequest& wire) {
  Reading reading("WindowRequest");
  msg::WindowRequest value;
  WindowDefinition& definition = value.definition;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.definition_id = wire.definition_id();
  if (wire.has_centre()) definition.centre = reading.some("centre", from_idl(wire.centre()));
  definition.hops = wire.hops();
  reading.require(definition.hops <= kHops, "hops", "must be at most " + std::to_string(kHops));
  definition.cap = wire.cap();
  reading.require(definition.cap >= 1 && definition.cap <= kWindowCap, "cap",
                  "must be from 1 to " + std::to_string(kWindowCap));
  definition.route = places_from_idl(wire.route(), reading, "route", kRoutePlaces);
  value.held = Revision{wire.held_revision()};
  value.held_digest = id_from<Digest>(wire.held_digest());
  return reading.finish(std::move(value));
}

idl::WindowPatch to_idl(const msg::WindowPatch& message) {
  const Patch& patch = message.patch;
  idl::WindowPatch wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.definition_id(message.definition_id);
  wire.part(message.part);
  wire.parts(message.parts);
  wire.base_revision(patch.base.value);
  wire.target_revision(patch.target.value);
  wire.added(list_to_idl<idl::Place>(patch.added));
  wire.changed(list_to_idl<idl::Place>(patch.changed));
  wire.removed(list_to_idl<idl::PlaceId>(patch.removed));
  wire.edges(list_to_idl<idl::Edge>(patch.edges));
  wire.edges_removed(list_to_idl<idl::EdgeId>(patch.edges_removed));
  wire.labels(labels_to_idl(patch.labels));
  wire.labels_removed(patch.labels_removed);
  wire.digest(patch.digest.bytes);
  return wire;
}

Result<msg::WindowPatch> from_idl(const idl::WindowPatch& wire) {
  Reading reading("WindowPatch");
  msg::WindowPatch value;
  Patch& patch = value.patch;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.definition_id = wire.definition_id();
  value.part = wire.part();
  value.parts = wire.parts();
  reading.require(value.parts >= 1 && value.parts <= kParts, "parts", "must be from 1 to " + std::to_string(kParts));
  reading.require(value.part < value.parts, "part", "must be below parts");
  patch.base = Revision{wire.base_revision()};
  patch.target = Revision{wire.target_revision()};
  const std::size_t entities = wire.added().size() + wire.changed().size() + wire.removed().size() +
                               wire.edges().size() + wire.edges_removed().size();
  reading.require(entities <= msg::kPatchEntities, "places, edges and removals",
                  "must be at most " + std::to_string(msg::kPatchEntities) + " together");
  patch.added = list_from_idl<Place>(wire.added(), reading, "added", msg::kPatchEntities);
  patch.changed = list_from_idl<Place>(wire.changed(), reading, "changed", msg::kPatchEntities);
  patch.removed = places_from_idl(wire.removed(), reading, "removed", msg::kPatchEntities);
  patch.edges = list_from_idl<Edge>(wire.edges(), reading, "edges", msg::kPatchEntities);
  patch.edges_removed = list_from_idl<EdgeId>(wire.edges_removed(), reading, "edges_removed", msg::kPatchEntities);
  patch.labels = labels_from_idl(reading.list("labels", wire.labels(), kLabels), reading.in("labels"));
  patch.labels_removed = reading.list("labels_removed", wire.labels_removed(), kLabels);
  for (const std::string& label : patch.labels_removed) reading.text("labels_removed", label, kNameLength);
  patch.digest = id_from<Digest>(wire.digest());
  return reading.finish(std::move(value));
}

idl::Recognise to_idl(const msg::Recognise& message) {
  idl::Recognise wire;
  wire.header(to_idl(message.header));
  wire.request(message.request);
  wire.method(message.method);
  wire.content_format(message.content_format);
  wire.seen(message.seen);
  wire.most(message.most);
  wire.after(message.after);
  return wire;
}

Result<msg::Recognise> from_idl(const idl::Recognise& wire) {
  Reading reading("Recognise");
  msg::Recognise value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.request = wire.request();
  value.method = reading.text("method", wire.method(), kNameLength);
  value.content_format = wire.content_format();
  value.seen = reading.list("seen", wire.seen(), msg::kSignatureNumbers);
  reading.require(!value.seen.empty(), "seen", "must have at least 1 number");
  for (const float number : value.seen) reading.finite("seen", number);
  value.most = wire.most();
  reading.require(value.most >= 1 && value.most <= msg::kRecognisedPlaces, "most",
                  "must be from 1 to " + std::to_string(msg::kRecognisedPlaces));
  value.after = wire.after();
  reading.require(value.after <= msg::kRecognisedRank, "after",
                  "must be at most " + std::to_string(msg::kRecognisedRank));
  return reading.finish(std::move(value));
}

idl::Recognised to_idl(const msg::Recognised& message) {
  idl::Recognised wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.request(message.request);
  wire.outcome(static_cast<std::uint8_t>(message.outcome));
  wire.message(message.message);
  wire.places(list_to_idl<idl::PlaceId>(message.places));
  wire.signed_places(message.signed_places);
  wire.unsigned_places(message.unsigned_places);
  return wire;
}

Result<msg::Recognised> from_idl(const idl::Recognised& wire) {
  Reading reading("Recognised");
  msg::Recognised value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<RobotId>(wire.to()));
  value.request = wire.request();
  value.outcome = reading.choice("outcome", wire.outcome(), msg::Outcome::done, msg::Outcome::failed);
  value.message = reading.text("message", wire.message(), kTextLength);
  value.places = places_from_idl(wire.places(), reading, "places", msg::kRecognisedPlaces);
  value.signed_places = wire.signed_places();
  value.unsigned_places = wire.unsigned_places();
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
