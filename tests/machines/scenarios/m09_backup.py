"""The night comes: the timer has a snapshot made, verified, and kept."""
from playing.processes import wait_until

import bench as shop

TITLE, SECONDS = 'the timer makes a verified backup at night', 180


def run(bench):
    server = bench.server
    timer = server.unit('weft-backup.timer')
    broken = [] if (timer['ActiveState'], timer['UnitFileState']) == ('active', 'enabled') else [f'the timer is {timer}']
    backups = f"ls {shop.BACKUPS}"
    if server.run(backups).split():
        broken.append('there is a backup before the first night')
    server.run('date -s "tomorrow 02:26"')          # 02:15, and up to ten minutes by chance
    wait_until('the backup', lambda: '.sqlite' in server.run(backups) and server.unit(shop.BACKUP)['ActiveState'] == 'inactive', 60, every=1)
    made, known = server.run(backups).split(), server.unit(shop.BACKUP)
    broken += [] if len(made) == 1 and made[0].endswith('.sqlite') else [f'the backups are {made}']
    broken += [] if known['Result'] == 'success' else [f"{shop.BACKUP}: {known['Result']}: {server.journal(shop.BACKUP, 5)}"]
    return broken
