#!/usr/bin/python3
"""Tests of the pictures of studies: what is plotted, with units and legends, from files as studies leave them."""
import importlib
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
CHARTS = ROOT / 'clients' / 'evaluate' / 'charts'
sys.dont_write_bytecode = True
sys.path[:0] = [str(CHARTS), str(pathlib.Path(__file__).resolve().parent)]

from matplotlib import pyplot

import draw as command
import samples

PICTURES = {
    'floor': {'floor-6a-scale.png': 2, 'floor-6b-speed.png': 2, 'floor-6c-paths.png': 2, 'floor-7-frame-rates.png': 6,
              'floor-8a-localisation.png': 2, 'floor-8b-consistency.png': 2, 'floor-9-blind.png': 1, 'floor-10a-repeat.png': 4,
              'floor-10b-heading.png': 2, 'floor-10c-two-experiences.png': 2},
    'replay': {'replay.png': 4}, 'floor-attempts': {'floor-attempts.png': 6}, 'floor-relocalise': {'floor-relocalise.png': 4},
    'bearing': {'paths.png': 2, 'first-loop.png': 1, 'loops.png': 1, 'ablation.png': 1},
    'bearing-relocalise': {'bearing-relocalise.png': 4}, 'disturbances': {'disturbances.png': 4},
    'ceiling': {'ceiling.png': 4}, 'particles': {'particles.png': 2},
    'stereo': {'stereo.png': 4}, 'topometric': {'topometric.png': 4, 'topometric-overlay.png': 2}}
UNITS = (', m', ', s', ', m/s', ', mm', ', degrees', 'mm', '% of', 'share', 'P(X', 'loops', 'matches', 'number', 'floor')


class Charts(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def figures_of(self, study):
        """Draws the sample of a study; its figures by file, kept open."""
        getattr(samples, study.replace('-', '_'))(self.folder)
        module, figures = importlib.import_module(command.MODULES[study]), {}

        def keep(figure, folder, name):
            figure.savefig(folder / name, dpi=40)
            self.addCleanup(pyplot.close, figure)
            figures[name] = figure
            return name
        saved, module.save = module.save, keep
        self.addCleanup(setattr, module, 'save', saved)
        self.assertEqual(list(module.draw(self.folder)), list(figures))
        return figures

    def test_each_study_has_its_pictures_with_units_and_legends(self):
        for study, pictures in PICTURES.items():
            with self.subTest(study):
                figures = self.figures_of(study)
                panels = {name: [axes for axes in figure.axes if axes.axison] for name, figure in figures.items()}
                self.assertEqual({name: len(axes) for name, axes in panels.items()}, pictures)
                for name, some in panels.items():
                    for axes in some:
                        has_legend = axes.get_legend() is not None or figures[name].legends
                        self.assertTrue(has_legend, f'{name}: no legend')
                        for label in (axes.get_xlabel(), axes.get_ylabel()) if study != 'disturbances' else (axes.get_xlabel(),):
                            self.assertTrue(any(unit in label for unit in UNITS), f'{name}: "{label}" has no unit')

    def test_the_share_that_was_found_grows_to_its_end(self):
        forwards = self.figures_of('floor-relocalise')['floor-relocalise.png'].axes[0]
        line = forwards.get_lines()[0]
        self.assertEqual(line.get_label(), 'epoxy')
        self.assertEqual(line.get_xdata()[-1], 3.0)
        self.assertEqual([round(y, 3) for y in line.get_ydata()], [0.0, 0.167, 0.333, 0.5, 0.667, 0.667])

    def test_wrong_places_and_refusals_are_told_apart(self):
        figure = self.figures_of('bearing-relocalise')['bearing-relocalise.png']
        self.assertEqual(figure.axes[2].get_title(loc='left'), 'other-loads: 6 found, 2 not, 2 wrong')
        self.assertEqual([line.get_label() for line in figure.axes[0].get_lines()], ['other-loads'], 'no answer is right where not taught')

    def test_bins_with_few_attempts_are_left_out(self):
        near = self.figures_of('floor-attempts')['floor-attempts.png'].axes[0].get_lines()[0]
        self.assertEqual([round(x, 2) for x in near.get_xdata()], [0.05, 0.15])
        self.assertEqual(list(near.get_ydata()), [0.9, 0.5])

    def test_only_seeds_that_were_asked_for_count(self):
        loops = self.figures_of('bearing')['loops.png'].axes[0]
        dots, median = loops.get_lines()
        self.assertEqual(len(dots.get_xdata()), 10)
        self.assertEqual(median.get_ydata()[0], 0.75)

    def test_blind_stretches_are_shown_as_shares(self):
        steps = self.figures_of('floor')['floor-9-blind.png'].axes[0].get_lines()[0]
        self.assertEqual(list(steps.get_xdata()), [0.0, 0.1, 0.1, 0.4, 0.4])
        self.assertEqual(list(steps.get_ydata()), [1.0, 0.75, 0.5, 0.25, 0.0])
        self.assertEqual(steps.get_drawstyle(), 'steps-post')

    def test_a_robot_that_did_not_find_itself_is_told(self):
        figure = self.figures_of('floor')['floor-8a-localisation.png']
        self.assertEqual(figure.axes[1].get_title(loc='left'), 'worn wood: the robot did not find itself, and stood')

    def test_a_disturbance_without_a_value_leaves_a_gap(self):
        axes = self.figures_of('disturbances')['disturbances.png'].axes
        self.assertEqual([text.get_text() for text in axes[0].get_yticklabels()], ['noise', 'rolling shutter 20 ms'])
        self.assertEqual([line.get_label() for line in axes[2].get_lines()], ['all', 'all but this one', 'all and this one', 'this one alone'])

    def test_the_path_lies_over_the_grid_that_it_was_located_in(self):
        path, errors = self.figures_of('particles')['particles.png'].axes
        image = path.get_images()[0]
        self.assertEqual([round(edge, 3) for edge in image.get_extent()], [-1.0, 2.0, 0.5, 2.5])
        self.assertEqual(image.get_array()[0].tolist(), [0, 1, 2], 'the lowest row first: unknown, free, occupied')
        self.assertEqual([round(y, 2) for y in errors.get_lines()[0].get_ydata()], [0.0, 0.5])

    def test_a_recorded_path_is_seen_from_where_it_reaches_furthest(self):
        path, errors = self.figures_of('stereo')['stereo.png'].axes[:2]
        self.assertEqual((path.get_xlabel(), path.get_ylabel()), ('x, m', 'z, m'))
        self.assertEqual([line.get_label() for line in path.get_lines()], ['truth', 'KLT + PnP', 'ours'])
        self.assertEqual([round(y, 2) for y in errors.get_lines()[1].get_ydata()], [0.01, 0.5])

    def test_data_without_series_are_drawn_as_far_as_they_go(self):
        for study, left in (('bearing', {'loops.png'}), ('floor', {'floor-9-blind.png'}), ('disturbances', {'disturbances.png'}),
                            ('floor-relocalise', {'floor-relocalise.png'})):
            with self.subTest(study), tempfile.TemporaryDirectory() as name:
                self.folder = pathlib.Path(name)
                getattr(samples, study.replace('-', '_'))(self.folder)
                for file in sorted(self.folder.glob('series/**/*.json')):
                    file.unlink()
                self.assertEqual(set(importlib.import_module(command.MODULES[study]).draw(self.folder)), left)

    def run_command(self, *arguments, options=()):
        return subprocess.run(['/usr/bin/python3', *options, str(CHARTS / 'draw.py'), *arguments], capture_output=True, text=True, check=False)

    def test_the_command_names_what_it_drew(self):
        samples.replay(self.folder)
        ran = self.run_command('replay', str(self.folder))
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, 'drawn: replay.png\n', ''))
        self.assertEqual((self.folder / 'replay.png').read_bytes()[:8], b'\x89PNG\r\n\x1a\n')

    def test_the_command_says_in_a_line_what_is_missing(self):
        samples.replay(self.folder)
        for arguments, options, words in ((('floor', str(self.folder)), (), 'floor.json: No such file'),
                                          (('replay', str(self.folder)), ('-S',), 'matplotlib is missing; apt-get install python3-matplotlib'),
                                          (('walls', str(self.folder)), (), 'STUDY is one of floor, replay')):
            ran = self.run_command(*arguments, options=options)
            self.assertEqual((ran.returncode, ran.stdout, ran.stderr.count('\n')), (1, '', 1), ran.stderr)
            self.assertIn(words, ran.stderr)

    def test_a_damaged_file_is_told(self):
        for text in ('{', '[]', '{"recording": "hall"}', '{"recording": 3, "speeds": 4}'):
            samples.write(self.folder / 'series' / 'replay.json', text)
            ran = self.run_command('replay', str(self.folder))
            self.assertEqual((ran.returncode, ran.stderr.count('\n')), (1, 1), ran.stderr)
            self.assertIn('files that weft-evaluate did not write', ran.stderr)


if __name__ == '__main__':
    unittest.main()
