"""Both machines are shut down and started: everything comes up by itself."""
import bench as shop

TITLE, SECONDS = 'machines that were shut down come up as they were', 180


def run(bench):
    runs, robot = bench.runs(), bench.row()['id']
    for machine in (bench.robot, bench.server):
        machine.shut_down()
    bench.boot()
    bench.wait_active(bench.server, shop.SERVER)
    bench.wait_active(bench.robot, shop.AGENT)
    broken = [] if bench.wait_heard()['id'] == robot else ['the robot came back as another one']
    return broken + ([] if bench.runs() == runs else ['the map is another one'])
