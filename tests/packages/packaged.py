"""What the tests of packages share: where packages are, and tools of our own before the system's."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'system'))
from command import BIN, ROOT, Case, main  # noqa: E402,F401

PACKAGES = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / 'build/packages'


def needs(tool):
    """Leaves tests out, loudly, where a tool is missing."""
    missing = shutil.which(tool) is None
    if missing:
        print(f'NOT TESTED: {tool} is missing', flush=True)
    return unittest.skipIf(missing, f'{tool} is missing')


def package(name):
    found = sorted(PACKAGES.glob(f'{name}_*.deb'))
    assert len(found) == 1, f'{PACKAGES} has {len(found)} packages {name}; deploy/package builds them'
    return found[0]


def output(*argv):
    return subprocess.run([str(a) for a in argv], capture_output=True, text=True, check=True).stdout


class InFolder(Case):
    """Each test has a folder of its own."""

    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)

    def tools(self, **scripts):
        """The environment with these tools before the system's; `_` stands for `-` in their names."""
        where = self.folder / 'tools'
        where.mkdir(exist_ok=True)
        for name, script in scripts.items():
            tool = where / name.replace('_', '-')
            tool.write_text('#!/bin/sh\n' + script + '\n')
            tool.chmod(0o755)
        return {'PATH': f'{where}:{os.environ["PATH"]}'}
