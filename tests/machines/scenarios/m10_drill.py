"""The restore drill of docs/operating.md, word for word: what was done since the backup is gone, the map is that of before."""
import json

import bench as shop

TITLE, SECONDS = 'the restore drill', 180


def run(bench):
    server, before = bench.server, bench.runs()
    bench.weft('map', 'unlabel', 'end')
    newest = server.run(f'ls {shop.BACKUPS}/map-*.sqlite | tail -n 1').strip()
    server.run('systemctl stop weft-server', 60)
    said = server.run(f'runuser -u weft -- weft map restore {newest} --store {shop.MAP} --json', 60)
    server.run('systemctl start weft-server', 60)
    bench.wait_active(server, shop.SERVER)
    bench.wait_heard()
    bench.weft('map', 'check', seconds=120)
    after = bench.runs()
    broken = [] if after == before else [f'before the drill {before}, after it {after}']
    kept = json.loads(said)['kept_aside']
    return broken + ([f'{kept}, the map of before the drill, is not there'] if server.ask(f'test -s {kept}')[0] else [])
