"""A teach line: `x y` a row, metres in the site's frame; `# label NAME` names the spot of the row before it."""
import pathlib


def parts(path):
    """[(points, label or None)]: the line cut where a label is wanted; each part starts where the last one ended."""
    points, result = [], []
    for number, row in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
        words = row.split()
        if words[:2] == ['#', 'label'] and len(words) == 3:
            if not points:
                raise ValueError(f'{path}:{number}: a label before the first point')
            result.append((points, words[2]))
            points = points[-1:]
        elif words and not row.lstrip().startswith('#'):
            try:
                x, y = (float(word) for word in words)
            except ValueError:
                raise ValueError(f'{path}:{number}: expected "x y" in metres, found "{row}"') from None
            points.append((x, y))
    if len(points) > 1 or not result:
        result.append((points, None))
    return result


def write(points, path):
    pathlib.Path(path).write_text(''.join(f'{x:.4f} {y:.4f}\n' for x, y in points))
    return path


def length_m(points):
    return sum(((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 for a, b in zip(points, points[1:]))
