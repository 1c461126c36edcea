"""Weft is purged, and installed again: the map, backups and what robots have kept outlive it."""
import bench as shop

TITLE, SECONDS = 'a purge keeps the map, and who installs again has it', 240


def run(bench):
    server, robot, runs = bench.server, bench.robot, bench.runs()
    backups = server.run(f'ls {shop.BACKUPS}')
    said = server.run('DEBIAN_FRONTEND=noninteractive apt-get purge -y weft-server', 90)
    robot.run('DEBIAN_FRONTEND=noninteractive apt-get purge -y weft-agent', 90)
    broken = [] if '/var/lib/weft stays' in said else ['the purge does not say that the map stays']
    for machine, unit, stays, gone in ((server, shop.SERVER, [f'{shop.MAP}/map.sqlite'], ['/usr/bin/weft-server', shop.SETTINGS]),
                                       (robot, shop.AGENT, [f'{shop.STATE}/identity', shop.AGENT_SETTINGS], ['/usr/bin/weft-agent'])):
        broken += [f'{unit} still runs'] if machine.unit(unit)['ActiveState'] in ('active', 'activating') else []
        broken += [f'{path} is gone' for path in stays if machine.ask(f'test -e {path}')[0]]
        broken += [f'{path} is left' for path in gone if not machine.ask(f'test -e {path}')[0]]
        broken += [f'user weft is gone from {machine.name}'] if machine.ask('getent passwd weft')[0] else []
    server.run(f'{shop.SITE}/install server --listen {server.address} --packages {shop.DISK}/newer', 90)
    bench.wait_active(server, shop.SERVER)
    broken += [] if server.run(f'ls {shop.BACKUPS}') == backups else ['backups are gone']
    return broken + ([] if bench.runs() == runs else ['the map is another one'])
