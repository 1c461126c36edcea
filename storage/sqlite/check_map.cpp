#include <optional>

#include "core/network/codec.hpp"
#include "storage/sqlite/check_parts.hpp"
#include "storage/sqlite/lookup.hpp"
#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kMapPiece = 500;

std::string name_of(const EdgeId& id) {
  return to_string(id.a) + " - " + to_string(id.b);
}

/// Checks one table of the map: one `visit` a row, collected first, so that lookups may follow.
template <class Row>
class MapCheck : public CheckPart {
 public:
  MapCheck(const Parts& parts, Scan scan, Lookup lookup)
      : parts_(parts), scan_(std::move(scan)), lookup_(std::move(lookup)) {}

  Result<bool> step(Findings& findings) final {
    lookup_.forget();
    const auto reading = ReadTransaction::begin(parts_.database);
    if (!reading) return fail(reading.error());
    std::vector<Row> rows;
    const Result<bool> more = scan_.next(kMapPiece, [&](const Query& row) { rows.push_back(read(row)); });
    if (!more) return fail(more.error());
    for (const Row& row : rows) {
      if (auto done = look(row, findings); !done) return fail(done.error());
    }
    return more;
  }
  std::uint64_t done() const override { return done_; }

 protected:
  virtual Row read(const Query& row) = 0;
  virtual Result<void> look(const Row& row, Findings& findings) = 0;

  /// Adds a finding about `name` when its revision is none of the map's.
  void check_revision(std::uint64_t revision, const std::string& name, Findings& findings) const {
    if (revision >= 1 && revision <= parts_.row.revision.value) return;
    findings.push_back(name + ": it says revision " + std::to_string(revision) + ", the newest is " +
                       std::to_string(parts_.row.revision.value));
  }

  const Parts& parts_;
  Scan scan_;
  Lookup lookup_;
  std::uint64_t done_ = 0;
};

struct PlaceRow {
  PlaceId id;
  std::uint64_t revision = 0;
  Result<Place> place;
};

Result<void> check_place_row(const PlaceRow& row, const std::string& name, const Lookup& lookup, Findings& findings) {
  if (!row.place) {
    findings.push_back(name + ": " + row.place.error().message);
    return {};
  }
  if (row.place->id != row.id) {
    findings.push_back(name + ": the row of another place");
    return {};
  }
  const Result<bool> stored = lookup.has_content(row.place->content.hash);
  if (!stored) return fail(stored.error());
  if (!*stored) findings.push_back(name + ": its content " + to_string(row.place->content.hash) + " is not stored");
  return {};
}

class PlaceCheck final : public MapCheck<PlaceRow> {
 public:
  using MapCheck::MapCheck;

 private:
  PlaceRow read(const Query& row) override {
    ++done_;
    return {place_id(row, 0), row.number(2), decode_guarded(row.blob(3), decode_place)};
  }

  Result<void> look(const PlaceRow& row, Findings& findings) override {
    const bool is_next = last_ && last_->experience == row.id.experience;
    const PlaceId before = is_next ? *last_ : PlaceId{row.id.experience, 0};
    const std::uint32_t expected = is_next ? last_->index + 1 : 0;
    last_ = row.id;
    const Result<bool> deleted = lookup_.is_deleted(row.id);
    if (!deleted) return fail(deleted.error());
    if (*deleted) return {};
    const std::string name = "place " + to_string(row.id);
    if (!is_next) {
      const auto experience = lookup_.experience(row.id.experience);
      if (!experience) return fail(experience.error());
      if (!*experience) findings.push_back(name + ": its experience has no row");
    }
    if (auto done = check_gap(expected, row.id, findings); !done) return done;
    if (is_next && before.index + 1 == row.id.index) {
      if (auto done = check_hop(before, row.id, findings); !done) return done;
    }
    check_revision(row.revision, name, findings);
    return check_place_row(row, name, lookup_, findings);
  }

  /// Reports places that are missing before this one and were not deleted; those missing after the last row are found
  /// by the experience's check.
  Result<void> check_gap(std::uint32_t expected, const PlaceId& id, Findings& findings) {
    const auto deleted = lookup_.deleted_of(id.experience);
    if (!deleted) return fail(deleted.error());
    for (const Stretch& stretch : **deleted) {
      if (stretch.last < expected) continue;
      if (stretch.first > expected) break;
      expected = stretch.last + 1;
    }
    if (expected >= id.index) return {};
    findings.push_back("place " + to_string(PlaceId{id.experience, expected}) + " to " +
                       std::to_string(id.index - 1) + ": the rows are missing");
    return {};
  }

  Result<void> check_hop(const PlaceId& from, const PlaceId& to, Findings& findings) {
    const Result<bool> deleted = lookup_.is_deleted(from);
    if (!deleted) return fail(deleted.error());
    const Result<bool> joined = *deleted ? Result<bool>(true) : lookup_.has_edge({from, to});
    if (!joined) return fail(joined.error());
    if (!*joined) findings.push_back("edge " + name_of({from, to}) + ": the row is missing");
    return {};
  }

  std::optional<PlaceId> last_;
};

/// Checks later versions of places, as they have become known anew (place_anew).
class PlaceAnewCheck final : public MapCheck<PlaceRow> {
 public:
  using MapCheck::MapCheck;

 private:
  PlaceRow read(const Query& row) override {
    ++done_;
    return {place_id(row, 0), row.number(2), decode_guarded(row.blob(3), decode_place)};
  }

  Result<void> look(const PlaceRow& row, Findings& findings) override {
    const Result<bool> deleted = lookup_.is_deleted(row.id);
    if (!deleted) return fail(deleted.error());
    if (*deleted) return {};
    const std::string name = "place " + to_string(row.id) + ", known since revision " + std::to_string(row.revision);
    const Result<bool> there = lookup_.has_place(row.id);
    if (!there) return fail(there.error());
    if (!*there) findings.push_back(name + ": the place itself is not stored");
    check_revision(row.revision, name, findings);
    return check_place_row(row, name, lookup_, findings);
  }
};

struct EdgeRow {
  EdgeId id;
  std::uint64_t revision = 0;
  Result<Edge> edge;
};

class EdgeCheck final : public MapCheck<EdgeRow> {
 public:
  using MapCheck::MapCheck;
  std::uint64_t done() const override { return passed_ + at_; }

 private:
  EdgeRow read(const Query& row) override {
    return {{place_id(row, 0), place_id(row, 2)}, row.number(4), decode_guarded(row.blob(5), decode_edge)};
  }

  Result<void> look(const EdgeRow& row, Findings& findings) override {
    if (auto done = count(row.id.a); !done) return done;
    const std::string name = "edge " + name_of(row.id);
    for (const PlaceId& end : {row.id.a, row.id.b}) {
      const Result<bool> deleted = lookup_.is_deleted(end);
      if (!deleted) return fail(deleted.error());
      if (*deleted) return {};  // goes with it
      const Result<bool> there = lookup_.has_place(end);
      if (!there) return fail(there.error());
      if (!*there) findings.push_back(name + ": its place " + to_string(end) + " is not stored");
    }
    check_revision(row.revision, name, findings);
    if (!row.edge) {
      findings.push_back(name + ": " + row.edge.error().message);
    } else if (row.edge->id != row.id) {
      findings.push_back(name + ": the row of another edge");
    }
    return {};
  }

  Result<void> count(const PlaceId& from) {
    if (experience_ != from.experience) {
      passed_ += places_;
      const auto row = lookup_.experience(from.experience);
      if (!row) return fail(row.error());
      places_ = *row ? (*row)->places : 0;
      experience_ = from.experience;
    }
    at_ = from.index;
    return {};
  }

  std::optional<ExperienceId> experience_;
  std::uint64_t places_ = 0;
  std::uint64_t passed_ = 0;
  std::uint64_t at_ = 0;
};

struct LabelRow {
  std::string label;
  std::uint64_t revision = 0;
  PlaceId place;
};

class LabelCheck final : public MapCheck<LabelRow> {
 public:
  using MapCheck::MapCheck;

 private:
  LabelRow read(const Query& row) override {
    ++done_;
    return {row.text(0), row.number(1), place_id(row, 2)};
  }
  Result<void> look(const LabelRow& row, Findings& findings) override {
    const std::string name = "label " + row.label;
    check_revision(row.revision, name, findings);
    if (!row.place.experience) return {};
    const Result<bool> there = lookup_.has_place(row.place);
    if (!there) return fail(there.error());
    const Result<bool> deleted = *there ? Result<bool>(true) : lookup_.is_deleted(row.place);
    if (!deleted) return fail(deleted.error());
    if (!*deleted) findings.push_back(name + ": its place " + to_string(row.place) + " is not stored");
    return {};
  }
};

struct RuleRow {
  std::string name;
  std::uint64_t revision = 0;
  Result<Rule> rule;
};

/// Checks rules by themselves: places that one names may be deleted for good, it holds on those that are there.
class RuleCheck final : public MapCheck<RuleRow> {
 public:
  using MapCheck::MapCheck;

 private:
  RuleRow read(const Query& row) override {
    ++done_;
    return {row.text(0), row.number(1), decode_guarded(row.blob(2), decode_rule)};
  }
  Result<void> look(const RuleRow& row, Findings& findings) override {
    const std::string name = "rule " + row.name;
    check_revision(row.revision, name, findings);
    if (!row.rule) {
      findings.push_back(name + ": " + row.rule.error().message);
    } else if (row.rule->name != row.name) {
      findings.push_back(name + ": the row of another rule");
    }
    return {};
  }
};

struct RegistrationRow {
  std::string plan;
  std::uint64_t revision = 0;
  Result<Registration> registration;
};

/// Checks registrations by themselves: places that one names may be deleted for good, as those of a rule.
class RegistrationCheck final : public MapCheck<RegistrationRow> {
 public:
  using MapCheck::MapCheck;

 private:
  RegistrationRow read(const Query& row) override {
    ++done_;
    return {row.text(0), row.number(1), decode_guarded(row.blob(2), decode_registration)};
  }
  Result<void> look(const RegistrationRow& row, Findings& findings) override {
    const std::string name = "registration of plan " + row.plan;
    check_revision(row.revision, name, findings);
    if (!row.registration) {
      findings.push_back(name + ": " + row.registration.error().message);
    } else if (row.registration->plan != row.plan) {
      findings.push_back(name + ": the row of another plan");
    }
    return {};
  }
};

struct ApartRow {
  Apart apart;
  std::uint64_t revision = 0;
};

class ApartCheck final : public MapCheck<ApartRow> {
 public:
  using MapCheck::MapCheck;

 private:
  ApartRow read(const Query& row) override {
    ++done_;
    return {apart(row), row.number(6)};
  }
  Result<void> look(const ApartRow& row, Findings& findings) override {
    const std::string name = "apart " + to_string(row.apart);
    check_revision(row.revision, name, findings);
    for (const Stretch& stretch : {row.apart.one, row.apart.other}) {
      const auto experience = lookup_.experience(stretch.experience);
      if (!experience) return fail(experience.error());
      if (!*experience) {
        findings.push_back(name + ": experience " + to_string(stretch.experience) + " has no row");
      } else if (stretch.last < stretch.first || stretch.last >= (*experience)->places) {
        findings.push_back(name + ": experience " + to_string(stretch.experience) + " has " +
                           std::to_string((*experience)->places) + " places");
      }
    }
    return {};
  }
};

struct MovedPlacesRow {
  std::uint64_t revision = 0;
  Stretch places;
  std::uint64_t last = 0;
};

class MovedPlacesCheck final : public MapCheck<MovedPlacesRow> {
 public:
  using MapCheck::MapCheck;

 private:
  MovedPlacesRow read(const Query& row) override {
    ++done_;
    const PlaceId first = place_id(row, 1);
    return {row.number(0), {first.experience, first.index, 0}, row.number(4)};
  }
  Result<void> look(const MovedPlacesRow& row, Findings& findings) override {
    const std::string name = "moved_places " + std::to_string(row.revision) + ", places " +
                             std::to_string(row.places.first) + " to " + std::to_string(row.last) +
                             " of experience " + to_string(row.places.experience);
    check_revision(row.revision, name, findings);
    const auto experience = lookup_.experience(row.places.experience);
    if (!experience) return fail(experience.error());
    if (!*experience) {
      findings.push_back(name + ": the experience has no row");
    } else if (row.last < row.places.first || row.last >= (*experience)->places) {
      findings.push_back(name + ": the experience has " + std::to_string((*experience)->places) + " places");
    }
    return {};
  }
};

struct MovedStitchRow {
  std::uint64_t revision = 0;
  EdgeId stitch;
};

class MovedStitchCheck final : public MapCheck<MovedStitchRow> {
 public:
  using MapCheck::MapCheck;

 private:
  MovedStitchRow read(const Query& row) override {
    ++done_;
    return {row.number(0), {place_id(row, 1), place_id(row, 3)}};
  }
  Result<void> look(const MovedStitchRow& row, Findings& findings) override {
    const std::string name = "moved_stitch " + std::to_string(row.revision) + ", " + name_of(row.stitch);
    check_revision(row.revision, name, findings);
    if (row.revision <= parts_.row.floor.value) return {};  // a compaction may have deleted it
    const Result<bool> there = lookup_.has_edge(row.stitch);
    if (!there) return fail(there.error());
    if (*there) return {};
    for (const PlaceId& end : {row.stitch.a, row.stitch.b}) {
      const Result<bool> deleted = lookup_.is_deleted(end);
      if (!deleted) return fail(deleted.error());
      if (*deleted) return {};  // the stitch went with it
    }
    findings.push_back(name + ": the stitch is not stored");
    return {};
  }
};

template <class Check>
Result<void> add(const Parts& parts, CheckParts& to, const char* table, const std::vector<std::string>& keys,
                 const char* columns) {
  auto scan = Scan::make(parts.database, table, keys, columns);
  if (!scan) return fail(scan.error());
  auto lookup = Lookup::make(parts.database);
  if (!lookup) return fail(lookup.error());
  to.push_back(std::make_unique<Check>(parts, std::move(*scan), std::move(*lookup)));
  return {};
}

}  // namespace

Result<void> add_map_checks(const Parts& parts, CheckParts& to) {
  Result<void> done = add<PlaceCheck>(parts, to, "place", {"experience", "place"}, "revision, row");
  if (done) {
    done = add<PlaceAnewCheck>(parts, to, "place_anew", {"experience", "place", "revision"}, "row");
  }
  if (done) {
    done =
        add<EdgeCheck>(parts, to, "edge", {"a_experience", "a_place", "b_experience", "b_place", "revision"}, "row");
  }
  if (done) done = add<LabelCheck>(parts, to, "label", {"label", "revision"}, "experience, place");
  if (done) {
    done = add<ApartCheck>(
        parts, to, "apart",
        {"one_experience", "one_first", "one_last", "other_experience", "other_first", "other_last", "revision"}, "");
  }
  if (done) done = add<RuleCheck>(parts, to, "rule", {"name", "revision"}, "row");
  if (done) done = add<RegistrationCheck>(parts, to, "registration", {"plan", "revision"}, "row");
  if (done) {
    done = add<MovedPlacesCheck>(parts, to, "moved_places", {"revision", "experience", "first_place", "is_back"},
                                 "last_place");
  }
  if (done) {
    done = add<MovedStitchCheck>(parts, to, "moved_stitch",
                                 {"revision", "a_experience", "a_place", "b_experience", "b_place", "is_back"}, "");
  }
  return done;
}

}  // namespace weft::storage::sqlite
