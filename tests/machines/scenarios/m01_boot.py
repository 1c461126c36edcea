"""Two fresh machines start, and see each other."""
TITLE, SECONDS = 'two fresh machines start', 120


def run(bench):
    bench.boot()
    for machine in (bench.server, bench.robot):
        if machine.run('dpkg-query -W weft-server weft-agent', good=None).count('no packages found') != 2:
            return [f'{machine.name} is not fresh: it has packages of ours']
    said = bench.robot.run(f'timeout 20 bash -c "exec 3<>/dev/tcp/{bench.server.address}/1"', good=None)
    return [] if 'refused' in said else [f'the robot does not reach the server: {said}']
