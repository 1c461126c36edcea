"""bearing-relocalise.png: the share of robots that found themselves over metres led, and where they did or did not."""
from sheet import GREEN, MAP, QUIET, VERMILION, colour, dress, panels, plot_found, read_json, read_rows, save


def is_right(row):
    return row['right'] == '1'


def plot_light(axes, rows, light, kinds, led_m):
    i = 0
    for kind in kinds:
        some = [row for row in rows if row['kind'] == kind['name'] and row['light'] == light]
        if some and not kind['is_without_answer']:
            metres = [float(row['found_m']) for row in some if is_right(row)]
            plot_found(axes, metres, len(some), led_m, kind['name'], colour(i))
            i += 1
    dress(axes, f'light: {light}', 'led, m', 'share found rightly')


def plot_map(axes, rows, kind):
    some = [row for row in rows if row['kind'] == kind['name']]
    groups = [('not found', QUIET, 4.0, [row for row in some if not row['found_m']]),
              ('found', GREEN, 4.0, [row for row in some if is_right(row)]),
              ('WRONG', VERMILION, 8.0, [row for row in some if row['found_m'] and not is_right(row)])]
    for name, ink, size, group in groups:
        axes.plot([float(row['x']) for row in group], [float(row['y']) for row in group], 'o', color=ink, markersize=size, label=name)
    refused, right, wrong = (len(group) for _, _, _, group in groups)
    dress(axes, f'{kind["name"]}: {right} found, {refused} not, {wrong} wrong', 'x, m', 'y, m', is_map=True)


def draw(folder):
    rows = read_rows(folder / 'relocalise.csv')
    study = read_json(folder / 'series' / 'bearing-relocalise.json', otherwise={})
    names, lights = list(dict.fromkeys(row['kind'] for row in rows)), list(dict.fromkeys(row['light'] for row in rows))
    kinds = study.get('kinds') or [{'name': name, 'is_without_answer': name.endswith('-not-taught')} for name in names]
    kinds = [kind for kind in kinds if kind['name'] in names]
    figure, grid = panels('Robots that know nothing, put down among aisles that look alike', study.get('about', 'method bearing'),
                          len(lights) + len(kinds), 2, MAP)
    for axes, light in zip(grid, lights):
        plot_light(axes, rows, light, kinds, study.get('led_m', 0.0))
    for axes, kind in zip(grid[len(lights):], kinds):
        plot_map(axes, rows, kind)
    yield save(figure, folder, 'bearing-relocalise.png')
