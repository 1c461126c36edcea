#include "storage/sqlite/writer.hpp"

#include "core/network/codec.hpp"
#include "storage/sqlite/rows.hpp"

namespace weft::storage::sqlite {
namespace {

/// Writes changes, one call each; `row` is the store's row of this transaction.
class Writer {
 public:
  Writer(const Statements& statements, ContentCoder& coder, StoreRow& row)
      : statements_(statements), coder_(coder), row_(row) {}

  Result<void> operator()(const PutContent& put) const {
    const Coded coded = coder_.encode(put.bytes);
    const ByteView bytes = coded.coding == Coding::raw ? ByteView(put.bytes) : ByteView(coded.bytes);
    const ContentRow row{put.hash, put.bytes.size(), static_cast<std::uint64_t>(coded.coding)};
    Query query(statements_.put_content);
    query << put.hash << static_cast<std::uint64_t>(put.kind) << row.size << row.coding << bytes
          << content_sum(row, bytes);
    ++row_.contents;
    row_.content_bytes += put.bytes.size();
    return query.run();
  }

  Result<void> operator()(const AppendBatch& append) const {
    const Batch& batch = append.batch;
    if (auto done = put_experience(batch); !done) return done;
    if (auto done = put_places(statements_.put_place, batch.places); !done) return done;
    if (auto done = put_places(statements_.put_place_anew, batch.learned); !done) return done;
    for (const Edge& edge : batch.edges) {
      if (auto done = put_edge(edge); !done) return done;
    }
    Query query(statements_.put_batch);
    query << batch.experience.value << batch.sequence << row_.revision.value << append.hash;
    return query.run();
  }

  Result<void> operator()(const PutPlaces& put) const { return put_places(statements_.put_place_anew, put.places); }

  Result<void> operator()(const PutLabel& put) const {
    Query query(statements_.put_label);
    query << std::string_view(put.label) << row_.revision.value << put.place.experience.value
          << std::uint64_t{put.place.index};
    return query.run();
  }

  Result<void> operator()(const PutApart& put) const {
    const Apart apart = ordered(put.apart);
    Query query(statements_.put_apart);
    for (const Stretch& stretch : {apart.one, apart.other}) {
      query << stretch.experience.value << std::uint64_t{stretch.first} << std::uint64_t{stretch.last};
    }
    query << row_.revision.value << std::uint64_t{put.holds};
    return query.run();
  }

  Result<void> operator()(const PutRule& put) const {
    const Bytes bytes = guard_row(encode(put.rule));
    Query query(statements_.put_rule);
    query << std::string_view(put.rule.name) << row_.revision.value << std::uint64_t{put.holds} << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const PutRegistration& put) const {
    const Bytes bytes = guard_row(encode(put.registration));
    Query query(statements_.put_registration);
    query << std::string_view(put.registration.plan) << row_.revision.value << std::uint64_t{put.holds}
          << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const SealExperience& seal) const {
    Query query(statements_.seal);
    query << std::string_view(seal.reason) << seal.experience.value;
    return query.run();
  }

  Result<void> operator()(const TakeOut& out) const { return move(out.what, false); }
  Result<void> operator()(const BringBack& back) const { return move(back.what, true); }
  /// Writes nothing: the revision's row says it all.
  Result<void> operator()(const RollBack& /*back*/) const { return {}; }

  Result<void> operator()(const PutGoal& put) const {
    const Bytes bytes = guard_row(encode(put.goal));
    Query query(statements_.put_goal);
    query << put.goal.id << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const PutRoute& put) const {
    const Bytes bytes = guard_row(encode(put.route));
    Query query(statements_.put_route);
    query << put.route.goal << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const PutOccupancy& put) const {
    if (put.held.places.empty()) {
      Query query(statements_.free_occupancy);
      query << put.robot;
      return query.run();
    }
    const Bytes bytes = guard_row(encode(put.held));
    Query query(statements_.put_occupancy);
    query << put.robot << std::uint64_t{put.from} << std::uint64_t{put.to} << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const PutRobot& put) const {
    Query query(statements_.put_robot);
    query << put.robot << std::string_view(put.name);
    return query.run();
  }

  Result<void> operator()(const PutHold& put) const {
    Query query(put.who.empty() ? statements_.free_hold : statements_.put_hold);
    query << put.robot;
    if (!put.who.empty()) query << std::string_view(put.who);
    return query.run();
  }

  Result<void> operator()(const PutAwaitedLabel& put) const {
    if (!put.place.experience) {
      Query query(statements_.drop_awaited_label);
      query << std::string_view(put.label);
      return query.run();
    }
    Query query(statements_.put_awaited_label);
    query << std::string_view(put.label) << put.place.experience.value << std::uint64_t{put.place.index} << put.robot
          << put.asker << put.request << std::string_view(put.who);
    return query.run();
  }

  Result<void> operator()(const PutPasses& put) const {
    const Bytes bytes = guard_row(encode(put.passes));
    Query query(statements_.put_passes);
    query << put.piece.experience.value << std::uint64_t{put.piece.number} << std::uint64_t{put.piece.is_onward}
          << ByteView(bytes);
    return query.run();
  }

  Result<void> operator()(const PutEvent& put) const {
    const msg::Event& event = put.event;
    Query query(statements_.put_event);
    query << static_cast<std::uint64_t>(event.at.time_since_epoch().count()) << std::string_view(event.kind)
          << event.robot << event.goal << std::string_view(event.cause) << std::string_view(event.who);
    return query.run();
  }

  Result<void> operator()(const PutPreparation& put) const {
    Query query(statements_.put_preparation);
    const ContentHash hash = hash_bytes(put.bytes);
    query << std::string_view(put.methods) << hash << ByteView(put.bytes);
    return query.run();
  }

 private:
  Result<void> put_experience(const Batch& batch) const {
    Query query(statements_.put_experience);
    query << batch.experience.value << batch.robot << std::string_view(batch.name) << std::string_view(batch.method)
          << std::uint64_t{batch.seal} << std::string_view(batch.seal_reason) << batch.sequence
          << std::uint64_t{batch.places.size()};
    return query.run();
  }

  Result<void> put_places(const Statement& statement, const std::vector<Place>& places) const {
    for (const Place& place : places) {
      const Bytes bytes = guard_row(encode(place));
      Query query(statement);
      query << place.id.experience.value << std::uint64_t{place.id.index} << row_.revision.value << ByteView(bytes);
      if (auto done = query.run(); !done) return done;
    }
    return {};
  }

  Result<void> put_edge(const Edge& edge) const {
    const Bytes bytes = guard_row(encode(edge));
    Query query(statements_.put_edge);
    query << edge.id.a.experience.value << std::uint64_t{edge.id.a.index} << edge.id.b.experience.value
          << std::uint64_t{edge.id.b.index} << row_.revision.value << ByteView(bytes);
    return query.run();
  }

  Result<void> move(const Removal& removal, bool is_back) const {
    for (const Stretch& stretch : removal.places) {
      Query query(statements_.move_places);
      query << row_.revision.value << stretch.experience.value << std::uint64_t{stretch.first}
            << std::uint64_t{stretch.last} << std::uint64_t{is_back};
      if (auto done = query.run(); !done) return done;
    }
    for (const EdgeId& stitch : removal.stitches) {
      Query query(statements_.move_stitch);
      query << row_.revision.value << stitch.a.experience.value << std::uint64_t{stitch.a.index}
            << stitch.b.experience.value << std::uint64_t{stitch.b.index} << std::uint64_t{is_back};
      if (auto done = query.run(); !done) return done;
    }
    return {};
  }

  const Statements& statements_;
  ContentCoder& coder_;
  StoreRow& row_;
};

Result<void> write_note(const Statements& statements, const RevisionNote& note) {
  Query query(statements.put_revision);
  query << note.revision.value << note.base.value << static_cast<std::uint64_t>(note.at.time_since_epoch().count())
        << std::string_view(note.kind) << std::string_view(note.who) << std::string_view(note.cause);
  return query.run();
}

}  // namespace

Result<StoreRow> read_store_row(const Statements& statements) {
  Query query(statements.read_store);
  const Result<bool> found = query.step();
  if (!found) return fail(found.error());
  if (!*found) return fail(ErrorCode::corrupt, "map store: its table `store` is empty; restore a backup");
  return StoreRow{{query.number(0)}, {query.number(1)}, query.number(2), query.number(3), {query.number(4)}};
}

Result<void> write_store_row(const Statements& statements, const StoreRow& row) {
  Query query(statements.write_store);
  query << row.epoch.value << row.revision.value << row.contents << row.content_bytes << row.floor.value;
  return query.run();
}

namespace {

Result<void> read_moved_facts(const Statements& statements, const Needs& needs, Facts& facts) {
  for (const EdgeId& id : needs.stitches) {
    Query query(statements.find_edge);
    query << id.a.experience.value << std::uint64_t{id.a.index} << id.b.experience.value << std::uint64_t{id.b.index};
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (*found) facts.stitches.insert(id);
  }
  for (const ExperienceId& id : needs.moved_in) {
    Query query(statements.find_deleted);
    query << id.value;
    for (;;) {
      const Result<bool> found = query.step();
      if (!found) return fail(found.error());
      if (!*found) break;
      facts.deleted[id].push_back(
          {id, static_cast<std::uint32_t>(query.number(0)), static_cast<std::uint32_t>(query.number(1))});
    }
  }
  return {};
}

}  // namespace

Result<Facts> read_facts(const Statements& statements, const Needs& needs) {
  Facts facts;
  for (const ExperienceId& id : needs.experiences) {
    Query query(statements.find_experience);
    query << id.value;
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (*found) facts.experiences[id] = {query.number(0), query.number(1)};
  }
  for (const BatchKey& key : needs.batches) {
    Query query(statements.find_batch);
    query << key.first.value << key.second;
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (*found) facts.batches[key] = query.id<ContentHash>(0);
  }
  for (const ContentHash& hash : needs.contents) {
    Query query(statements.find_content);
    query << hash;
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (*found) facts.contents.insert(hash);
  }
  if (auto done = read_moved_facts(statements, needs, facts); !done) return fail(done.error());
  return facts;
}

Result<StoreRow> write_changes(const Statements& statements, ContentCoder& coder, const Transaction& transaction,
                               const Plan& plan, StoreRow row) {
  if (plan.changes_network) {
    if (auto done = write_note(statements, note_of(transaction, row.revision)); !done) return fail(done.error());
    ++row.revision.value;
  }
  const Writer write(statements, coder, row);
  for (std::size_t at = 0; at < transaction.changes.size(); ++at) {
    if (!plan.fresh[at]) continue;
    if (auto done = std::visit(write, transaction.changes[at]); !done) return fail(done.error());
  }
  if (auto done = write_store_row(statements, row); !done) return fail(done.error());
  return row;
}

}  // namespace weft::storage::sqlite
