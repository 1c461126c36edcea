"""Three robots with rendered cameras in containers, as deploy/demonstration and tests/judge expect a fleet."""
import pathlib
import subprocess
import sys
import types

import fleet as fleets
import lab

sys.path.insert(0, str(lab.TOP / 'deploy' / 'demonstration'))
import gather  # noqa: E402
import scenario  # noqa: E402

SITE = lab.TOP / 'tests' / 'containers' / 'rendered'


class Rendered(fleets.Fleet):
    def __init__(self, bench):
        super().__init__(bench.open_lab(), 3, bench.say)
        self.experiences, self.work = {}, self.lab.folder('records', 'all')
        self.vendors = dict(server=self.dds, cli=fleets.VENDORS[1], **{name: fleets.VENDORS[int(name[1:]) % 2] for name in self.names})
        self.start_alone()

    def start_robot(self, name):                       # by the server's address: where packets are lost nobody answers for names
        return self.lab.start(name, fleets.FIRST_ROBOT + int(name[1:]), 'weft-agent-sim', '--dds', self.vendors[name], '--listen', 'eth0', '--server',
                              f'{lab.SUBNET}.{fleets.SERVER_NUMBER}', '--name', name, '--method', 'floor', '--body', 'sim', '--site', '/site/site.toml', '--seed', 1,
                              '--records', '/all', '--truth', '/all/truth.jsonl', flags=['-v', f'{SITE}:/site:ro', '-v', f'{self.work}:/all'], memory='1g')

    def wait_robot(self, name, what, condition, seconds):
        return lab.wait_until(f'{name} {what}', lambda: condition(self.robot(name)), seconds / lab.SLOW, every=0.5)

    def teach_line(self, name, line, experience):
        scenario.teach(self, name, SITE / f'{line}.line', self.say, experience)

    def bytes_for_a_byte(self, name):
        """What a robot that is taught some metres sends, for each byte of contents that it hands in."""
        node, held = self.node(name), self.weft('map', 'info')['content_bytes']
        sent = node.bytes()[1]
        self.teach_line(name, f'{name}-on', f'{name}-on')
        return (node.bytes()[1] - sent) / (self.weft('map', 'info')['content_bytes'] - held)

    def judged(self, bench):
        """Holds to the demo's bounds what the robots have recorded."""
        peak = {name: types.SimpleNamespace(peak_memory_mb=bench.peak_memory_mb(name)) for name in ('server', *self.names)}
        gather.gather(types.SimpleNamespace(weft=self.weft, server=peak['server'], robots=peak, vendors=self.vendors, experiences=self.experiences,
                                            options=types.SimpleNamespace(floors=None), bin=pathlib.Path(bench.build) / 'bin'), self.work, SITE / 'site.toml')
        judged = subprocess.run([lab.TOP / 'tests' / 'judge', self.work], capture_output=True, text=True)
        if judged.returncode:
            raise lab.Trouble('; '.join(line for line in judged.stdout.splitlines() if line.startswith('judge:')) or judged.stderr)
