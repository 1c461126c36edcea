"""stereo.png: the path of a recorded pair of cameras, as it truly was, by our odometry and by OpenCV's parts."""
import numpy

from sheet import BLUE, INK, PANEL, VERMILION, dress, panels, read_json, save

AXES = ('x', 'y', 'z')
WAYS = (('truth', 'truth', INK, 1.6), ('baseline', 'KLT + PnP', BLUE, 1.0), ('ours', 'ours', VERMILION, 1.0))


def number_of(file):
    return int(file.stem.rsplit('-', 1)[1])


def widest_of(truth):
    """The two axes along which the path reaches furthest, in their order."""
    reach = numpy.ptp(truth, axis=0)
    return sorted(numpy.argsort(reach, kind='stable')[-2:])


def draw(folder):
    files = sorted((folder / 'series').glob('stereo-*.json'), key=number_of)
    if not files:
        return
    shown = [read_json(file) for file in files]
    figure, axes = panels(f'A recorded pair of cameras: {shown[0]["recording"]}',
                          'paths laid over the truth, and how far they are off', 2 * len(shown), 2, PANEL)
    for row, one in enumerate(shown):
        path, errors = axes[2 * row:2 * row + 2]
        truth = numpy.array(one['truth'])
        across, up = widest_of(truth)
        for key, name, ink, thick in WAYS:
            way = numpy.array(one[key])
            path.plot(way[:, across], way[:, up], color=ink, linewidth=thick, label=name)
            if key != 'truth':
                errors.plot(range(len(way)), numpy.linalg.norm(way - truth, axis=1), color=ink, linewidth=thick, label=name)
        dress(path, f'{one["hz"]:.0f} pairs a second', f'{AXES[across]}, m', f'{AXES[up]}, m', is_map=True)
        errors.set_ylim(bottom=0.0)
        dress(errors, 'how far off', 'number of the pair', 'off, m')
    yield save(figure, folder, 'stereo.png')
