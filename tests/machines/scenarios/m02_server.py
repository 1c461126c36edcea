"""A server is installed from the archive for sites without a network."""
import bench as shop

TITLE, SECONDS = 'a server is installed, and is as its flags say', 120


def run(bench):
    server = bench.server
    server.run(f'tar xf {shop.DISK}/site.tar -C /root')
    server.run(f'{shop.SITE}/install server --listen {server.address}', 90)
    known = bench.wait_active(server, shop.SERVER)
    broken = [] if known['UnitFileState'] == 'enabled' else [f'{shop.SERVER} is {known["UnitFileState"]}']
    code, said = server.ask(f'{shop.SITE}/install server --listen {server.address} --check', 60)
    broken += [f'install --check: exit {code}: {said.strip()}'] if code else []
    for path, owner in ((shop.MAP, 'weft:weft'), (shop.BACKUPS, 'weft:weft:750'), ('/var/lib/weft', 'weft:weft:750')):
        found = server.run(f'stat -c %U:%G:%a {path}').strip()
        broken += [] if found.startswith(owner) else [f'{path} is {found}']
    info = bench.weft('map', 'info')
    return broken + ([] if info['places'] == 0 else [f"a new map has {info['places']} places"])
