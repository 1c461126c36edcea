#include "storage/sqlite/loader.hpp"

#include "core/network/codec.hpp"
#include "storage/lineage.hpp"
#include "storage/network_builder.hpp"
#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/scope.hpp"

namespace weft::storage::sqlite {
namespace {

Result<void> load_experiences(const Database& database, const Scope& scope, NetworkBuilder& builder,
                              std::map<ExperienceId, std::uint64_t>& durable_through) {
  return for_each_row_of(
      scope, database, "SELECT id, robot, name, method, sealed, seal_reason, places, durable_through FROM experience",
      "id", "", [&](const Query& row) {
        NetworkBuilder::Head head;
        head.id = {row.number(0)};
        head.robot = row.id<RobotId>(1);
        head.name = row.text(2);
        head.method = row.text(3);
        head.sealed = row.number(4) != 0;
        head.seal_reason = row.text(5);
        head.places = row.number(6);
        durable_through[head.id] = row.number(7);
        builder.add(std::move(head));
      });
}

Result<void> load_deleted(const Database& database, const Scope& scope, NetworkBuilder& builder) {
  return for_each_row_of(
      scope, database, "SELECT experience, first_place, last_place FROM deleted_places", "experience", "",
      [&](const Query& row) {
        const PlaceId first = place_id(row, 0);
        builder.add_deleted({first.experience, first.index, static_cast<std::uint32_t>(row.number(2))});
      });
}

Result<void> load_places(const Database& database, const Scope& scope, const Lineage& lineage,
                         NetworkBuilder& builder) {
  return for_each_row_of(scope, database, "SELECT experience, place, row, revision FROM place", "experience",
                         " ORDER BY experience, place", [&](const Query& row) {
                           const PlaceId id = place_id(row, 0);
                           if (!lineage.contains(row.number(3))) return builder.add_absent(id);
                           Result<Place> place = decode_guarded(row.blob(2), decode_place);
                           if (place && place->id == id) {
                             builder.add(std::move(*place));
                           } else {
                             builder.add_damaged(id, place ? "the row of another place" : place.error().message);
                           }
                         });
}

/// Loads later versions of places, in the order of revisions, after the places themselves. One that is damaged leaves
/// the version before.
Result<void> load_places_anew(const Database& database, const Scope& scope, const Lineage& lineage,
                              NetworkBuilder& builder) {
  return for_each_row_of(scope, database, "SELECT experience, place, row, revision FROM place_anew", "experience",
                         " ORDER BY experience, place, revision", [&](const Query& row) {
                           const PlaceId id = place_id(row, 0);
                           if (!lineage.contains(row.number(3))) return;
                           Result<Place> place = decode_guarded(row.blob(2), decode_place);
                           if (place && place->id == id) return builder.add(std::move(*place));
                           builder.add_damage("place " + to_string(id) + ", as it is known since revision " +
                                              std::to_string(row.number(3)) + ": " +
                                              (place ? "the row of another place" : place.error().message) +
                                              "; what was known before is served");
                         });
}

Result<void> load_edges(const Database& database, const Scope& scope, const Lineage& lineage,
                        NetworkBuilder& builder) {
  const std::string select = "SELECT a_experience, a_place, b_experience, b_place, row, revision FROM edge";
  const std::string order = " ORDER BY a_experience, a_place, b_experience, b_place, revision";
  const auto add = [&](const Query& row) {
    const EdgeId id{place_id(row, 0), place_id(row, 2)};
    if (!lineage.contains(row.number(5))) return builder.add_absent(id);
    Result<Edge> edge = decode_guarded(row.blob(4), decode_edge);
    if (edge && edge->id == id) {
      builder.add(std::move(*edge), {row.number(5)});
    } else {
      builder.add_absent(id);
      builder.add_damage("edge " + to_string(id.a) + " - " + to_string(id.b) + ": " +
                         (edge ? "the row of another edge" : edge.error().message));
    }
  };
  auto done = for_each_row_of(scope, database, select, "a_experience", order, add);
  if (!done || !scope.only) return done;
  // Those that come in from experiences that are not read.
  return for_each_row_of(scope, database, select, "a_experience <> b_experience AND b_experience", order,
                         [&](const Query& row) {
                           if (!scope.has({row.number(0)})) add(row);
                         });
}

Result<void> load_labels(const Database& database, const Lineage& lineage, NetworkBuilder& builder) {
  return for_each_row(database, "SELECT label, experience, place, revision FROM label ORDER BY label, revision",
                      [&](const Query& row) {
                        if (lineage.contains(row.number(3))) builder.add_label(row.text(0), place_id(row, 1));
                      });
}

Result<void> load_aparts(const Database& database, const Lineage& lineage, NetworkBuilder& builder) {
  return for_each_row(database,
                      std::string("SELECT ") + kApartColumns + ", holds, revision FROM apart ORDER BY revision",
                      [&](const Query& row) {
                        if (lineage.contains(row.number(7))) builder.add_apart(apart(row), row.number(6) != 0);
                      });
}

Result<void> load_rules(const Database& database, const Lineage& lineage, NetworkBuilder& builder) {
  return for_each_row(
      database, "SELECT name, holds, row, revision FROM rule ORDER BY revision", [&](const Query& row) {
        if (!lineage.contains(row.number(3))) return;
        const auto rule = decode_guarded(row.blob(2), decode_rule);
        if (!rule) {
          builder.add_damage("rule " + row.text(0) + ": " + rule.error().message + "; lay it down again");
          return;
        }
        builder.add_rule(*rule, row.number(1) != 0);
      });
}

Result<void> load_registrations(const Database& database, const Lineage& lineage, NetworkBuilder& builder) {
  return for_each_row(database, "SELECT plan, holds, row, revision FROM registration ORDER BY revision",
                      [&](const Query& row) {
                        if (!lineage.contains(row.number(3))) return;
                        const auto registration = decode_guarded(row.blob(2), decode_registration);
                        if (!registration) {
                          builder.add_damage("registration of plan " + row.text(0) + ": " +
                                             registration.error().message + "; register it again");
                          return;
                        }
                        builder.add_registration(*registration, row.number(1) != 0);
                      });
}

Result<void> load_moves(const Database& database, const Scope& scope, const Lineage& lineage,
                        NetworkBuilder& builder) {
  auto done = for_each_row(
      database,
      "SELECT experience, first_place, last_place, is_back, revision FROM moved_places ORDER BY revision, is_back",
      [&](const Query& row) {
        if (!scope.has({row.number(0)}) || !lineage.contains(row.number(4))) return;
        const Stretch stretch{
            {row.number(0)}, static_cast<std::uint32_t>(row.number(1)), static_cast<std::uint32_t>(row.number(2))};
        builder.move({{stretch}, {}}, row.number(3) != 0, {row.number(4)});
      });
  if (!done) return done;
  return for_each_row(
      database,
      "SELECT a_experience, a_place, b_experience, b_place, is_back, revision FROM moved_stitch ORDER BY revision, "
      "is_back",
      [&](const Query& row) {
        if (!lineage.contains(row.number(5))) return;
        builder.move({{}, {{place_id(row, 0), place_id(row, 2)}}}, row.number(4) != 0, {row.number(5)});
      });
}

/// Loads one table of rows that are kept by an id: goals or routes.
template <class Value, class Id, class Decode>
Result<void> load_rows(const Database& database, const char* sql, const char* what, Decode&& decode,
                       NetworkBuilder& builder, std::map<Id, Value>& out) {
  return for_each_row(database, sql, [&](const Query& row) {
    const Id id = row.template id<Id>(0);
    Result<Value> value = decode_guarded(row.blob(1), decode);
    if (value) {
      out.emplace(id, std::move(*value));
    } else {
      builder.add_damage(std::string(what) + " " + to_string(id) + ": " + value.error().message);
    }
  });
}

Result<void> load_occupancies(const Database& database, NetworkBuilder& builder, Stored& stored) {
  return for_each_row(database, "SELECT robot, row, first_place, last_place FROM occupancy", [&](const Query& row) {
    const RobotId robot = row.id<RobotId>(0);
    Result<Route> held = decode_guarded(row.blob(1), decode_route);
    if (held) {
      stored.occupancies[robot] = {robot, std::move(*held), static_cast<std::uint32_t>(row.number(2)),
                                   static_cast<std::uint32_t>(row.number(3))};
    } else {
      builder.add_damage("occupancy of robot " + to_string(robot) + ": " + held.error().message +
                         "; see where it stands, then clear it");
    }
  });
}

Result<void> load_robots(const Database& database, Stored& stored) {
  return for_each_row(database, "SELECT id, name FROM robot",
                      [&](const Query& row) { stored.robots[row.id<RobotId>(0)] = row.text(1); });
}

Result<void> load_awaited_labels(const Database& database, NetworkBuilder& builder, Stored& stored) {
  const std::string sql = std::string("SELECT label, ") + kAwaitedLabelColumns + " FROM awaited_label";
  return for_each_row(database, sql, [&](const Query& row) {
    Result<PutAwaitedLabel> label = awaited_label(row);
    if (label) {
      std::string name = label->label;
      stored.awaited_labels[std::move(name)] = *std::move(label);
    } else {
      builder.add_damage("awaited_label " + row.text(0) + ": " + label.error().message + "; give it again");
    }
  });
}

Result<void> load_passes(const Database& database, NetworkBuilder& builder, Stored& stored) {
  return for_each_row(database, "SELECT experience, piece, onward, row FROM passes", [&](const Query& row) {
    const RunPiece piece = run_piece(row, 0);
    Result<std::vector<Pass>> passes = decode_guarded(row.blob(3), decode_passes);
    if (passes) {
      stored.passes[piece] = std::move(*passes);
    } else {
      builder.add_damage(passes_of(piece) + ": " + passes.error().message + "; they are learned anew");
    }
  });
}

Result<void> load_network(const Database& database, const Scope& scope, const Lineage& lineage,
                          NetworkBuilder& builder, std::map<ExperienceId, std::uint64_t>& durable_through) {
  Result<void> done = load_experiences(database, scope, builder, durable_through);
  if (done) done = load_deleted(database, scope, builder);
  if (done) done = load_moves(database, scope, lineage, builder);
  if (done) done = load_places(database, scope, lineage, builder);
  if (done) done = load_places_anew(database, scope, lineage, builder);
  if (done) done = load_edges(database, scope, lineage, builder);
  if (done) done = load_labels(database, lineage, builder);
  if (done) done = load_aparts(database, lineage, builder);
  if (done) done = load_rules(database, lineage, builder);
  if (done) done = load_registrations(database, lineage, builder);
  return done;
}

Result<void> load_quarantined_contents(const Database& database, NetworkBuilder& builder) {
  return for_each_row(database, "SELECT hash FROM content WHERE quarantined = 1", [&](const Query& row) {
    builder.add_damage("content " + to_string(row.id<ContentHash>(0)) + ": its bytes are damaged");
  });
}

}  // namespace

Result<std::map<Revision, Revision>> load_bases(const Database& database) {
  std::map<Revision, Revision> bases;
  const auto done = for_each_row(database, "SELECT id, base FROM revision WHERE base <> id - 1",
                                 [&](const Query& row) { bases[{row.number(0)}] = {row.number(1)}; });
  if (!done) return fail(done.error());
  return bases;
}

Result<Snapshot> load_snapshot(const Database& database, Revision revision, const Snapshot& near) {
  const auto bases = load_bases(database);
  if (!bases) return fail(bases.error());
  const Lineage lineage(revision, *bases);
  Scope scope;
  if (near.revision().value != 0) {
    auto differing = scope_between(database, lineage, Lineage(near.revision(), *bases));
    if (!differing) return fail(differing.error());
    scope = *std::move(differing);
  }
  NetworkBuilder builder;
  std::map<ExperienceId, std::uint64_t> durable_through;
  if (auto done = load_network(database, scope, lineage, builder, durable_through); !done) return fail(done.error());
  return builder.build(revision, near);
}

Result<Stored> load(const Database& database, Epoch epoch, Revision revision) {
  Stored stored;
  stored.epoch = epoch;
  const auto bases = load_bases(database);
  if (!bases) return fail(bases.error());
  NetworkBuilder builder;
  Result<void> done = load_network(database, {}, Lineage(revision, *bases), builder, stored.durable_through);
  if (done) {
    done = load_rows<Goal>(database, "SELECT id, row FROM goal", "goal", decode_goal, builder, stored.goals);
  }
  if (done) {
    done = load_rows<Route>(database, "SELECT goal, row FROM route", "route of goal", decode_route, builder,
                            stored.routes);
  }
  if (done) done = load_occupancies(database, builder, stored);
  if (done) done = load_robots(database, stored);
  if (done) {
    done = for_each_row(database, "SELECT robot, who FROM hold",
                        [&](const Query& row) { stored.holds[row.id<RobotId>(0)] = row.text(1); });
  }
  if (done) done = load_awaited_labels(database, builder, stored);
  if (done) done = load_passes(database, builder, stored);
  if (done) done = load_quarantined_contents(database, builder);
  if (!done) return fail(done.error());
  stored.snapshot = builder.build(revision);
  stored.quarantined = builder.take_damage();
  return stored;
}

}  // namespace weft::storage::sqlite
