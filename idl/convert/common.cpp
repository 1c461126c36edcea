#include "idl/convert/common.hpp"

#include "idl/convert/limits.hpp"

namespace weft::convert {
namespace {

constexpr std::uint8_t kMetric2 = 1;
constexpr std::uint8_t kMetric3 = 2;
constexpr std::uint8_t kAlongPath = 3;

template <class Matrix>
std::vector<double> row_by_row(const Matrix& matrix) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(matrix.size()));
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) values.push_back(matrix(row, column));
  }
  return values;
}

template <class Matrix>
Matrix matrix_from(const std::vector<double>& values) {
  Matrix matrix;
  std::size_t at = 0;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) matrix(row, column) = values[at++];
  }
  return matrix;
}

idl::Relation packed(std::uint8_t kind, std::vector<double> mean, std::vector<double> covariance) {
  idl::Relation wire;
  wire.kind(kind);
  wire.mean(std::move(mean));
  wire.covariance(std::move(covariance));
  return wire;
}

struct Pack {
  idl::Relation operator()(const Metric2& metric) const {
    return packed(kMetric2, {metric.a_from_b.x, metric.a_from_b.y, metric.a_from_b.heading},
                  row_by_row(metric.covariance));
  }
  idl::Relation operator()(const Metric3& metric) const {
    const Eigen::Vector3d& t = metric.a_from_b.translation;
    const Eigen::Quaterniond& q = metric.a_from_b.rotation;
    return packed(kMetric3, {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()},
                  row_by_row(metric.covariance.matrix()));
  }
  idl::Relation operator()(const AlongPath& along) const {
    return packed(kAlongPath, {along.distance_m, along.heading_shift_rad},
                  {along.distance_variance_m2, along.heading_variance_rad2});
  }
};

Relation unpacked(const idl::Relation& wire) {
  const std::vector<double>& mean = wire.mean();
  if (wire.kind() == kMetric2) {
    return Metric2{{mean[0], mean[1], mean[2]}, matrix_from<Eigen::Matrix3d>(wire.covariance())};
  }
  if (wire.kind() == kMetric3) {
    const Eigen::Quaterniond rotation(mean[6], mean[3], mean[4], mean[5]);
    return Metric3{{rotation, {mean[0], mean[1], mean[2]}}, matrix_from<Matrix6d>(wire.covariance())};
  }
  return AlongPath{mean[0], wire.covariance()[0], mean[1], wire.covariance()[1]};
}

}  // namespace

idl::Header to_idl(const msg::Header& header) {
  idl::Header wire;
  wire.sender(header.sender.bytes);
  wire.incarnation(header.incarnation);
  wire.epoch(header.epoch.value);
  wire.sequence_number(header.sequence);
  wire.signature(header.signature);
  return wire;
}

msg::Header from_idl(const idl::Header& header, Reading reading) {
  msg::Header value;
  value.sender = reading.some("sender", id_from<PeerId>(header.sender()));
  value.incarnation = header.incarnation();
  value.epoch = Epoch{header.epoch()};
  value.sequence = header.sequence_number();
  value.signature = reading.list("signature", header.signature(), kSignatureBytes);
  return value;
}

idl::PlaceId to_idl(const PlaceId& id) {
  idl::PlaceId wire;
  wire.experience(id.experience.value);
  wire.index(id.index);
  return wire;
}

PlaceId from_idl(const idl::PlaceId& id) {
  return {ExperienceId{id.experience()}, id.index()};
}

idl::Relation to_idl(const Relation& relation) {
  return std::visit(Pack{}, relation);
}

Relation from_idl(const idl::Relation& relation, Reading reading) {
  struct Sizes {
    std::size_t mean, covariance;
  };
  constexpr Sizes kSizes[] = {{3, 9}, {7, 36}, {2, 2}};
  if (relation.kind() < kMetric2 || relation.kind() > kAlongPath) {
    reading.complain("kind", "must be from 1 to 3");
    return {};
  }
  const Sizes expected = kSizes[relation.kind() - 1];
  if (relation.mean().size() != expected.mean || relation.covariance().size() != expected.covariance) {
    reading.complain("mean and covariance", "must have the sizes of the relation's kind");
    return {};
  }
  Relation value = unpacked(relation);
  if (const Result<void> checked = check(value); !checked) reading.complain("relation", checked.error().message);
  return value;
}

idl::Place to_idl(const Place& place) {
  idl::Place wire;
  wire.id(to_idl(place.id));
  wire.entity_version(place.entity_version);
  wire.method(place.method);
  wire.content_format(place.content_format);
  wire.content_hash(place.content.hash.bytes);
  wire.content_size(place.content.size);
  wire.robot(place.robot.bytes);
  wire.frame(place.frame);
  wire.seen_at_ns(place.seen_at.time_since_epoch().count());
  return wire;
}

Place from_idl(const idl::Place& place, Reading reading) {
  Place value;
  value.id = reading.some("id", from_idl(place.id()));
  value.entity_version = place.entity_version();
  value.method = reading.text("method", place.method(), kNameLength);
  value.content_format = place.content_format();
  value.content.hash = reading.some("content_hash", id_from<ContentHash>(place.content_hash()));
  value.content.size = place.content_size();
  reading.require(value.content.size <= msg::kContentBytes, "content_size", "is larger than the largest content");
  value.robot = reading.some("robot", id_from<RobotId>(place.robot()));
  value.frame = place.frame();
  value.seen_at = SensorTime(Duration(place.seen_at_ns()));
  return value;
}

idl::EdgeId to_idl(const EdgeId& id) {
  idl::EdgeId wire;
  wire.a(to_idl(id.a));
  wire.b(to_idl(id.b));
  return wire;
}

EdgeId from_idl(const idl::EdgeId& id, Reading reading) {
  EdgeId value{reading.some("a", from_idl(id.a())), reading.some("b", from_idl(id.b()))};
  reading.require(value.a != value.b, "b", "must not be the edge's other end");
  return value;
}

idl::Edge to_idl(const Edge& edge) {
  idl::Edge wire;
  wire.id(to_idl(edge.id));
  wire.entity_version(edge.entity_version);
  wire.a_from_b(to_idl(edge.a_from_b));
  wire.origin(static_cast<std::uint8_t>(edge.origin));
  wire.method(edge.method);
  wire.drivable(static_cast<std::uint8_t>(edge.drivable));
  wire.inliers(edge.inliers);
  wire.overlap(edge.overlap);
  return wire;
}

Edge from_idl(const idl::Edge& edge, Reading reading) {
  Edge value;
  value.id = from_idl(edge.id(), reading.in("id"));
  value.entity_version = edge.entity_version();
  value.a_from_b = from_idl(edge.a_from_b(), reading.in("a_from_b"));
  value.origin = reading.choice("origin", edge.origin(), Origin::odometry, Origin::stitch);
  value.method = reading.text("method", edge.method(), kNameLength);
  value.drivable = reading.choice("drivable", edge.drivable(), Drivable::none, Drivable::both);
  value.inliers = edge.inliers();
  value.overlap = edge.overlap();
  reading.require(value.overlap >= 0.0F && value.overlap <= 1.0F, "overlap", "must be from 0 to 1");
  return value;
}

idl::Route to_idl(const Route& route) {
  idl::Route wire;
  wire.goal(route.goal.bytes);
  wire.id(route.id.bytes);
  wire.version(route.version);
  wire.made_of(route.made_of.value);
  wire.robot(route.robot.bytes);
  wire.places(list_to_idl<idl::PlaceId>(route.places));
  wire.relations(list_to_idl<idl::Relation>(route.relations));
  wire.released(route.released);
  wire.ended(route.ended);
  wire.reason(route.reason);
  return wire;
}

Route from_idl(const idl::Route& route, Reading reading) {
  Route value;
  value.goal = id_from<GoalId>(route.goal());
  value.id = reading.some("id", id_from<RouteId>(route.id()));
  value.version = route.version();
  value.made_of = Revision{route.made_of()};
  value.robot = reading.some("robot", id_from<RobotId>(route.robot()));
  value.places = places_from_idl(route.places(), reading, "places", kRoutePlaces);
  value.relations = list_from_idl<Relation>(route.relations(), reading, "relations", kRoutePlaces);
  const std::size_t joints = value.places.empty() ? 0 : value.places.size() - 1;
  reading.require(value.relations.size() == joints, "relations", "must be one fewer than places");
  value.released = route.released();
  reading.require(value.released < value.places.size() || (value.places.empty() && value.released == 0), "released",
                  "must be the index of a place");
  value.ended = route.ended();
  value.reason = reading.text("reason", route.reason(), kTextLength);
  return value;
}

std::vector<idl::SitePoint> to_idl(const std::vector<msg::AgentCommand::Point>& line) {
  std::vector<idl::SitePoint> wire(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    wire[i].x(line[i].x);
    wire[i].y(line[i].y);
  }
  return wire;
}

std::vector<msg::AgentCommand::Point> from_idl(const std::vector<idl::SitePoint>& line, Reading reading) {
  std::vector<msg::AgentCommand::Point> value;
  if (line.size() > kLinePoints) {
    reading.list("points", line, kLinePoints);
    return value;
  }
  value.reserve(line.size());
  for (const idl::SitePoint& point : line) {
    value.push_back({reading.finite("x", point.x()), reading.finite("y", point.y())});
  }
  return value;
}

std::vector<idl::NamedCount> counts_to_idl(const Counts& counts) {
  std::vector<idl::NamedCount> wire(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    wire[i].name(counts[i].first);
    wire[i].count(counts[i].second);
  }
  return wire;
}

Counts counts_from_idl(const std::vector<idl::NamedCount>& counts, Reading& reading, std::string_view field) {
  Counts list;
  for (const idl::NamedCount& one : reading.list(field, counts, kCounters)) {
    list.emplace_back(reading.text(field, one.name(), kTextLength), one.count());
  }
  return list;
}

std::vector<PlaceId> places_from_idl(const std::vector<idl::PlaceId>& ids, Reading& reading, std::string_view field,
                                     std::size_t most) {
  std::vector<PlaceId> list;
  if (ids.size() > most) {
    reading.list(field, ids, most);
    return list;
  }
  list.reserve(ids.size());
  for (const idl::PlaceId& id : ids) list.push_back(reading.some(field, from_idl(id)));
  return list;
}

idl::Stretch to_idl(const Stretch& stretch) {
  idl::Stretch wire;
  wire.experience(stretch.experience.value);
  wire.first(stretch.first);
  wire.last(stretch.last);
  return wire;
}

Stretch from_idl(const idl::Stretch& wire, Reading reading) {
  const Stretch value{reading.some("experience", ExperienceId{wire.experience()}), wire.first(), wire.last()};
  reading.require(value.first <= value.last, "last", "must not be before first");
  return value;
}

idl::Apart to_idl(const Apart& apart) {
  idl::Apart wire;
  wire.one(to_idl(apart.one));
  wire.other(to_idl(apart.other));
  return wire;
}

Apart from_idl(const idl::Apart& wire, Reading reading) {
  return {from_idl(wire.one(), reading.in("one")), from_idl(wire.other(), reading.in("other"))};
}

std::vector<idl::Label> labels_to_idl(const std::map<std::string, PlaceId>& labels) {
  std::vector<idl::Label> wire;
  wire.reserve(labels.size());
  for (const auto& [name, place] : labels) {
    idl::Label label;
    label.name(name);
    label.place(to_idl(place));
    wire.push_back(std::move(label));
  }
  return wire;
}

std::map<std::string, PlaceId> labels_from_idl(const std::vector<idl::Label>& wire, Reading reading) {
  std::map<std::string, PlaceId> labels;
  for (const idl::Label& label : wire) {
    const PlaceId place = reading.some("place", from_idl(label.place()));
    const bool is_new = labels.emplace(reading.text("name", label.name(), kNameLength), place).second;
    reading.require(is_new, "name", "must not stand twice");
  }
  return labels;
}

idl::Diagnostic to_idl(const Diagnostic& diagnostic) {
  idl::Diagnostic wire;
  wire.name(diagnostic.name);
  wire.value(diagnostic.value);
  wire.sigma(diagnostic.sigma);
  wire.bound(diagnostic.bound);
  return wire;
}

Diagnostic from_idl(const idl::Diagnostic& wire, Reading reading) {
  return {reading.text("name", wire.name(), kNameLength), reading.finite("value", wire.value()),
          reading.not_negative("sigma", wire.sigma()), reading.finite("bound", wire.bound())};
}

idl::TaughtStretch to_idl(const msg::TaughtStretch& stretch) {
  idl::TaughtStretch wire;
  wire.from_m(stretch.from_m);
  wire.to_m(stretch.to_m);
  wire.places(stretch.places);
  wire.first(to_idl(stretch.first));
  wire.found(list_to_idl<idl::Diagnostic>(stretch.found));
  wire.sigma_m(stretch.sigma_m);
  wire.reason(stretch.reason);
  return wire;
}

msg::TaughtStretch from_idl(const idl::TaughtStretch& wire, Reading reading) {
  msg::TaughtStretch value;
  value.from_m = reading.not_negative("from_m", wire.from_m());
  value.to_m = reading.not_negative("to_m", wire.to_m());
  reading.require(value.from_m <= value.to_m, "to_m", "must not be before from_m");
  value.places = wire.places();
  value.first = reading.some("first", from_idl(wire.first()));
  value.found = list_from_idl<Diagnostic>(wire.found(), reading, "found", msg::kReportConditions);
  for (std::size_t i = 0; i < value.found.size(); ++i) {
    const double share = value.found[i].value;
    reading.in("found", i).require(share >= 0.0 && share <= 1.0, "value", "must be from 0 to 1");
  }
  value.sigma_m = reading.not_negative("sigma_m", wire.sigma_m());
  value.reason = reading.text("reason", wire.reason(), kNameLength);
  return value;
}

}  // namespace weft::convert
