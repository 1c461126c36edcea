"""floor-relocalise.png: the share of robots that found themselves over metres pushed, and where they did not."""
from sheet import INK, MAP, ORANGE, QUIET, colour, columns, dress, panels, plot_found, read_json, read_rows, save


def plot_along(axes, rows, along, kinds, push_m):
    for i, kind in enumerate(kinds):
        some = [row for row in rows if row['floor'] == kind and row['along'] == along]
        if some:
            metres = [float(row['found_m']) for row in some if row['found_m'] and row['wrong'] == '0']
            plot_found(axes, metres, len(some), push_m, kind, colour(i))
    dress(axes, f'pushed {along} along the way', 'pushed, m', 'share found')


def plot_failures(axes, rows, kind, line):
    some = [row for row in rows if row['floor'] == kind]
    wrong = [row for row in some if row['wrong'] != '0']
    lost = [row for row in some if row['wrong'] == '0' and not row['found_m']]
    axes.plot(*columns(line), color=QUIET, linewidth=1.0, label='taught')
    for name, ink, size, group in (('not found', ORANGE, 5.0, lost), ('WRONG', INK, 8.0, wrong)):
        axes.plot([float(row['x']) for row in group], [float(row['y']) for row in group], 'o', color=ink, markersize=size, label=name)
    dress(axes, f'{kind}: {len(lost)} of {len(some)} not found, {len(wrong)} wrong', 'x, m', 'y, m', is_map=True)


def draw(folder):
    rows = read_rows(folder / 'relocalise.csv')
    study = read_json(folder / 'series' / 'floor-relocalise.json', otherwise={})
    kinds, ways = (list(dict.fromkeys(row[name] for row in rows)) for name in ('floor', 'along'))
    figure, grid = panels('Robots that know nothing, pushed until they know where they are', study.get('about', 'method floor'),
                          len(ways) + len(kinds), 2, MAP)
    for axes, along in zip(grid, sorted(ways, reverse=True)):
        plot_along(axes, rows, along, kinds, study.get('push_m', 0.0))
    for axes, kind in zip(grid[len(ways):], kinds):
        plot_failures(axes, rows, kind, study.get('line', []))
    yield save(figure, folder, 'floor-relocalise.png')
