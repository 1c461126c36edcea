"""Pictures of the study of method bearing: ways, first loops against the model, errors after each loop, halves alone."""
import math
import statistics

from sheet import BLUE, INK, MAP, PANEL, SKY, VERMILION, columns, dress, panels, read_json, save, words_of


def plot_paths(axes, trial, shown):
    axes.plot(*columns(shown['taught']), color=INK, linewidth=2.6, label='taught')
    axes.plot(*columns(shown['first']), color=VERMILION, linewidth=1.2, label='first loop')
    axes.plot(*columns(shown['last']), color=BLUE, linewidth=1.2, label='last loop')
    dress(axes, trial['about'], 'x, m', 'y, m', is_map=True)


def plot_first_loop(axes, trial, shown):
    axes.plot(*columns(shown['error']), color=BLUE, linewidth=1.6, label='driven')
    axes.plot(*columns(shown['model']), color=INK, linewidth=1.6, linestyle='--', label='model, distance by wheels alone')
    axes.set_ylim(bottom=0.0)
    dress(axes, trial['about'], 'along the taught way, m', 'off where it believes to be, m')


def plot_loops(axes, trial, runs):
    """A dot a seed and loop, and the median of the seeds that came so far."""
    dots, medians = [], []
    for loop in range(max(len(run) for run in runs)):
        errors = [run[loop] for run in runs if len(run) > loop and math.isfinite(run[loop])]
        dots += [(loop + 1, error) for error in errors]
        medians += [(loop + 1, statistics.median(errors))] if errors else []
    axes.plot(*columns(dots), 'o', color=SKY, markersize=3.5, label='seeds')
    axes.plot(*columns(medians), color=BLUE, linewidth=1.8, label='median')
    axes.set_ylim(bottom=0.0)
    axes.xaxis.get_major_locator().set_params(integer=True)
    dress(axes, trial['about'], 'loops driven', "error at the loop's end, m")


def trials_of(rows, study):
    """In the order of the study; of a folder without it, those that have rows."""
    if 'trials' in study:
        return study['trials']
    names = sorted({row['trial'] for row in rows})
    return [{'name': name, 'about': name, 'is_ablation': name.endswith('-only')} for name in names]


def draw(folder):
    document = read_json(folder / 'bearing.json')
    study = read_json(folder / 'series' / 'bearing.json', otherwise={})
    every_seed = [row['seed'] for row in document['rows']]
    first, last = study.get('seeds') or (min(every_seed), max(every_seed))
    rows = [row for row in document['rows'] if first <= row['seed'] <= last]
    series = folder / 'series' / f'{document["study"]["scenes_sha256"][:16]}-seed-{first}'
    trials = trials_of(rows, study)
    shown = {trial['name']: read_json(series / f'{trial["name"]}.json', otherwise={}) for trial in trials}
    runs = {trial['name']: [row['after_loop_m'] for row in rows if row['trial'] == trial['name']] for trial in trials}

    whole = [trial for trial in trials if not trial['is_ablation']]
    of_first, of_all = f'method bearing, {words_of((first, first))}', f'method bearing, {words_of((first, last))}'
    pictures = [
        ('paths.png', 'Taught and repeated', of_first, MAP, plot_paths, shown, [t for t in whole if shown[t['name']].get('taught')]),
        ('first-loop.png', 'The first loop against the model', of_first, PANEL, plot_first_loop, shown,
         [t for t in whole if shown[t['name']].get('model')]),
        ('loops.png', 'Error after each loop', of_all, PANEL, plot_loops, runs,
         [t for t in whole if max(map(len, runs[t['name']]), default=0) > 1]),
        ('ablation.png', 'One half of the method alone', of_first, MAP, plot_paths, shown,
         [t for t in trials if t['is_ablation'] and shown[t['name']].get('taught')])]
    for name, title, about, size, plot, of, some in pictures:
        if not some:
            continue
        figure, grid = panels(title, about, len(some), 3, size)
        for axes, trial in zip(grid, some):
            plot(axes, trial, of[trial['name']])
        yield save(figure, folder, name)
