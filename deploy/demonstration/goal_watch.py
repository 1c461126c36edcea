"""Many goals at once, as an operator follows them: each change is said once, and each goal that is under way is asked
again and again why it is not there yet."""
import json
import time

from scenario import OVER, goal_words, send

LOOK_S, ASK_S = 1.0, 6.0


def words(answer):
    """The first wait of a chain, in words; empty when nobody waits or when the answer cannot be read."""
    try:
        waits = json.loads(answer)['waits']
    except (ValueError, KeyError, TypeError):
        return ''
    if not waits:
        return ''
    causes = waits[0]['held_by'] + ([f"rule {waits[0]['rule']}"] if waits[0]['rule'] else [])
    return f"{waits[0]['robot']} waits for {' and '.join(causes) or 'it is not said what'}"


class GoalWatch:
    def __init__(self, fleet, say):
        self.fleet, self.say = fleet, say
        self.rows, self.sent, self.told, self.asked_at = {}, [], {}, 0.0
        self.whys = []       # goal, answer: what `weft goal why ID --json` printed

    def send(self, label, robot):
        self.sent.append(send(self.fleet, label, robot, self.say))
        return self.sent[-1]

    def have_ended(self, goals):
        return all(goal in self.rows and self.rows[goal]['state'] in OVER for goal in goals)

    def tell(self, key, text):
        if self.told.get(key) != text:
            self.told[key] = text
            self.say(text)

    def look(self):
        self.rows = {row['id']: row for row in self.fleet.weft('goal', 'list')['goals']}
        for goal, row in self.rows.items():
            self.tell(goal, goal_words(row))
        if time.monotonic() - self.asked_at >= ASK_S:
            self.asked_at = time.monotonic()
            for goal in self.sent:
                if not self.have_ended([goal]):
                    self.ask(goal)

    def ask(self, goal):
        """The answer is kept as it came: whether it can be read is for the judge."""
        answer = self.fleet.answer('goal', 'why', goal)
        self.whys.append(dict(goal=goal, answer=answer))
        wait = words(answer)
        if wait:
            self.tell(('wait', self.rows[goal]['to'], goal), f"goal {self.rows[goal]['to']}: {wait}")

    def explain(self):
        """Says of each goal that has not ended what `weft goal why` says of it, and keeps it."""
        for goal in self.sent:
            if not self.have_ended([goal]):
                self.ask(goal)
                document = json.loads(self.whys[-1]['answer'])
                self.say(f"goal {self.rows[goal]['to']} has not ended: {document['goal']['history'][-1]['cause'] or document['goal']['state']}")

    def until(self, what, condition, seconds):
        """Whether it came to that in time; a process that died is an error."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            began = time.monotonic()
            self.look()
            if condition():
                return True
            for process in self.fleet.all():
                if not process.running():
                    raise RuntimeError(f'{process.name} has ended: {process.last_words()}')
            time.sleep(max(0.0, LOOK_S - (time.monotonic() - began)))
        self.say(f'{seconds:.0f} s have not been enough for {what}')
        return False
