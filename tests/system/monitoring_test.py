#!/usr/bin/python3
"""What a real server and a real agent tell Prometheus: it is sound and has every metric that alerts, dashboard and
documentation name; only this machine is told; slow, silent and hostile clients keep nobody waiting for long."""
import json
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.error
import urllib.request

from command import BIN, MONITORING_DOMAIN, ROOT, Case, Fleet, Running, main, simulated_agent

MONITORING = ROOT / 'deploy/monitoring'
RULES, DASHBOARD = MONITORING / 'weft.rules.yml', MONITORING / 'dashboard.json'
METRIC = re.compile(r'\b(weft_[a-z0-9_]+)\b')
OF_HISTOGRAM = re.compile(r'_(bucket|sum|count)$')
SERVED_S = 8  # what one scrape may take while others hold connections; Prometheus waits for 10


def promtool(*argv, folder=None, given=None):
    return subprocess.run(['promtool', *map(str, argv)], cwd=folder, input=given, capture_output=True, text=True, timeout=60)


def needs_promtool(test):
    missing = shutil.which('promtool') is None
    if missing:
        print('NOT TESTED: promtool is missing (Debian package prometheus)', flush=True)
    return unittest.skipIf(missing, 'promtool is missing')(test)


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


def scrape(port, seconds=30):
    with urllib.request.urlopen(f'http://127.0.0.1:{port}/metrics', timeout=seconds) as answer:
        return answer.read().decode()


def types_of(text):
    return dict(re.findall(r'^# TYPE (\S+) (\S+)$', text, re.MULTILINE))


def value(text, series):
    found = re.search('^' + re.escape(series) + r' (\S+)$', text, re.MULTILINE)
    return float(found.group(1)) if found else None


def expressions():
    """Each expression that alerts and dashboard have, with where it is from."""
    for expression in re.findall(r'expr: (.*?)\n +(?:for|labels):', RULES.read_text(), re.DOTALL):
        yield RULES.name, re.sub(r'^>-\s*', '', expression)
    for panel in json.loads(DASHBOARD.read_text())['panels']:
        for target in panel.get('targets', []):
            yield f'{DASHBOARD.name}, {panel["title"]}', target['expr']


class Files(Case):
    @needs_promtool
    def test_promtool_takes_rules_and_configuration(self):
        for argv in (('check', 'rules', RULES.name), ('check', 'config', 'prometheus.yml')):
            done = promtool(*argv, folder=MONITORING)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @needs_promtool
    def test_alerts_come_when_they_should(self):
        with tempfile.TemporaryDirectory() as folder:
            for file in (RULES, ROOT / 'tests/system/weft.rules_test.yml'):
                shutil.copy(file, folder)
            done = promtool('test', 'rules', 'weft.rules_test.yml', folder=folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @needs_promtool
    def test_promtool_takes_each_expression_of_the_dashboard(self):
        with tempfile.TemporaryDirectory() as folder:
            rules = [{'record': f'x:{i}', 'expr': re.sub(r'\$server', '.*', expression)}
                     for i, (_, expression) in enumerate(expressions())]
            (pathlib.Path(folder) / 'all.yml').write_text(json.dumps({'groups': [{'name': 'all', 'rules': rules}]}))
            done = promtool('check', 'rules', 'all.yml', folder=folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_each_alert_says_what_and_what_to_do(self):
        alerts = RULES.read_text().split('- alert: ')[1:]
        self.assertGreater(len(alerts), 20)
        for alert in alerts:
            self.assertRegex(alert, r'severity: (critical|warning)\}', alert)
            self.assertRegex(alert, r'\n +summary: ".+"\n +cure: ".+"\n', alert)

    def test_each_alert_is_documented(self):
        said = (ROOT / 'docs/monitoring.md').read_text()
        for alert in re.findall(r'- alert: (\w+)', RULES.read_text()):
            self.assertIn(f'`{alert}`', said)


class Monitored(Fleet):
    domain = MONITORING_DOMAIN

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.ports = {'server': free_port(), 'agent': free_port()}
        common = ('--domain', cls.domain, '--dds', cls.vendor)
        cls.server = cls.enterClassContext(Running(cls.folder / 'server.log', BIN / 'weft-server', '--store', cls.folder / 'map',
                                                   '--metrics', cls.ports['server'], *common))
        assert cls.server.says('ready'), cls.server.text()
        config = cls.folder / 'r1.toml'
        config.write_text(f'metrics = {cls.ports["agent"]}\n')
        cls.robot = cls.enterClassContext(Running(cls.folder / 'r1.log', *simulated_agent(
            'r1', cls.folder / 'r1', ROOT / 'deploy/sites/demo.toml', '--config', config, *common)))
        assert cls.robot.says('server: epoch', 60), cls.robot.text()

    def scraped(self, program, holds, seconds=30):
        """The metrics of that program, once they are as they should be."""
        end = time.monotonic() + seconds
        while not holds(text := scrape(self.ports[program])):
            self.assertLess(time.monotonic(), end, text)
            time.sleep(0.2)
        return text

    def all_metrics(self):
        server = self.scraped('server', lambda text: 'weft_robot_heard{' in text)
        agent = self.scraped('agent', lambda text: 'weft_agent_frames_total' in text)
        return server, agent

    def test_they_show_what_is_there(self):
        server, agent = self.all_metrics()
        self.assertEqual(value(server, 'weft_server_epoch'), 1)
        self.assertEqual(value(server, 'weft_healthy'), 1)
        self.assertEqual(value(server, 'weft_link_open'), 1)
        self.assertRegex(server, r'weft_build_info\{program="weft-server",version="[\d.]+",vendor="cyclonedds"\} 1\n')
        self.assertRegex(server, r'weft_robot_heard\{robot="r1",id="[0-9a-f]{32}"\} 1\n')
        self.assertGreater(value(server, 'weft_link_messages_total{topic="weft/1/robot_state",direction="received"}'), 0)
        self.assertGreater(value(server, 'weft_handle_seconds_count'), 0)
        self.assertGreater(value(server, 'weft_store_disk_free_bytes'), 0)
        self.assertRegex(server, r'weft_robot_spool_free_bytes\{robot="r1",id="[0-9a-f]{32}"\} \d')
        agent = self.scraped('agent', lambda text: (value(text, 'weft_agent_epoch') or 0) == 1)
        first = value(agent, 'weft_agent_frames_total')
        self.scraped('agent', lambda text: value(text, 'weft_agent_frames_total') > first)

    def test_names_are_sound(self):
        for text in self.all_metrics():
            for name, kind in types_of(text).items():
                if name.startswith('exposer_'):  # the serving library's own
                    continue
                self.assertRegex(name, '^weft_[a-z0-9_]+$')
                self.assertEqual(name.endswith('_total'), kind == 'counter', name)
            lines = [line.rsplit(' ', 1)[0] for line in text.splitlines() if not line.startswith('#')]
            self.assertEqual(len(lines), len(set(lines)), 'a series twice')

    @needs_promtool
    def test_promtool_reads_them(self):
        for text in self.all_metrics():
            ours = re.sub(r'^(# (TYPE|HELP) )?exposer_.*\n', '', text, flags=re.MULTILINE)
            done = promtool('check', 'metrics', given=ours)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_alerts_and_dashboard_name_what_there_is(self):
        there = {name for text in self.all_metrics() for name in types_of(text)}
        used = [(where, OF_HISTOGRAM.sub('', name) if OF_HISTOGRAM.sub('', name) in there else name)
                for where, expression in expressions() for name in METRIC.findall(expression)]
        self.assertGreater(len(used), 60)
        for where, name in used:
            self.assertIn(name, there, where)

    def test_each_metric_is_documented_and_no_other(self):
        there = {name for text in self.all_metrics() for name in types_of(text) if name.startswith('weft_')}
        said = set(re.findall(r'^\| `(weft_\w+)`', (ROOT / 'docs/monitoring.md').read_text(), re.MULTILINE))
        self.assertEqual(there - said, set(), 'are not in docs/monitoring.md')
        self.assertEqual(said - there, set(), 'are in docs/monitoring.md alone')

    def test_only_this_machine_is_told(self):
        listening = subprocess.run(['ss', '-ltnH'], capture_output=True, text=True, check=True).stdout
        for port in self.ports.values():
            self.assertEqual(re.findall(rf'\s(\S+):{port}\s', listening), ['127.0.0.1'])

    def test_other_paths_and_methods_are_refused(self):
        port = self.ports['server']
        for path, data in (('/', None), ('/metrics/x', None), ('/etc/passwd', None), ('/metrics', b'x')):
            with self.subTest(path), self.assertRaises(urllib.error.HTTPError) as refused:
                urllib.request.urlopen(urllib.request.Request(f'http://127.0.0.1:{port}{path}', data=data), timeout=30)
            self.assertIn(refused.exception.code, (404, 405))

    def test_slow_silent_and_hostile_clients_keep_nobody_waiting(self):
        port = self.ports['server']
        clients = []
        try:
            for i in range(40):
                client = socket.create_connection(('127.0.0.1', port), timeout=10)
                clients.append(client)
                try:
                    if i % 3 == 1:
                        client.sendall(b'GET /metrics HTTP/1.1\r\nX: ')  # and no more
                    if i % 3 == 2:
                        client.sendall(bytes(range(256)) * 40)
                except OSError:
                    pass  # it was cut off
            end = time.monotonic() + 60
            while True:  # some scrape gets through, though the queue is full at first
                try:
                    began = time.monotonic()
                    self.assertIn('weft_server_epoch', scrape(port, SERVED_S))
                    break
                except OSError:
                    self.assertLess(time.monotonic(), end)
            self.assertLess(time.monotonic() - began, SERVED_S + 1)
        finally:
            for client in clients:
                client.close()
        self.assertEqual(self.run_command(BIN / 'weft-health', self.folder / 'map')[0], 0)
        self.assertIsNone(self.server.child.poll())


class Usage(Case):
    def test_ports_that_are_none_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for program in ([BIN / 'weft-server', '--store', folder],
                            simulated_agent('r1', folder, ROOT / 'deploy/sites/demo.toml')):
                for port in ('65536', '-1', '1.5'):
                    self.refused(2, ['metrics'], *program, f'--metrics={port}')

    def test_a_port_that_is_taken_is_named(self):
        with tempfile.TemporaryDirectory() as folder, socket.socket() as holder:
            holder.bind(('127.0.0.1', 0))
            holder.listen()
            port = holder.getsockname()[1]
            self.refused(1, [f'127.0.0.1:{port}', '--metrics'], BIN / 'weft-server', '--store', folder,
                         '--domain', MONITORING_DOMAIN, '--metrics', port)


if __name__ == '__main__':
    main()
