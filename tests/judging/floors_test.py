#!/usr/bin/python3
"""No site's floor repeats: every site that is shipped, every kind of floor but tiles, and, where WEFT_DATA has them, all
photographs of floors, each by itself and all together. Tiles do, and are seen to.
Usage: floors_test.py SIM_FLOOR [Floors|Photographs]     SIM_FLOOR: that program (ctest says where it is)"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / 'tests'))
from judging import repeats  # noqa: E402

SIM_FLOOR = None
HALL = '''[floor]
x_min = 0
y_min = 0
x_max = 6
y_max = 4
{more}
[[robot]]
name = "r1"
x = 1
y = 2
'''
KINDS = ('concrete', 'polished-concrete', 'worn-concrete', 'epoxy', 'wood', 'asphalt', 'terrazzo')
DATA = pathlib.Path(os.environ.get('WEFT_DATA', ROOT.parent / 'shared' / 'data'))


class OfSites(unittest.TestCase):
    def fault_of(self, site, *flags):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / 'floor.pgm'
            made = subprocess.run([SIM_FLOOR, site, picture, *flags], capture_output=True, text=True)
            self.assertEqual(made.returncode, 0, made.stderr)
            return repeats.fault(picture)

    def fault_in_hall(self, more, *flags):
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder) / 'hall.toml'
            site.write_text(HALL.format(more=more))
            return self.fault_of(site, *flags)


class Floors(OfSites):
    def test_no_shipped_site_repeats(self):
        sites = sorted((ROOT / 'deploy' / 'sites').glob('*.toml'))
        self.assertTrue(sites)
        for site in sites:
            self.assertIsNone(self.fault_of(site), site)

    def test_no_kind_repeats_but_tiles(self):
        for kind in KINDS:
            self.assertIsNone(self.fault_in_hall('', '--kind', kind), kind)
        self.assertIn('the floor repeats', self.fault_in_hall('', '--kind', 'tiles'))


class Photographs(OfSites):
    def test_none_repeats(self):
        if not (DATA / 'textures').is_dir():
            self.skipTest(f'NOT TESTED: {DATA}/textures is absent; set WEFT_DATA to the folder that holds it')
        with tempfile.TemporaryDirectory() as folder:
            floors = pathlib.Path(folder) / 'floors'
            subprocess.run([ROOT / 'tests' / 'floor-textures', floors], check=True, capture_output=True)
            pictures = [path.stem for path in sorted(floors.iterdir()) if path.suffix != '.toml']
            self.assertGreaterEqual(len(pictures), 10)
            for name in pictures:
                self.assertIsNone(self.fault_in_hall(f'photograph = "{name}"', '--floors', floors), name)
            self.assertIsNone(self.fault_in_hall('', '--floors', floors))


if __name__ == '__main__':
    if len(sys.argv) < 2 or sys.argv[1].startswith('-'):
        sys.exit(__doc__)
    SIM_FLOOR = sys.argv.pop(1)
    unittest.main()
