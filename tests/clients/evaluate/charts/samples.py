"""Small folders as studies leave them, for the tests of their pictures."""
import json
import math


def write(path, document):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(document if isinstance(document, str) else json.dumps(document))


def way(metres=6.0, aside=0.0):
    return [[0.1 * i, math.sin(0.05 * i) + aside] for i in range(int(10 * metres))]


def bearing(folder):
    rows = [{'trial': trial, 'seed': seed, 'after_loop_m': [1.0 / (loop + seed) for loop in range(loops)]}
            for trial, loops in (('oval', 5), ('oval-profile-only', 5), ('corners', 1)) for seed in (1, 2, 3)]
    write(folder / 'bearing.json', {'study': {'scenes_sha256': 'ab' * 32}, 'rows': rows})
    write(folder / 'series' / 'bearing.json',
          {'seeds': [1, 2], 'trials': [{'name': 'oval', 'about': '10 m oval, 1 m off', 'is_ablation': False},
                                       {'name': 'oval-profile-only', 'about': 'oval, profile only', 'is_ablation': True},
                                       {'name': 'corners', 'about': 'rectangle with sharp turns', 'is_ablation': False}]})
    shown = {'taught': way(), 'first': way(aside=0.5), 'last': way(aside=0.1), 'error': way(), 'model': way(aside=0.1)}
    for name in ('oval', 'oval-profile-only'):
        write(folder / 'series' / f'{"ab" * 8}-seed-1' / f'{name}.json', shown)
    write(folder / 'series' / f'{"ab" * 8}-seed-1' / 'corners.json', {**shown, 'model': []})


def bearing_relocalise(folder):
    lines = ['kind,light,seed,x,y,heading,found_m,right,along_m,aside_m,turned_rad,sigma_m,refused']
    for kind in ('other-loads', 'one-side-not-taught'):
        for light in ('same', 'half'):
            lines += [f'{kind},{light},1,{i},{2 * i},0.5,0.{i},1,0.01,0.02,0,0.05,' for i in range(1, 4) if kind == 'other-loads']
            lines += [f'{kind},{light},1,4,4,0.5,,,,,,,another_scene', f'{kind},{light},1,5,4,0.5,0.7,0,3,0,0,0.05,']
    write(folder / 'relocalise.csv', '\n'.join(lines) + '\n')


def floor_relocalise(folder):
    lines = ['floor,light,seed,along,x,y,heading,found_m,wrong,refused']
    for kind in ('epoxy', 'worn wood'):
        for along in ('forwards', 'backwards'):
            lines += [f'"{kind}","same",1,{along},{i},2,0.1,{0.2 * i},0,' for i in range(1, 5)]
            lines += [f'"{kind}","same",1,{along},5,2,0.1,,0,no_consensus', f'"{kind}","same",1,{along},6,2,0.1,0.4,1,']
    write(folder / 'relocalise.csv', '\n'.join(lines) + '\n')
    write(folder / 'series' / 'floor-relocalise.json', {'about': 'site demo', 'push_m': 3.0, 'line': way()})


def floor_attempts(folder):
    lines = ['floor,light,seed,attempt,outcome,count']
    for kind in ('epoxy', 'worn wood'):
        lines += [f'"{kind}","same",1,"near","right",30', f'"{kind}","same",1,"near","no_consensus",10',
                  f'"{kind}","same",1,"near, guided","right",20', f'"{kind}","same",1,"elsewhere","another_scene",40']
    write(folder / 'attempts.csv', '\n'.join(lines) + '\n')
    bins = {'tried_by_metres': [10, 10, 4] + [0] * 9, 'right_by_metres': [9, 5, 4] + [0] * 9,
            'tried_by_heading': [10] * 12, 'right_by_heading': [8] * 12}
    rows = [{'floor': kind, 'light': light, 'seed': 1, 'recall': {'near': bins, 'near, guided': bins}}
            for kind in ('epoxy', 'worn wood') for light in ('same', 'not asked for')]
    write(folder / 'attempts.json', {'rows': rows})
    write(folder / 'series' / 'floor-attempts.json', {'about': 'site demo, 100 attempts', 'bin_m': 0.1, 'bin_deg': 15.0})


def floor(folder):
    rows = [{'floor': kind, 'part': part, 'seed': seed, 'blind_distances_m': [0.1, 0.4] if part == 'same' else []}
            for kind in ('epoxy', 'worn wood') for part in ('mapping', 'same') for seed in (1, 2, 3)]
    write(folder / 'floor.json', {'rows': rows})
    seconds = [[0.1 * i, 0.5, 0.5] for i in range(50)]
    shown = {'camera_height_m': 0.6, 'speeds': seconds, 'speed_percent': 0.41, 'taught': way(), 'odometry': way(aside=0.02),
             'repeated': way(aside=0.01), 'fixes': 12, 'fixed': way()[::10], 'between_fixes': seconds, 'apart_percent': 0.8,
             'off': [[0.1 * i, 0.05 * i, 0.004, 0.01] for i in range(50)],
             'rates': [{'fps': fps, 'matches': way(), 'speeds': way(), 'path': way(), 'odometry': way(aside=0.1)} for fps in (60.0, 7.5)],
             'two_taught': [way(3.0), way()], 'two_repeated': way(aside=0.01)}
    stood = {**shown, 'floor': 'worn wood', 'fixes': 0, 'fixed': [], 'between_fixes': [], 'apart_percent': None, 'repeated': [],
             'off': [], 'two_taught': [way(3.0), []], 'two_repeated': []}
    write(folder / 'series' / 'floor.json',
          {'about': 'site demo, method floor, 6 m', 'of_first': 'seed 1, repeated under: same', 'seeds': [1, 2], 'lights': ['same'],
           'floors': ['epoxy', 'worn wood'], 'shown': [{**shown, 'floor': 'epoxy'}, stood]})


def disturbances(folder):
    columns = ('speed_error_mm_s', 'drift_mm', 'fix_mm', 'fixes_percent')
    lines = ['variant,seed,' + ','.join(columns)]
    for i, variant in enumerate(('all', 'none', 'without noise', 'only noise', 'with rolling shutter 20 ms', 'only rolling shutter 20 ms')):
        lines += [f'"{variant}",{seed},{3 + i},{40 + seed},{"" if variant == "none" else 4},97' for seed in (1, 2, 3)]
    write(folder / 'disturbances.csv', '\n'.join(lines) + '\n')
    write(folder / 'series' / 'disturbances.json',
          {'about': 'site demo', 'seeds': [1, 2], 'disturbances': ['noise', 'rolling shutter 20 ms']})


def replay(folder):
    write(folder / 'series' / 'replay.json',
          {'recording': 'hall', 'about': 'method floor, camera down', 'odometry': way(), 'trajectory': way(aside=0.1), 'matches': way(),
           'fixes': [[1.0, 3], [2.0, 4]], 'speeds': [[0.1 * i, 0.5, 0.5] for i in range(50)]})


def ceiling(folder):
    lines = ['trial,seed,number,value']
    for kind in ('found', 'found-half', 'found-lamps'):
        for seed in (1, 2):
            lines += [f'"{kind}",{seed},"found_percent",{99 - seed}', f'"{kind}",{seed},"sift_percent",60', f'"{kind}",{seed},"wrong",0']
    write(folder / 'ceiling.csv', '\n'.join(lines) + '\n')
    bound = {'row': 3, 'measure': 'line: lateral RMS', 'unit': 'mm', 'is_at_most': True, 'bound_median': 10.0, 'bound_worst': 15.0,
             'median': 8.0, 'worst': 12.0, 'baseline': 120.0, 'verdict': 'met'}
    write(folder / 'ceiling.json', {'study': {}, 'rows': [], 'bounds': [bound, {**bound, 'row': 4, 'median': None, 'baseline': None}]})
    write(folder / 'series' / 'ceiling.json', {'about': 'sites ceiling', 'of_first': 'seed 1'})
    for trial in ('line', 'other', 'change'):
        write(folder / 'series' / f'{trial}.json', {'ours': way(), 'published': way(aside=0.5)})
    write(folder / 'series' / 'loop.json', {'truth': way(), 'odometry': way(aside=0.1), 'composed': way(aside=0.4)})


def particles(folder):
    write(folder / 'particles.csv', 'seed,located,is_lost,mean_m\n1,2,0,0.25\n')
    write(folder / 'series' / 'particles.json',
          {'log': 'a.log', 'seed': 1, 'raster': [-1.0, 0.5, 1.0, 3, 2], 'cells': 'u.#...', 'truth': [[0.0, 1.0], [0.0, 2.0]],
           'located': [[0.0, 1.0], [0.3, 1.6]]})


def stereo(folder):
    for every in (1, 2):
        write(folder / 'series' / f'stereo-{every}.json',
              {'recording': 'hall', 'hz': 20.0 / every, 'truth': [[0.0, 0.01, 0.0], [1.0, 0.0, 2.0]],
               'ours': [[0.0, 0.0, 0.0], [1.0, 0.0, 2.5]], 'baseline': [[0.0, 0.0, 0.0], [1.0, 1.0, 2.0]]})


def topometric(folder):
    walls = [[0.0, 0.0], [6.0, 0.0], [None, None], [0.0, 2.0], [6.0, 2.0]]
    write(folder / 'series' / 'topometric.json', {'about': 'sites deploy/sites/topometric', 'of_first': 'seed 1'})
    write(folder / 'series' / 'map.json', {'taught': way(), 'walls': walls, 'registered': way(), 'unregistered': way(aside=0.1)})
    seconds = [[float(i), 0.01 * i] for i in range(60)]
    write(folder / 'series' / 'deliveries.json',
          {'truth': way(), 'raw': way(aside=0.5), 'open': way(aside=0.1), 'located': way(aside=0.01), 'raw_error': seconds,
           'open_error': seconds, 'blind': [[float(i), float(i % 7 == 0)] for i in range(60)], 'switches': [[1.0, 0.5]],
           'goals': [[2.0, 0.5]]})
    write(folder / 'series' / 'shortcut.json', {'truth': way(), 'taught': way(aside=0.3), 'walls': walls})
    write(folder / 'series' / 'merge.json', {'first': way(), 'second': way(aside=0.1)})
