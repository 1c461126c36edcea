#include "server/editor/edits.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "core/network/imported.hpp"
#include "core/network/registrations.hpp"
#include "core/network/rules.hpp"

namespace weft::server {
namespace {

std::string counted(std::uint64_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string counted(const Removal& removal) {
  std::string text;
  if (!removal.places.empty()) text = counted(place_count(removal), "place");
  if (removal.stitches.empty()) return text;
  return text + (text.empty() ? "" : " and ") +
         (removal.stitches.size() == 1 ? "1 stitch" : std::to_string(removal.stitches.size()) + " stitches");
}

std::string named(Revision revision) {
  return "revision " + std::to_string(revision.value);
}

void append(Removal& all, const Removal& more) {
  all.places.insert(all.places.end(), more.places.begin(), more.places.end());
  all.stitches.insert(all.stitches.end(), more.stitches.begin(), more.stitches.end());
}

Stretch whole(ExperienceId experience) {
  return {experience, 0, std::numeric_limits<std::uint32_t>::max()};
}

std::string cause_of(const msg::OperatorRequest& request, const Removal& asked) {
  if (!request.label.empty()) return "experience " + request.label;
  std::string text;
  for (const Stretch& stretch : asked.places) {
    text += (text.empty() ? "" : ", ") + to_string(stretch.experience) + ":" + std::to_string(stretch.first) +
            " to " + std::to_string(stretch.last);
  }
  for (const EdgeId& stitch : asked.stitches) {
    text += (text.empty() ? "" : ", ") + to_string(stitch.a) + " - " + to_string(stitch.b);
  }
  return text;
}

PlaceId place_of(const std::string& label, const Snapshot& snapshot) {
  const auto found = snapshot.labels().find(label);
  return found == snapshot.labels().end() ? PlaceId{} : found->second;
}

/// Turns round what the revision set the label to, if it still means that.
void undo_label(const std::string& label, const Snapshot& now, const Snapshot& then, const Snapshot& before,
                Edit& edit) {
  const PlaceId is = place_of(label, now);
  const PlaceId was = place_of(label, before);
  if (place_of(label, then) == is && was != is) edit.labels[label] = was;
}

/// Turns round what the revision vouched for, or did no longer, if that is still so.
void undo_apart(const Apart& apart, const Snapshot& now, const Snapshot& then, const Snapshot& before, Edit& edit) {
  const auto holds = [&](const Snapshot& at) { return std::ranges::binary_search(at.aparts(), apart); };
  if (holds(then) == holds(now) && holds(before) != holds(now)) edit.aparts[apart] = holds(before);
}

std::optional<Rule> rule_of(const std::string& name, const Snapshot& snapshot) {
  const auto found = snapshot.rules().find(name);
  return found == snapshot.rules().end() ? std::nullopt : std::optional(found->second);
}

/// Turns round what the revision made of the rule, if it is still so.
void undo_rule(const std::string& name, const Snapshot& now, const Snapshot& then, const Snapshot& before,
               Edit& edit) {
  const std::optional<Rule> is = rule_of(name, now);
  const std::optional<Rule> was = rule_of(name, before);
  if (rule_of(name, then) == is && was != is) edit.rules[name] = was;
}

std::optional<Registration> registration_of(const std::string& plan, const Snapshot& snapshot) {
  const auto found = snapshot.registrations().find(plan);
  return found == snapshot.registrations().end() ? std::nullopt : std::optional(found->second);
}

/// Turns round what the revision made of the registration, if it is still so.
void undo_registration(const std::string& plan, const Snapshot& now, const Snapshot& then, const Snapshot& before,
                       Edit& edit) {
  const std::optional<Registration> is = registration_of(plan, now);
  const std::optional<Registration> was = registration_of(plan, before);
  if (registration_of(plan, then) == is && was != is) edit.registrations[plan] = was;
}

/// Refuses changes of what has names that would leave the map more of it than it may have. `remedy`: the command that
/// removes one.
template <class Named>
Result<void> check_count(const std::map<std::string, Named>& known,
                         const std::map<std::string, std::optional<Named>>& changes, std::size_t most,
                         const std::string& what, const std::string& remedy) {
  std::size_t came = 0;
  std::size_t went = 0;
  for (const auto& [name, value] : changes) {
    if (value && !known.contains(name)) ++came;
    if (!value && known.contains(name)) ++went;
  }
  const std::size_t count = known.size() + came - went;
  if (came <= went || count <= most) return {};
  return fail(ErrorCode::refused, "the map would have " + std::to_string(count) + " " + what + ", at most " +
                                      std::to_string(most) + ": remove one (" + remedy + "), then undo again");
}

/// Refuses an edit that would leave the map more rules or registered plans than it may have.
Result<void> check_counts(const Snapshot& snapshot, const Edit& edit) {
  const Result<void> rules = check_count(snapshot.rules(), edit.rules, kMostRules, "rules", "weft rule remove NAME");
  if (!rules) return rules;
  return check_count(snapshot.registrations(), edit.registrations, kMostRegistrations, "registered plans",
                     "weft map register PLAN --remove");
}

std::string known_plans(const Snapshot& snapshot) {
  std::string text;
  for (const auto& [plan, registration] : snapshot.registrations()) text += (text.empty() ? "" : ", ") + plan;
  return text.empty() ? "it has none" : "known: " + text;
}

std::string known_rules(const Snapshot& snapshot) {
  constexpr std::size_t kListed = 10;
  if (snapshot.rules().empty()) return "it has none";
  std::string text = "known:";
  std::size_t listed = 0;
  for (const auto& [name, rule] : snapshot.rules()) {
    if (++listed > kListed) return text + " ... (weft rule list)";
    text += " " + name;
  }
  return text;
}

/// Names the rule that holds robots on the places of another one.
std::string hold_name(const std::string& name) {
  return "hold-" + name;
}

/// Turns round what the revision made of places, as far as they are still known so.
void undo_known_anew(const std::vector<Place>& learned, const Snapshot& now, const Snapshot& before, Edit& edit) {
  for (const Place& place : learned) {
    const Place* const is = now.place(place.id);
    const Place* const was = before.place(place.id);
    if (is == nullptr || was == nullptr || *is != place) continue;
    edit.known_anew.push_back(*was);
    edit.known_anew.back().entity_version = is->entity_version + 1;  // what is learned meanwhile comes too late
  }
}

tl::unexpected<Error> several(const std::string& name, const std::vector<ExperienceId>& found) {
  std::string ids;
  for (const ExperienceId id : found) ids += (ids.empty() ? "" : ", ") + to_string(id);
  return fail(ErrorCode::refused, std::to_string(found.size()) + " experiences are named " + name +
                                      ", or have ids that begin so: give one of " + ids);
}

}  // namespace

std::string to_text(const Edit& edit) {
  if (edit.to.value != 0) return "the map is as it was at " + named(edit.to);
  std::vector<std::string> parts;
  if (!edit.out.empty()) parts.push_back(counted(edit.out) + " out of the map");
  if (!edit.back.empty()) parts.push_back(counted(edit.back) + " in the map again");
  if (!edit.known_anew.empty()) parts.push_back(counted(edit.known_anew.size(), "place") + " known as before");
  for (const auto& [label, place] : edit.labels) {
    parts.push_back("label " + label + (place.experience ? " at " + to_string(place) : " gone"));
  }
  for (const auto& [apart, holds] : edit.aparts) {
    parts.push_back(to_string(apart.one) + " and " + to_string(apart.other) +
                    (holds ? " are different floors" : " are different floors no longer"));
  }
  for (const auto& [name, rule] : edit.rules) {
    parts.push_back("rule " + name + (rule ? " (" + to_string(*rule) + ")" : " gone"));
  }
  for (const auto& [plan, registration] : edit.registrations) {
    parts.push_back(registration ? to_string(*registration) : "plan " + plan + " registered no longer");
  }
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

Result<std::vector<ExperienceId>> experiences_of(const Snapshot& snapshot, const std::string& name) {
  constexpr std::size_t kFewestDigits = 4;
  std::vector<ExperienceId> named;
  std::vector<ExperienceId> begin_so;
  for (const auto& [id, experience] : snapshot.experiences()) {
    if (experience->name == name) named.push_back(id);
    if (name.size() >= kFewestDigits && to_string(id).starts_with(name)) begin_so.push_back(id);
  }
  if (named.empty()) named = std::move(begin_so);
  if (named.empty()) {
    return fail(ErrorCode::not_found, "the map has no experience " + name +
                                          "; give its name, or the beginning of its id: weft map list has both");
  }
  // An import makes all of its runs under one name, and in the name of one robot that is in no fleet.
  const RobotId robot = snapshot.experience(named.front())->robot;
  const bool is_import = std::all_of(named.begin(), named.end(), [&](const ExperienceId& id) {
    const Experience& experience = *snapshot.experience(id);
    return experience.robot == robot && experience.method == kImportedMethod;
  });
  if (named.size() == 1 || is_import) return named;
  return several(name, named);
}

Result<ExperienceId> experience_of(const Snapshot& snapshot, const std::string& name) {
  const Result<std::vector<ExperienceId>> found = experiences_of(snapshot, name);
  if (!found) return fail(found.error());
  if (found->size() > 1) return several(name, *found);
  return found->front();
}

Result<Edit> taking_out(const Snapshot& snapshot, const msg::OperatorRequest& request) {
  Removal asked = request.work.what;
  if (!request.label.empty()) {
    const Result<std::vector<ExperienceId>> experiences = experiences_of(snapshot, request.label);
    if (!experiences) return fail(experiences.error());
    for (const ExperienceId experience : *experiences) asked.places.push_back(whole(experience));
  }
  if (asked.empty()) return fail(ErrorCode::invalid, "nothing is named that could leave the map");
  Edit edit;
  edit.cause = cause_of(request, asked);
  edit.out = present(snapshot, asked);
  if (edit.out.empty()) {
    return fail(ErrorCode::not_found, "nothing of " + edit.cause + " is in the map; weft map log shows when it left");
  }
  return edit;
}

Result<Edit> setting_apart(const Snapshot& snapshot, const msg::OperatorRequest& request) {
  const Removal& asked = request.work.what;
  if (asked.places.size() != 2 || !asked.stitches.empty() || !request.label.empty()) {
    return fail(ErrorCode::invalid, "two stretches of places are needed to be apart, " +
                                        std::to_string(asked.places.size()) + " were named");
  }
  const Apart apart{asked.places.front(), asked.places.back()};
  if (auto fits = check(snapshot, apart); !fits) return fail(fits.error());
  Edit edit;
  edit.aparts[ordered(apart)] = true;
  edit.cause = "vouched for";
  return edit;
}

Result<Edit> removing_label(const Snapshot& snapshot, const std::string& label) {
  if (!place_of(label, snapshot).experience) return fail(ErrorCode::not_found, "the map has no label " + label);
  Edit edit;
  edit.labels[label] = {};
  edit.cause = "label " + label + " removed";
  return edit;
}

Result<Edit> renaming_label(const Snapshot& snapshot, const std::string& label, const std::string& new_label) {
  if (const Result<void> good = check_name("label", new_label); !good) return fail(good.error());
  const PlaceId place = place_of(label, snapshot);
  if (!place.experience) return fail(ErrorCode::not_found, "the map has no label " + label);
  if (const PlaceId other = place_of(new_label, snapshot); other.experience) {
    return fail(ErrorCode::conflict, "label " + new_label + " is there already, at " + to_string(other) +
                                         ": remove it first (weft map unlabel " + new_label + ")");
  }
  Edit edit;
  edit.labels[label] = {};
  edit.labels[new_label] = place;
  edit.cause = "label " + label + " renamed";
  return edit;
}

Result<Edit> putting_rule(const Snapshot& snapshot, const Rule& rule) {
  if (const Result<void> good = check(snapshot, rule); !good) return fail(good.error());
  if (rule_of(rule.name, snapshot) == rule) {
    return fail(ErrorCode::conflict, "rule " + rule.name + " is so already: weft rule list shows all");
  }
  Edit edit;
  edit.rules[rule.name] = rule;
  edit.cause = "rule " + rule.name + " laid down";
  return edit;
}

Result<Edit> removing_rule(const Snapshot& snapshot, const std::string& name) {
  if (!rule_of(name, snapshot)) {
    return fail(ErrorCode::not_found, "the map has no rule " + name + "; " + known_rules(snapshot));
  }
  Edit edit;
  edit.rules[name] = std::nullopt;
  edit.cause = "rule " + name + " removed";
  return edit;
}

Result<Edit> holding_places_of(const Snapshot& snapshot, const std::string& name) {
  std::optional<Rule> rule = rule_of(name, snapshot);
  if (!rule) {
    return fail(ErrorCode::not_found, "there is no robot and no rule " + name + "; rules: " + known_rules(snapshot));
  }
  rule->name = hold_name(name);
  rule->kind = RuleKind::hold;
  rule->value = 0.0;
  rule->one_direction = false;
  return putting_rule(snapshot, *rule);
}

Result<Edit> freeing_places_of(const Snapshot& snapshot, const std::string& name) {
  if (rule_of(hold_name(name), snapshot)) return removing_rule(snapshot, hold_name(name));
  const std::optional<Rule> rule = rule_of(name, snapshot);
  if (rule && rule->kind == RuleKind::hold) return removing_rule(snapshot, name);
  return fail(ErrorCode::not_found, "nobody holds " + name + ": weft rule list shows what is held, weft robots who");
}

Result<Edit> putting_registration(const Snapshot& snapshot, const Registration& registration) {
  if (const Result<void> good = check(snapshot, registration); !good) return fail(good.error());
  if (registration_of(registration.plan, snapshot) == registration) {
    return fail(ErrorCode::conflict,
                "plan " + registration.plan + " is registered so already: weft map register --show shows it");
  }
  Edit edit;
  edit.registrations[registration.plan] = registration;
  edit.cause = "plan " + registration.plan + " registered";
  return edit;
}

Result<Edit> removing_registration(const Snapshot& snapshot, const std::string& plan) {
  const Snapshot::Registrations& known = snapshot.registrations();
  if (plan.empty() && known.size() > 1) {
    return fail(ErrorCode::refused, "several plans are registered: name the one to remove; " + known_plans(snapshot));
  }
  const std::string name = plan.empty() && known.size() == 1 ? known.begin()->first : plan;
  if (!known.contains(name)) {
    return fail(ErrorCode::not_found,
                "the map has no registered plan" + (name.empty() ? "" : " " + name) + "; " + known_plans(snapshot));
  }
  Edit edit;
  edit.registrations[name] = std::nullopt;
  edit.cause = "plan " + name + " removed";
  return edit;
}

Result<Edit> undoing(const Snapshot& snapshot, const storage::MapStore& store, Revision revision) {
  const Result<storage::RevisionChanges> changes = store.changes_of(revision);
  if (!changes) return fail(changes.error());
  const bool was_rollback = changes->note.base.value + 1 != revision.value;
  if (was_rollback && revision != snapshot.revision()) {
    return fail(ErrorCode::refused, named(revision) + " is a rollback, and more has come since: weft map rollback " +
                                        std::to_string(revision.value - 1) + " goes back to before it");
  }
  if (was_rollback) {
    Result<Edit> edit = rolling_back(snapshot, store, {revision.value - 1});
    if (edit) edit->cause = named(revision) + ", a rollback";
    return edit;
  }
  Edit edit;
  edit.cause = named(revision) + " (" + changes->note.kind + ": " + changes->note.cause + ")";
  Removal out = changes->added;
  append(out, changes->brought_back);
  edit.out = present(snapshot, out);
  edit.back = absent(snapshot, changes->taken_out);
  const bool needs_maps = !changes->labels.empty() || !changes->aparts.empty() || !changes->rules.empty() ||
                          !changes->registrations.empty() || !changes->known_anew.empty();
  if (needs_maps) {
    const Result<Snapshot> then = store.snapshot_at(revision, snapshot);
    if (!then) return fail(then.error());
    const Result<Snapshot> before = store.snapshot_at(changes->note.base, *then);
    if (!before) return fail(before.error());
    undo_known_anew(changes->known_anew, snapshot, *before, edit);
    for (const std::string& label : changes->labels) undo_label(label, snapshot, *then, *before, edit);
    for (const Apart& apart : changes->aparts) undo_apart(apart, snapshot, *then, *before, edit);
    for (const std::string& name : changes->rules) undo_rule(name, snapshot, *then, *before, edit);
    for (const std::string& plan : changes->registrations) undo_registration(plan, snapshot, *then, *before, edit);
  }
  if (edit.empty()) {
    return fail(ErrorCode::not_found, "nothing of " + edit.cause +
                                          " is left to undo: it has been undone, or later "
                                          "revisions changed the same; weft map log shows them");
  }
  if (const Result<void> fits = check_counts(snapshot, edit); !fits) return fail(fits.error());
  return edit;
}

Result<Edit> rolling_back(const Snapshot& snapshot, const storage::MapStore& store, Revision to) {
  if (to >= snapshot.revision()) {
    return fail(ErrorCode::refused, named(to) + " is not before the newest, " +
                                        std::to_string(snapshot.revision().value) + ": weft map log lists them");
  }
  const Result<std::vector<storage::RevisionNote>> known = store.log(to, 1);
  if (!known) return fail(known.error());
  if (known->empty() || known->front().revision != to) {
    return fail(ErrorCode::not_found, "the map has no " + named(to) + " any more: weft map log lists what is kept");
  }
  Edit edit;
  edit.to = to;
  edit.cause = "to " + named(to);
  return edit;
}

}  // namespace weft::server
