"""Both programs are killed."""
import bench as shop

TITLE, SECONDS = 'programs that are killed come back, the same robot to the same map', 120


def run(bench):
    runs, robot = bench.runs(), bench.row()['id']
    for machine, unit in ((bench.server, shop.SERVER), (bench.robot, shop.AGENT)):
        before = machine.unit(unit)['MainPID']
        machine.run(f'kill -KILL {before}')
        bench.wait_active(machine, unit, other_than=before)
    broken = [] if bench.wait_heard()['id'] == robot else ['the robot came back as another one']
    return broken + ([] if bench.runs() == runs else ['the map is another one'])
