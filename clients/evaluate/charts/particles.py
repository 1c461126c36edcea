"""particles.png, particles-global.png: the path of a particle filter over the grid in which it located itself."""
import numpy
from matplotlib.colors import ListedColormap

from sheet import BLUE, GRID, INK, PANEL, VERMILION, columns, dress, panels, read_json, read_rows, save

SHADES = {'u': 0, '.': 1, '#': 2}
MARGIN = 1.0    # m, around what is known
TITLES = {'particles': 'A laser located in a grid of its other scans',
          'particles-global': 'A laser located from anywhere, once it had found itself'}


def image_of(shown):
    """Rows of numbers, the lowest row first, and the extent of the grid."""
    x, y, cell, wide, deep = shown['raster']
    letters = numpy.frombuffer(shown['cells'].encode(), dtype=numpy.uint8).reshape(deep, wide)
    image = numpy.zeros(letters.shape, dtype=numpy.uint8)
    for letter, shade in SHADES.items():
        image[letters == ord(letter)] = shade
    return image, (x, x + cell * wide, y, y + cell * deep)


def errors_of(shown):
    truth, located = numpy.array(shown['truth']), numpy.array(shown['located'])
    return numpy.hypot(*(truth - located).T) if len(truth) else numpy.array([])


def draw_study(folder, name, title):
    shown = read_json(folder / 'series' / f'{name}.json')
    rows = read_rows(folder / f'{name}.csv')
    image, extent = image_of(shown)
    known = numpy.argwhere(image > 0)
    (low_row, low_column), (high_row, high_column) = known.min(axis=0), known.max(axis=0)
    x, y, cell = shown['raster'][:3]
    size = (PANEL[0] * 1.6, PANEL[1] * 1.9)
    figure, axes = panels(title, f'{shown["log"]}, seed {shown["seed"]} of {len(rows)}', 2, 2, size)
    axes[0].imshow(image, origin='lower', extent=extent, cmap=ListedColormap([GRID, '#ffffff', INK]), vmin=0, vmax=2,
                   interpolation='nearest')
    axes[0].plot(*columns(shown['truth']), color=BLUE, linewidth=1.4, label='as the log was corrected')
    axes[0].plot(*columns(shown['located']), color=VERMILION, linewidth=0.8, label='located')
    axes[0].grid(False)
    dress(axes[0], 'path over the grid of even scans', 'x, m', 'y, m')
    axes[0].set_xlim(x + cell * low_column - MARGIN, x + cell * high_column + MARGIN)
    axes[0].set_ylim(y + cell * low_row - MARGIN, y + cell * high_row + MARGIN)
    axes[0].set_aspect('equal')
    errors = errors_of(shown)
    axes[1].plot(range(len(errors)), errors, color=VERMILION, linewidth=0.8, label='off the log')
    axes[1].set_ylim(bottom=0.0)
    dress(axes[1], 'how far off', 'number of the located scan', 'off, m')
    return save(figure, folder, f'{name}.png')


def draw(folder):
    for name, title in TITLES.items():
        if (folder / 'series' / f'{name}.json').exists():
            yield draw_study(folder, name, title)
