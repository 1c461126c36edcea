#include <cmath>

#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {

void fields::write(ByteWriter& out, const Place& place) {
  out.id(place.id);
  out.number(place.entity_version);
  out.text(place.method);
  out.number(place.content_format);
  out.id(place.content.hash);
  out.number(place.content.size);
  out.id(place.robot);
  out.number(place.frame);
  out.i64(place.seen_at.time_since_epoch().count());
}

Place fields::read_place(ByteReader& in) {
  Place place;
  place.id = in.place_id("place id");
  place.entity_version = in.number<std::uint32_t>("entity version");
  place.method = in.text("place method");
  place.content_format = in.number<std::uint32_t>("content format");
  place.content.hash = in.id<ContentHash>("content hash");
  place.content.size = in.number<std::uint64_t>("content size");
  place.robot = in.id<RobotId>("robot");
  place.frame = in.number<std::uint64_t>("frame");
  place.seen_at = SensorTime(Duration(in.i64("seen at")));
  return place;
}

void fields::write(ByteWriter& out, const Edge& edge) {
  out.id(edge.id.a);
  out.id(edge.id.b);
  out.number(edge.entity_version);
  write(out, edge.a_from_b);
  out.number(static_cast<std::uint8_t>(edge.origin));
  out.text(edge.method);
  out.number(static_cast<std::uint8_t>(edge.drivable));
  out.number(edge.inliers);
  out.f32(edge.overlap);
}

Edge fields::read_edge(ByteReader& in) {
  Edge edge;
  edge.id.a = in.place_id("edge a");
  edge.id.b = in.place_id("edge b");
  edge.entity_version = in.number<std::uint32_t>("entity version");
  edge.a_from_b = read_relation(in);
  edge.origin = static_cast<Origin>(in.ranged<std::uint8_t>("origin", 1, 3));
  edge.method = in.text("edge method");
  edge.drivable = static_cast<Drivable>(in.ranged<std::uint8_t>("drivable", 0, 3));
  edge.inliers = in.number<std::uint32_t>("inliers");
  const std::size_t at = in.offset();
  edge.overlap = in.f32("overlap");
  if (!(edge.overlap >= 0.0F && edge.overlap <= 1.0F)) in.corrupt("overlap", at, "must be in [0, 1]");
  return edge;
}

Bytes encode(const Place& place) {
  return fields::record([&](ByteWriter& out) { fields::write(out, place); });
}

Bytes encode(const Edge& edge) {
  return fields::record([&](ByteWriter& out) { fields::write(out, edge); });
}

Bytes encode(const Batch& batch) {
  return fields::record([&](ByteWriter& out) {
    out.number(batch.experience.value);
    out.number(batch.sequence);
    out.id(batch.robot);
    out.text(batch.name);
    out.text(batch.method);
    out.count(batch.places.size() + batch.learned.size());
    for_each_place(batch, [&](const Place& place) { fields::write(out, place); });
    out.count(batch.edges.size());
    for (const Edge& edge : batch.edges) fields::write(out, edge);
    out.flag(batch.seal);
    out.text(batch.seal_reason);
  });
}

Result<Place> decode_place(ByteView bytes) {
  return fields::whole<Place>(bytes, "place", fields::read_place);
}

Result<Edge> decode_edge(ByteView bytes) {
  return fields::whole<Edge>(bytes, "edge", fields::read_edge);
}

Result<Batch> decode_batch(ByteView bytes) {
  return fields::whole<Batch>(bytes, "batch", [](ByteReader& in) {
    Batch batch;
    batch.experience.value = in.number<std::uint64_t>("experience");
    batch.sequence = in.number<std::uint64_t>("sequence");
    batch.robot = in.id<RobotId>("robot");
    batch.name = in.text("name");
    batch.method = in.text("method");
    std::vector<Place> places(in.count("places", fields::kPlaceLeast));
    for (Place& place : places) place = fields::read_place(in);
    set_places(batch, std::move(places));
    batch.edges.resize(in.count("edges", fields::kEdgeLeast));
    for (Edge& edge : batch.edges) edge = fields::read_edge(in);
    batch.seal = in.flag("seal");
    batch.seal_reason = in.text("seal reason");
    return batch;
  });
}

}  // namespace weft
