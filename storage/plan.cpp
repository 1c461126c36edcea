#include "storage/plan.hpp"

#include <algorithm>

#include "core/network/called.hpp"
#include "core/network/codec.hpp"
#include "core/overloaded.hpp"

namespace weft::storage {
namespace {

std::string name_of(const Batch& batch) {
  return "batch " + std::to_string(batch.sequence) + " of experience " + called(batch);
}

class Planner {
 public:
  Planner(const Transaction& transaction, const Facts& facts)
      : transaction_(transaction), facts_(facts), contents_(facts.contents) {
    plan_.experiences = facts.experiences;
    for (const auto& change : transaction.changes) {
      events_ += std::holds_alternative<PutEvent>(change) ? 1 : 0;
      if (const auto* put = std::get_if<PutContent>(&change)) offered_.insert(put->hash);
    }
  }

  /// Returns whether the change is new.
  Result<bool> operator()(const PutContent& put) {
    if (contents_.contains(put.hash)) return false;
    if (hash_bytes(put.bytes) != put.hash) {
      return fail(ErrorCode::invalid, "content " + to_string(put.hash) + " (" + std::to_string(put.bytes.size()) +
                                          " bytes): its bytes have another SHA-256; ask the sender again");
    }
    contents_.insert(put.hash);
    return true;
  }

  Result<bool> operator()(const AppendBatch& append) {
    const Batch& batch = append.batch;
    ExperienceFacts& known = plan_.experiences[batch.experience];
    if (!batch.experience || batch.sequence == 0) {
      return fail(ErrorCode::invalid, name_of(batch) + ": sequences count from 1 and the experience has an id");
    }
    if (batch.sequence <= known.durable_through) return repeat(append);
    if (batch.sequence != known.durable_through + 1) {
      return fail(ErrorCode::conflict, name_of(batch) + ": batch " + std::to_string(known.durable_through + 1) +
                                           " must come first; send from there on");
    }
    if (auto fits = check_places(batch, known); !fits) return fail(fits.error());
    if (auto fits = check_known_anew(batch.learned); !fits) return fail(fits.error());
    for (const Edge& edge : batch.edges) offered_edges_.insert(edge.id);
    known.durable_through = batch.sequence;
    known.places += batch.places.size();
    batches_[{batch.experience, batch.sequence}] = append.hash;
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutPlaces& put) {
    if (auto fits = check_known_anew(put.places); !fits) return fail(fits.error());
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutLabel& put) {
    if (put.place.experience && !is_stored(put.place.experience, put.place.index)) {
      return fail(ErrorCode::conflict, "label " + put.label + ": place " + to_string(put.place) + " is not stored");
    }
    if (is_deleted({put.place.experience, put.place.index, put.place.index})) {
      return fail(ErrorCode::conflict,
                  "label " + put.label + ": place " + to_string(put.place) + " was deleted for good");
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutApart& put) {
    for (const Stretch& stretch : {put.apart.one, put.apart.other}) {
      if (auto fits = check_stored(stretch); !fits) return fail(fits.error());
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutRule& put) {
    const std::string name = "rule " + put.rule.name;
    if (put.rule.name.empty()) return fail(ErrorCode::invalid, "a rule without a name cannot be kept: give it one");
    for (const Span& span : put.holds ? put.rule.spans : std::vector<Span>()) {
      for (const PlaceId& end : {span.from, span.to}) {
        if (is_stored(end.experience, end.index)) continue;
        return fail(ErrorCode::conflict, name + ": place " + to_string(end) + " is not stored");
      }
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutRegistration& put) {
    const std::string name = "registration of plan " + put.registration.plan;
    if (put.registration.plan.empty()) {
      return fail(ErrorCode::invalid, "a registration of a plan without a name cannot be kept: give it one");
    }
    for (const Pick& pick : put.holds ? put.registration.picks : std::vector<Pick>()) {
      if (is_stored(pick.place.experience, pick.place.index)) continue;
      return fail(ErrorCode::conflict, name + ": place " + to_string(pick.place) + " is not stored");
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const TakeOut& out) { return moved(out.what); }
  Result<bool> operator()(const BringBack& back) { return moved(back.what); }

  Result<bool> operator()(const RollBack& back) {
    if (transaction_.changes.size() - events_ != 1) {
      return fail(ErrorCode::invalid, "rollback: it must be alone in its transaction");
    }
    if (back.to >= facts_.revision) {
      return fail(ErrorCode::conflict, "rollback: revision " + std::to_string(back.to.value) +
                                           " is not before the newest, " + std::to_string(facts_.revision.value));
    }
    if (auto kept = check_kept("rollback", back.to, facts_.floor); !kept) return fail(kept.error());
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const SealExperience& seal) {
    const auto found = plan_.experiences.find(seal.experience);
    if (found == plan_.experiences.end() || found->second.durable_through == 0) {
      return fail(ErrorCode::conflict, "seal: experience " + to_string(seal.experience) + " is not stored");
    }
    plan_.changes_network = true;
    return true;
  }

  Result<bool> operator()(const PutPreparation& put) {
    if (put.methods.empty() || put.bytes.size() > kLargestPreparation) {
      return fail(ErrorCode::invalid, "preparation for \"" + put.methods + "\": " + std::to_string(put.bytes.size()) +
                                          " bytes; it needs methods and at most " +
                                          std::to_string(kLargestPreparation) + " bytes");
    }
    return true;
  }

  Result<bool> operator()(const PutAwaitedLabel& put) {
    if (put.label.empty()) {
      return fail(ErrorCode::invalid,
                  "a label without a name cannot wait for place " + to_string(put.place) + ": give it one");
    }
    return true;
  }

  Result<bool> operator()(const PutPasses& put) {
    if (put.passes.empty() || put.passes.size() > kPassesKept) {
      return fail(ErrorCode::invalid, "passes of a piece of run " + to_string(put.piece.experience) + ": " +
                                          std::to_string(put.passes.size()) + "; from 1 to " +
                                          std::to_string(kPassesKept) + " are kept");
    }
    return true;
  }

  template <class Other>
  Result<bool> operator()(const Other&) {
    return true;
  }

  Plan take(std::vector<bool> fresh) {
    plan_.fresh = std::move(fresh);
    return std::move(plan_);
  }

 private:
  Result<bool> repeat(const AppendBatch& append) const {
    const BatchKey key{append.batch.experience, append.batch.sequence};
    const auto earlier = batches_.find(key);
    const auto stored = facts_.batches.find(key);
    const bool is_same = earlier != batches_.end()        ? earlier->second == append.hash
                         : stored != facts_.batches.end() ? stored->second == append.hash
                                                          : false;
    if (is_same) return false;
    return fail(
        ErrorCode::conflict,
        name_of(append.batch) + " is already stored with another hash; the robot must start a new experience");
  }

  bool is_stored(ExperienceId id, std::uint32_t index) const {
    const auto found = plan_.experiences.find(id);
    return found != plan_.experiences.end() && index < found->second.places;
  }

  /// Returns whether all of the stretch is deleted.
  bool is_deleted(const Stretch& stretch) const {
    const auto found = facts_.deleted.find(stretch.experience);
    return found != facts_.deleted.end() && std::ranges::any_of(found->second, [&](const Stretch& gone) {
             return gone.first <= stretch.first && stretch.last <= gone.last;
           });
  }

  Result<void> check_stored(const Stretch& stretch) const {
    if (stretch.first <= stretch.last && is_stored(stretch.experience, stretch.last)) return {};
    return fail(ErrorCode::conflict, "places " + std::to_string(stretch.first) + " to " +
                                         std::to_string(stretch.last) + " of experience " +
                                         to_string(stretch.experience) + " are not stored");
  }

  Result<bool> moved(const Removal& removal) {
    for (const Stretch& stretch : removal.places) {
      if (auto fits = check_stored(stretch); !fits) return fail(fits.error());
      if (is_deleted(stretch)) {
        return fail(ErrorCode::conflict, "places " + std::to_string(stretch.first) + " to " +
                                             std::to_string(stretch.last) + " of experience " +
                                             to_string(stretch.experience) + " were deleted for good");
      }
    }
    for (const EdgeId& stitch : removal.stitches) {
      if (facts_.stitches.contains(stitch) || offered_edges_.contains(stitch)) continue;
      return fail(ErrorCode::conflict,
                  "stitch " + to_string(stitch.a) + " - " + to_string(stitch.b) + " is not stored");
    }
    plan_.changes_network = true;
    return true;
  }

  Result<void> check_places(const Batch& batch, const ExperienceFacts& known) const {
    std::uint64_t next = known.places;
    for (const Place& place : batch.places) {
      if (place.id.experience != batch.experience) {
        return fail(ErrorCode::invalid,
                    name_of(batch) + ": place " + to_string(place.id) + " is of another experience");
      }
      if (place.id.index != next) {
        return fail(ErrorCode::conflict, name_of(batch) + ": place " + to_string(place.id) +
                                             " does not continue the experience; the next index is " +
                                             std::to_string(next));
      }
      if (auto there = check_content(place); !there) return there;
      ++next;
    }
    return {};
  }

  Result<void> check_known_anew(const std::vector<Place>& places) const {
    for (const Place& place : places) {
      const std::string name = "place " + to_string(place.id) + ", known anew";
      if (!is_stored(place.id.experience, place.id.index)) {
        return fail(ErrorCode::conflict, name + ": it is not stored");
      }
      if (is_deleted({place.id.experience, place.id.index, place.id.index})) {
        return fail(ErrorCode::conflict, name + ": it was deleted for good");
      }
      if (place.entity_version < 2) {
        return fail(ErrorCode::invalid, name + ": entity version " + std::to_string(place.entity_version) +
                                            "; it is at least the second");
      }
      if (auto there = check_content(place); !there) return there;
    }
    return {};
  }

  Result<void> check_content(const Place& place) const {
    if (contents_.contains(place.content.hash) || offered_.contains(place.content.hash)) return {};
    return fail(ErrorCode::conflict, "content " + to_string(place.content.hash) + " of place " + to_string(place.id) +
                                         " is neither stored nor in the transaction");
  }

  const Transaction& transaction_;
  const Facts& facts_;
  std::size_t events_ = 0;
  Plan plan_;
  std::set<ContentHash> contents_;
  std::set<ContentHash> offered_;
  std::map<BatchKey, ContentHash> batches_;
  std::set<EdgeId> offered_edges_;
};

}  // namespace

namespace {

void needs_of(const std::vector<Place>& known_anew, Needs& needs) {
  for (const Place& place : known_anew) {
    needs.experiences.insert(place.id.experience);
    needs.moved_in.insert(place.id.experience);
    needs.contents.insert(place.content.hash);
  }
}

void needs_of(const Removal& removal, Needs& needs) {
  for (const Stretch& stretch : removal.places) {
    needs.experiences.insert(stretch.experience);
    needs.moved_in.insert(stretch.experience);
  }
  needs.stitches.insert(removal.stitches.begin(), removal.stitches.end());
}

std::string count_of(const Removal& removal) {
  std::uint64_t places = 0;
  for (const Stretch& stretch : removal.places) places += stretch.last - stretch.first + 1;
  return std::to_string(places) + " places, " + std::to_string(removal.stitches.size()) + " stitches";
}

}  // namespace

Needs needs_of(const Transaction& transaction) {
  Needs needs;
  const Overloaded collect{
      [&](const PutContent& put) { needs.contents.insert(put.hash); },
      [&](const AppendBatch& append) {
        needs.experiences.insert(append.batch.experience);
        needs.batches.insert({append.batch.experience, append.batch.sequence});
        for (const Place& place : append.batch.places) needs.contents.insert(place.content.hash);
        needs_of(append.batch.learned, needs);
      },
      [&](const PutPlaces& put) { needs_of(put.places, needs); },
      [&](const PutLabel& put) {
        needs.experiences.insert(put.place.experience);
        needs.moved_in.insert(put.place.experience);
      },
      [&](const PutApart& put) {
        needs.experiences.insert({put.apart.one.experience, put.apart.other.experience});
      },
      [&](const PutRule& put) {
        for (const Span& span : put.rule.spans) needs.experiences.insert({span.from.experience, span.to.experience});
      },
      [&](const PutRegistration& put) {
        for (const Pick& pick : put.registration.picks) needs.experiences.insert(pick.place.experience);
      },
      [&](const SealExperience& seal) { needs.experiences.insert(seal.experience); },
      [&](const TakeOut& out) { needs_of(out.what, needs); },
      [&](const BringBack& back) { needs_of(back.what, needs); },
      [](const auto&) {},
  };
  for (const auto& change : transaction.changes) std::visit(collect, change);
  return needs;
}

Result<Plan> make_plan(const Transaction& transaction, const Facts& facts) {
  Planner planner(transaction, facts);
  std::vector<bool> fresh;
  for (const auto& change : transaction.changes) {
    const Result<bool> is_fresh = std::visit(planner, change);
    if (!is_fresh) return fail(is_fresh.error());
    fresh.push_back(*is_fresh);
  }
  return planner.take(std::move(fresh));
}

Result<void> check_kept(const std::string& what, Revision revision, Revision floor) {
  if (revision >= floor) return {};
  return fail(ErrorCode::not_found, what + ": revision " + std::to_string(revision.value) +
                                        " is older than what is kept (revision " + std::to_string(floor.value) +
                                        "); name that one or a later one, or restore an older snapshot");
}

Result<void> check_changes_kept(Revision revision, Revision floor) {
  if (revision > floor || floor.value == 0) return {};
  return fail(ErrorCode::not_found, "changes: revision " + std::to_string(revision.value) +
                                        " is the oldest that is kept; what it changed is not known any more");
}

RevisionNote note_of(const Transaction& transaction, Revision newest) {
  RevisionNote note = transaction.note;
  note.revision = {newest.value + 1};
  note.base = newest;
  for (const auto& change : transaction.changes) {
    if (const auto* back = std::get_if<RollBack>(&change)) note.base = back->to;
  }
  if (!note.kind.empty()) return note;
  const auto add = [&](const char* kind, const std::string& cause) {
    note.kind = kind;
    note.cause += (note.cause.empty() ? "" : "; ") + cause;
  };
  const Overloaded explain{
      [&](const AppendBatch& append) {
        const Batch& batch = append.batch;
        const auto stitches = std::ranges::count(batch.edges, Origin::stitch, &Edge::origin);
        const bool only_learned = batch.places.empty() && !batch.learned.empty();
        add(only_learned ? "learned" : "batch",
            name_of(batch) + ": " +
                (only_learned ? ""
                              : std::to_string(batch.places.size()) + " places, " + std::to_string(stitches) +
                                    " stitches" + (batch.learned.empty() ? "" : ", ")) +
                (batch.learned.empty() ? "" : std::to_string(batch.learned.size()) + " places known better"));
        if (note.who.empty()) note.who = to_string(batch.robot);
      },
      [&](const PutPlaces& put) { add("places", std::to_string(put.places.size()) + " places known anew"); },
      [&](const PutLabel& put) {
        add("label", put.label + (put.place.experience ? " is " + to_string(put.place) : " goes"));
      },
      [&](const PutApart& put) { add("apart", to_string(put.apart) + (put.holds ? "" : " are so no longer")); },
      [&](const PutRule& put) { add("rule", put.rule.name + (put.holds ? ": " + to_string(put.rule) : " goes")); },
      [&](const PutRegistration& put) {
        const Registration& registration = put.registration;
        add("register", put.holds ? to_string(registration) : "plan " + registration.plan + " goes");
      },
      [&](const SealExperience& seal) { add("seal", to_string(seal.experience) + ": " + seal.reason); },
      [&](const TakeOut& out) { add("out", count_of(out.what)); },
      [&](const BringBack& back) { add("back", count_of(back.what)); },
      [&](const RollBack& back) { add("rollback", "to revision " + std::to_string(back.to.value)); },
      [](const auto&) {},
  };
  for (const auto& change : transaction.changes) std::visit(explain, change);
  return note;
}

}  // namespace weft::storage
