"""Wrong settings: the program ends with a line that says what to do, and is not started again until they are right."""
import time

import bench as shop

TITLE, SECONDS = 'an unknown key stops a service once, and says which', 180
LOOKED_AT_S = 10


def run(bench):
    broken = []
    for machine, unit, file in ((bench.server, shop.SERVER, shop.SETTINGS), (bench.robot, shop.AGENT, shop.AGENT_SETTINGS)):
        machine.run(f'cp {file} /root/good.toml')
        before = machine.run(f'journalctl --no-pager -o cat -u {unit} | wc -l').strip()
        machine.run(f'(echo "domian = 3"; cat /root/good.toml) >{file}; systemctl restart {unit}', 60, good=None)
        known = bench.wait_failed(machine, unit)
        time.sleep(LOOKED_AT_S)
        said = machine.run(f'journalctl --no-pager -o cat -u {unit} | tail -n +{int(before) + 1}')
        told = [line for line in said.splitlines() if f'{file}:1: domian: unknown key' in line]
        broken += [] if known['ExecMainStatus'] == '2' else [f"{unit} ended with {known['ExecMainStatus']}"]
        broken += [] if len(told) == 1 and ' domain, ' in told[0] else [f'{unit} said {len(told)} times what is wrong: {said[-300:]}']
        broken += [] if machine.unit(unit)['ActiveState'] == 'failed' else [f'{unit} was started again']
        machine.run(f'cat /root/good.toml >{file}; systemctl restart {unit}', 60)
        bench.wait_active(machine, unit)
    bench.wait_heard()
    return broken
