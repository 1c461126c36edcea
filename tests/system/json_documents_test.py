#!/usr/bin/python3
"""Every command of weft with --json: one valid document (goal watch: one a line) that docs/formats/cli.schema.json
describes, for what is done, for what is refused, and for wrong usage, whatever people type and are called."""
import json
import os
import pathlib
import re
import subprocess
import tempfile

import jsonschema

from command import BIN, JSON_DOMAIN, ROOT, Fleet, Running, main, simulated_agent

SCHEMA = json.loads((ROOT / 'docs/formats/cli.schema.json').read_text())
USER = b'J\xff"\\\n\x01\xc3'  # no UTF-8, a quote, a backslash, a line's end, a control character, half a letter
HOSTILE = (b'\xff\xfe', b'a"b', b'a\\b', b'a\nb', b'a\x1bb', 'ü'.encode() * 33, b"'; DROP TABLE label; --", b'%s%n', b'-')
NOBODY = '0123456789abcdef'
LABEL = 'Halle-süd'


def validator(definition):
    return jsonschema.Draft7Validator({**SCHEMA['$defs'][definition], '$defs': SCHEMA['$defs']})


class JsonDocuments(Fleet):
    domain = JSON_DOMAIN

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        line = (ROOT / 'deploy/sites/demo/r1.line').read_text().splitlines()
        (cls.folder / 'r1.line').write_text('\n'.join(line[:12]) + '\n')
        (cls.folder / 'two.g2o').write_text('EDGE_SE2 0 1 0.5 0 0 100 0 0 100 0 100\nEDGE_SE2 5 6 0.5 0 0 100 0 0 100 0 100\n')
        (cls.folder / 'hall.pgm').write_text('P2\n8 6\n255\n' + '254 ' * 48 + '\n')
        (cls.folder / 'hall.yaml').write_text('image: hall.pgm\nresolution: 5.0\norigin: [-10.0, -5.0, 0.0]\nnegate: 0\n'
                                              'occupied_thresh: 0.65\nfree_thresh: 0.196\n')
        common = ('--domain', cls.domain, '--dds', cls.vendor)
        server = cls.enterClassContext(Running(cls.folder / 'server.log', BIN / 'weft-server', '--store', cls.folder / 'map', *common))
        assert server.says('ready'), server.text()
        cls.robot = cls.enterClassContext(Running(
            cls.folder / 'r1.log', *simulated_agent('r1', cls.folder / 'r1', ROOT / 'deploy/sites/demo.toml', '--pace', '3', *common)))
        assert cls.robot.says('server: epoch', 60), cls.robot.text()

    def documents(self, *words):
        """Its exit code and the documents that it printed."""
        words = [word if isinstance(word, bytes) else str(word).encode() for word in words]
        done = subprocess.run([os.fsencode(BIN / 'weft'), b'--domain', str(self.domain).encode(), b'--dds', self.vendor.encode(),
                               b'--json', *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=90,
                              stdin=subprocess.DEVNULL, env={**os.environb, b'USER': USER})
        text = done.stdout.decode()  # strictly
        self.assertNotIn('\\u0000', text)
        if words[:2] == [b'goal', b'watch'] or words[:1] == [b'events']:
            return done.returncode, [json.loads(line) for line in text.splitlines()]
        return done.returncode, [json.loads(text)]

    def fits(self, definition, document, words):
        for error in validator(definition).iter_errors(document):
            self.fail(f'{words}: {error.message} in {json.dumps(document)[:2000]}')

    def is_done(self, command, *words, exits=(0,)):
        ended, documents = self.documents(*command.split(), *words)
        self.assertIn(ended, exits, documents)
        for document in documents:
            self.fits(SCHEMA['properties'][self.named(command)]['$ref'].split('/')[-1], document, (command, *words))
        return documents[-1]

    def is_refused(self, *words):
        ended, documents = self.documents(*words)
        self.assertNotEqual(ended, 0, f'{words}: {documents}')
        self.fits('error', documents[-1], words)
        self.assertEqual(documents[-1]['exit'], ended, words)
        return ended

    @staticmethod
    def named(command):
        """As in the schema: without the robot that teach is for."""
        return ' '.join(word for word in command.split() if word != 'r1')

    @classmethod
    def commands(cls, *above):
        said = subprocess.run([BIN / 'weft', *above, '--help'], capture_output=True, text=True, check=True).stdout
        if '\nSubcommands:\n' not in said or len(above) == 2:  # each of teach has a robot before it
            return [above]
        if above == ('calibrate',):  # hands its line on to weft-agent
            return []
        names = re.findall(r'^  (\w+) ', said.split('\nSubcommands:\n')[1].split('\n\n')[0], re.MULTILINE)
        own = [above] if '[SUBCOMMAND]' in said else []
        return own + [command for name in names for command in cls.commands(*above, name)]

    def test_each_command_is_in_the_schema(self):
        self.assertEqual({' '.join(command) for command in self.commands()}, set(SCHEMA['properties']))

    def test_done(self):
        done = self.is_done
        done('robots')
        done('teach r1 start', '--as', LABEL, '--along', self.folder / 'r1.line')
        self.poll(lambda said: 'hand_done' in said, 60, 'robots')
        done('teach r1 report')
        done('map label', 'here', '--robot', 'r1', LABEL)
        done('teach r1 stop')
        done('localise', 'r1', '--at', LABEL)
        for command in ('stop', 'resume'):
            done(command, 'r1')
            done(command, '--all')
        done('robot counts', 'r1')
        done('map import', self.folder / 'two.g2o', '--as', '12-ware')
        listed = done('map list')['experiences']
        self.assertEqual({one['name'] for one in listed}, {LABEL, '12-ware'})
        one = next(one['id'] for one in listed if one['name'] == LABEL)
        done('map info')
        done('map label', f'{one}:0', 'start')
        done('map relabel', 'start', 'Anfang')
        done('map unlabel', 'Anfang')
        done('map log')
        revision = done('map info')['revision']
        done('map diff', revision - 1)
        for name in ('m.svg', 'm.png'):
            done('map draw', self.folder / name)
        done('map draw', self.folder / 'r.svg', '--robots')
        done('map export', self.folder / 'm.json')
        done('map apart', '--list')
        done('map apart', f'{one}:0..1', f'{one}:5..6')
        done('map apart', '--list')
        plan = self.folder / 'hall.yaml'
        done('map register', '--show')
        done('map register', plan, '--pick', f'{LABEL}=12,4,0.5', '--dry-run')
        done('map register', plan, '--pick', f'{LABEL}=12,4,0.5')
        done('map register', '--show')
        done('robots')
        done('map diff', done('map info')['revision'] - 1)
        done('map export', self.folder / 'm.geojson')
        done('map draw', self.folder / 'p.svg', '--floor-plan', plan)
        done('rule add', 'wet', '--kind', 'closed', '--polygon', '11.5,3.5;12.5,3.5;12.5,4.5;11.5,4.5')
        done('rule list')
        done('rule refresh', 'wet', '--dry-run')
        done('rule refresh', '--all')
        done('rule remove', 'wet')
        done('map register', 'hall', '--remove')
        done('rule list')
        done('rule add', 'slow', '--kind', 'speed=0.3', '--label', LABEL, '--within', 1, '--place', f'{one}:0..3')
        done('rule list')
        done('hold', 'slow')
        done('unhold', 'slow')
        done('rule remove', 'slow')
        done('edge close', f'{one}:0', f'{one}:1')
        done('edge open', f'{one}:0', f'{one}:1')
        for command in ('hold', 'unhold'):
            done(command, 'r1')
        done('map quarantine', f'{one}:1', '--dry-run')
        done('map quarantine', f'{one}:1')
        done('map undo', '--revision', done('map info')['revision'])
        done('map undo', '12-ware')
        done('map rollback', revision)
        for command in ('map prune', 'map check', 'map stats'):
            done(command)
        done('map replace', one, '--dry-run')
        done('map compact', '--before', 1)
        done('map snapshot', self.folder / 'snapshot')
        done('map restore', self.folder / 'snapshot', '--store', self.folder / 'restored')
        goal = done('goal send', '--to', LABEL, '--robot', 'r1', '--no-return')['goal']
        self.poll(lambda said: any(word in said for word in ('succeeded', 'failed')), 60, 'goal', 'list')
        done('goal list')
        done('goal show', goal)
        done('goal why', goal)
        done('goal why', 'r1')
        done('goal watch', goal, exits=(0, 1))
        later = done('goal send', '--to', LABEL, '--no-return')['goal']
        ended, documents = self.documents('goal', 'cancel', later)  # it may be over already
        self.fits('error' if ended else 'reply', documents[0], 'goal cancel')
        done('doctor', exits=(0, 1))
        done('events')
        done('events', '--robot', 'r1', '--kind', 'robot', '--since', '1h')
        done('alarms', exits=(0, 1))
        done('bundle', self.folder / 'report.tar.gz', '--log', self.folder / 'server.log', '--log', '/nowhere/x.log')
        done('doctor', '--fleet', exits=(0, 1))
        done('doctor network', exits=(0, 1))
        done('file info', self.folder / 'two.g2o')
        done('file convert', self.folder / 'two.g2o', '--to', self.folder / 'again.g2o')
        done('robot clear', 'r1', '--yes')
        self.assertEqual(self.robot.stop(), 0, self.robot.text())
        done('robot rename', 'r1', 'Ёж-2')
        done('robot forget', 'Ёж-2')

    def test_refused(self):
        place = f'{NOBODY}:0'
        for words in (('teach', 'nobody', 'start'), ('teach', 'nobody', 'stop'), ('teach', 'nobody', 'report'), ('localise', 'nobody'),
                      ('stop', 'nobody'), ('resume', 'nobody'), ('robot', 'counts', 'nobody'), ('robot', 'clear', 'nobody'),
                      ('robot', 'forget', 'nobody'), ('robot', 'rename', 'nobody', 'x'), ('map', 'draw', '/nowhere/m.svg'),
                      ('map', 'draw', self.folder / 'm.jpg'), ('map', 'draw', '--mosaic', self.folder / 'm.png'),
                      ('map', 'label', place, 'x'), ('map', 'unlabel', 'x'),
                      ('map', 'relabel', 'x', 'y'), ('map', 'export', '/nowhere/m.json'),
                      ('map', 'import', '/nowhere/m.g2o', '--as', 'x'), ('map', 'diff', 4711),
                      ('map', 'rollback', 4711), ('map', 'undo', 'nowhere'), ('map', 'undo', '--revision', 4711),
                      ('map', 'quarantine', place), ('map', 'apart', f'{place}..1', f'{NOBODY}:5..6'), ('map', 'replace', 'nowhere'),
                      ('map', 'register', '/nowhere/x.yaml', '--pick', 'x=1,2'), ('map', 'register', '--remove'),
                      ('goal', 'send', '--to-plan', '1,2'),
                      ('map', 'compact', '--before', 4711), ('map', 'snapshot', '/nowhere/s'),
                      ('map', 'restore', '/nowhere/s', '--store', self.folder / 'x'), ('goal', 'send', '--to', 'nowhere'),
                      ('goal', 'show', 'abcdef'), ('goal', 'watch', 'abcdef'), ('goal', 'cancel', 'abcdef'), ('goal', 'why', 'abcdef'),
                      ('events', '--robot', 'nobody'), ('bundle', self.folder / 'report.zip'), ('bundle', '/nowhere/r.tar.gz'),
                      ('file', 'info', '/nowhere/x.g2o'), ('file', 'convert', '/nowhere/x.g2o', '--to', self.folder / 'y.g2o')):
            with self.subTest(words=words):
                self.assertIn(self.is_refused(*words), (1, 2, 4))

    def test_wrong_usage(self):
        for command in self.commands():
            words = (*command[:1], 'r1', *command[1:]) if command[0] == 'teach' else command
            with self.subTest(words=words):
                self.assertEqual(self.is_refused(*words, '--no-such-option'), 2)

    def test_hostile_words(self):
        for word in HOSTILE:
            for words in (('stop', word), ('robot', 'rename', word, word), ('map', 'label', word, word), ('map', 'unlabel', word),
                          ('goal', 'send', '--to', word), ('map', 'undo', word), ('map', 'import', word, '--as', word), ('goal', 'why', word),
                          ('file', 'info', word), ('map', word), (word,), ('teach', word, 'start', '--as', word)):
                with self.subTest(words=words):
                    self.assertIn(self.is_refused(*words), (1, 2, 4))

    def test_nobody_answers(self):
        ended, documents = self.documents('--timeout', '1', '--server', '127.0.0.1:99', 'robots')
        self.assertEqual(ended, 3)
        self.fits('error', documents[0], 'robots')


if __name__ == '__main__':
    main()
