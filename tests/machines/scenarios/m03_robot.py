"""A robot is installed. What drives it is not there yet: the agent says so, and is not started again and again."""
import time

import bench as shop

TITLE, SECONDS = 'a robot is installed, and is not restarted before its settings are whole', 150
FPS, WATCHDOG_S = 8, 30                # of 30 and 10: an emulated machine renders an image or two a second, its first one in more than 10 s


def run(bench):
    robot = bench.robot
    robot.run(f'tar xf {shop.DISK}/site.tar -C /root')
    robot.run(f'apt-get install -y --no-install-recommends {shop.SITE}/packages/weft-agent-sim_*.deb', 90)
    robot.run(f'{shop.SITE}/install robot --name r1 --server {bench.server.address} --listen eth0 --body sim', 90)
    failed = bench.wait_failed(robot, shop.AGENT)
    time.sleep(3)
    broken = [] if robot.unit(shop.AGENT)['NRestarts'] == '0' else ['an agent with incomplete settings was started again']
    broken += [] if failed['ExecMainStatus'] == '2' else [f"it ended with {failed['ExecMainStatus']}: {robot.journal(shop.AGENT, 3)}"]
    broken += [] if 'start weft-agent-sim' in robot.journal(shop.AGENT) else [f'it does not say what to do: {robot.journal(shop.AGENT, 3)}']
    robot.run(f'(cat /usr/share/weft/sites/demo.toml; echo "[camera]"; echo "fps = {FPS}"; echo "fps_at_rest = 1") >/etc/weft/site.toml')
    robot.write(shop.AGENT_SETTINGS, f'site = "/etc/weft/site.toml"\nrecords = "{shop.STATE}/records"\n')
    robot.write('/etc/systemd/system/weft-agent@.service.d/simulated.conf', f'[Service]\nWatchdogSec={WATCHDOG_S}\nExecStart=\n'
                'ExecStart=/usr/bin/weft-agent-sim --config '
                '/etc/weft/agents/%i.toml --state /var/lib/weft/agents/%i\n')
    robot.run(f'install -d -o weft -g weft {shop.STATE}/records; systemctl daemon-reload; systemctl restart {shop.AGENT}', 60)
    bench.wait_active(robot, shop.AGENT)
    bench.wait_heard()
    return broken
