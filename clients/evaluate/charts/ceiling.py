"""ceiling.png: a line as it is driven, the map of a loop, robots that were put down, and what came of each bound."""
import statistics

from sheet import BLUE, GREEN, INK, ORANGE, PANEL, QUIET, VERMILION, columns, dress, panels, read_json, read_rows, save

DRIVES = (('line', 'ours', 'same robot, next day', BLUE), ('other', 'ours', 'another robot', GREEN), ('change', 'ours', 'changed hall', ORANGE),
          ('line', 'published', 'line as published', VERMILION))
MAPS = (('truth', 'truth', INK, '-'), ('odometry', 'odometry', BLUE, '-'), ('adjusted', 'adjusted', GREEN, '-'),
        ('composed', 'homographies composed', VERMILION, '--'))
KINDS = (('found', 'same light'), ('found-half', 'half the lamps off'), ('found-lamps', 'lamps alone'))
MOST_BESIDE = 300.0     # mm, of the panel: what was published may be far beyond


def mean_of(rows, trial, number):
    """Over the seeds; None where nothing was measured."""
    values = [float(row['value']) for row in rows if row['trial'] == trial and row['number'] == number and row['value']]
    return statistics.fmean(values) if values else None


def plot_beside(axes, shown, about):
    for trial, line, label, ink in DRIVES:
        points = shown.get(trial, {}).get(line, [])
        if points:
            axes.plot(*columns(points), color=ink, linewidth=1.4, label=label)
    low, high = axes.get_ylim()
    axes.set_ylim(max(low, -MOST_BESIDE), min(high, MOST_BESIDE))
    dress(axes, f'beside the taught path, {about}', 'driven, m', 'left of it, mm')


def plot_map(axes, loop, about):
    for name, label, ink, style in MAPS:
        if name in loop:
            axes.plot(*columns(loop[name]), style, color=ink, linewidth=1.4, label=label)
    dress(axes, f'places of the loop, {about}', 'x, m', 'y, m', is_map=True)


def plot_found(axes, rows):
    some = [(kind, label) for kind, label in KINDS if mean_of(rows, kind, 'found_percent') is not None]
    for number, label, ink, aside in (('found_percent', 'found in 1 s', GREEN, -0.2), ('sift_percent', 'SIFT in the mosaic', QUIET, 0.2)):
        heights = [mean_of(rows, kind, number) or 0.0 for kind, _ in some]
        axes.bar([i + aside for i in range(len(some))], heights, width=0.36, color=ink, label=label)
    axes.set_xticks(range(len(some)), [label for _, label in some])
    axes.set_ylim(0.0, 103.0)
    wrong = sum(float(row['value']) for row in rows if row['number'] == 'wrong' and row['value'])
    dress(axes, f'put down anywhere, {wrong:.0f} wrong', 'light or ceiling, number of seeds together', 'robots, % of')


def plot_bounds(axes, bounds):
    """Of bounds from above: the median over what is asked, in per cent of it."""
    some = [bound for bound in bounds if bound['is_at_most'] and bound['bound_median']]
    names = [f'{bound["row"]}: {bound["measure"]}' for bound in some]
    for key, label, ink, size in (('median', 'median', BLUE, 6.0), ('baseline', 'baseline', VERMILION, 4.5)):
        points = [(100.0 * bound[key] / bound['bound_median'], i) for i, bound in enumerate(some) if bound[key] is not None]
        axes.plot(*columns(points), 'o', color=ink, markersize=size, label=label)
    axes.axvline(100.0, color=INK, linestyle='--', linewidth=1.2, label='asked')
    axes.set_xscale('log')
    axes.set_yticks(range(len(some)), names)
    axes.set_ylim(len(some) - 0.5, -0.5)
    dress(axes, 'what came of each bound', '% of what is asked', 'row of the table, measure (number)')


def draw(folder):
    rows = read_rows(folder / 'ceiling.csv')
    document = read_json(folder / 'ceiling.json')
    about = read_json(folder / 'series' / 'ceiling.json', otherwise={})
    shown = {trial: read_json(folder / 'series' / f'{trial}.json', otherwise={}) for trial in ('line', 'other', 'change', 'loop')}
    of_first = about.get('of_first', 'first seed')
    plots = [lambda axes: plot_beside(axes, shown, of_first), lambda axes: plot_found(axes, rows), lambda axes: plot_bounds(axes, document['bounds'])]
    if shown['loop']:
        plots.insert(1, lambda axes: plot_map(axes, shown['loop'], of_first))
    figure, grid = panels('How robots navigate by the ceiling', about.get('about', 'method ceiling'), len(plots), 2,
                          (PANEL[0] + 0.9, PANEL[1] + 0.5))
    for axes, plot in zip(grid, plots):
        plot(axes)
    yield save(figure, folder, 'ceiling.png')
