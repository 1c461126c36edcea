"""The server is killed when it has accepted a goal and its answer is under way, after an answer, and in the middle of a route."""
import lab

TITLE, SECONDS = 'the server is killed -9 three times', 80
LATE_MS = 1000


def killed(fleet, epoch, when, before_start=lambda: None):
    """Kills the server and starts it anew: its epoch is one more, and is returned."""
    fleet.kill_server()
    before_start()
    fleet.restart_server()
    now = fleet.weft('map', 'info')['epoch']
    if now != epoch + 1:
        raise lab.Trouble(f'killed {when}: the epoch was {epoch} and is {now}')
    return now


def run(bench):
    fleet = bench.taught()
    epoch, known = fleet.weft('map', 'info')['epoch'], set(fleet.goals())

    # What the operator's command hears comes late, and the answer never: a robot has its order by then. The command asks again.
    late = lab.Loss(fleet.operator, delay_ms=LATE_MS)
    command = fleet.begin('goal', 'send', '--to', 'station-1')
    lab.wait_until('a robot to have an order of which nobody was told', lambda: bench.records.update().ordered() - known, 60, every=0.02)
    epoch = killed(fleet, epoch, 'before the answer', late.drop)
    goal = fleet.finish(command)['goal']
    made = [row['id'] for row in fleet.goals().values() if row['id'] not in known and row['to'] == 'station-1']
    if made != [goal]:
        raise lab.Trouble(f'one request made {len(made)} goals, and told of {goal}')

    second = fleet.send(4)                               # after the answer, before a robot has it or shortly after
    epoch = killed(fleet, epoch, 'after the answer')
    third = fleet.send(6)
    fleet.wait_under_way(third)
    killed(fleet, epoch, 'in mid-route')
    fleet.succeed([goal, second, third], 60)
