#!/usr/bin/python3
"""Processes that stand still for longer than the others remember them, as when a virtual machine is moved or a container is
paused: server and agents of both vendors hear one another again by themselves, and a server that stood still calls nobody
silent for it."""
import json
import pathlib
import signal
import tempfile
import time

from command import BIN, ROOT, STAND_STILL_DOMAINS, Fleet, Running, main, simulated_agent

FROZEN_S = 9   # participants are forgotten after 5
SILENT_S = 8   # a robot counts as silent then: less than that, and enough for a busy machine to find itself again
AGAIN_S = 30
VENDORS = ('fastdds', 'cyclonedds')


class Shop:
    """One server, and an agent of each vendor."""

    def __init__(self, folder, vendor, domain):
        self.vendor, self.domain = vendor, domain
        where = ['--domain', domain, '--dds']
        self.server = Running(folder / f'{vendor}.log', BIN / 'weft-server', '--store', folder / f'{vendor}-map',
                              '--robot-silent-after-s', SILENT_S, *where, vendor)
        self.agents = [Running(folder / f'{vendor}-{name}.log', *simulated_agent(
                           name, folder / f'{vendor}-{name}', ROOT / 'deploy/sites/demo.toml', *where, dds))
                       for name, dds in zip(('r1', 'r2'), VENDORS)]

    def all(self):
        return [self.server, *self.agents]


class StandStill(Fleet):
    def silent(self, shop):
        """For how long each robot has not been heard, as the server says."""
        self.domain, self.vendor = shop.domain, shop.vendor
        return {row['name']: row['silent_s'] for row in json.loads(self.weft('robots', '--json'))['robots']}

    def heard(self, shop, since):
        """Both robots have been heard after that moment."""
        end = time.monotonic() + AGAIN_S
        while True:
            asked = time.monotonic()
            silent = self.silent(shop)
            if len(silent) == 2 and all(seconds < asked - since for seconds in silent.values()):
                return
            said = ''.join(one.text()[-1500:] for one in shop.all())
            self.assertLess(time.monotonic(), end, f'{shop.vendor} server, {AGAIN_S} s after all went on: {silent}\n{said}')
            time.sleep(0.2)

    def freeze(self, programs):
        for program in programs:
            program.child.send_signal(signal.SIGSTOP)
        time.sleep(FROZEN_S)
        for program in programs:
            program.child.send_signal(signal.SIGCONT)
        return time.monotonic()

    def test_both_sides_are_heard_again(self):
        with tempfile.TemporaryDirectory() as name:
            shops = [Shop(pathlib.Path(name), vendor, domain) for vendor, domain in zip(VENDORS, STAND_STILL_DOMAINS)]
            try:
                for shop in shops:
                    for agent in shop.agents:
                        self.assertTrue(agent.says('server: epoch', 60), agent.text())
                    self.heard(shop, time.monotonic() - 5)
                before = [len(shop.server.text()) for shop in shops]
                went_on = self.freeze([shop.server for shop in shops])
                for shop, said in zip(shops, before):
                    self.heard(shop, went_on)
                    self.assertNotIn('robot.silent', shop.server.text()[said:], 'it was the server that stood still')
                went_on = self.freeze([agent for shop in shops for agent in shop.agents])
                for shop in shops:
                    self.heard(shop, went_on)
            finally:
                for shop in shops:
                    for program in shop.all():
                        program.child.send_signal(signal.SIGCONT)
                        program.__exit__()


if __name__ == '__main__':
    main()
