"""The server is killed before it answers a request, after it has accepted a goal, and in the middle of a route."""
import lab

TITLE, SECONDS = 'the server is killed -9 three times', 60


def epoch(fleet):
    return fleet.weft('map', 'info')['epoch']


def killed_again(fleet, before, when):
    now = epoch(fleet)
    if now != before + 1:
        raise lab.Trouble(f'killed {when}: the epoch was {before} and is {now}')
    return now


def run(bench):
    fleet = bench.taught()
    number, known = epoch(fleet), set(fleet.goals())

    # Before the answer: the command repeats its request until it has one.
    fleet.kill_server()
    command = fleet.begin('goal', 'send', '--to', 'station-1')
    fleet.restart_server()
    goal = fleet.finish(command)['goal']
    made = [row['id'] for row in fleet.goals().values() if row['id'] not in known and row['to'] == 'station-1']
    if made != [goal]:
        raise lab.Trouble(f'one request made {len(made)} goals, and told of {goal}')
    number = killed_again(fleet, number, 'before the answer')

    # After the answer, before a robot has it or shortly after.
    second = fleet.send(4)
    fleet.kill_server()
    fleet.restart_server()
    number = killed_again(fleet, number, 'after the answer')

    third = fleet.send(6)
    fleet.wait_under_way(third)
    fleet.kill_server()
    fleet.restart_server()
    killed_again(fleet, number, 'in mid-route')
    fleet.succeed([goal, second, third], 60)
