"""Whether a floor repeats: squares of it are looked for all over it, turned by quarters too. Worked out from the floor's
picture alone (sim-floor), whatever it was made from."""
import pathlib
import sys

import numpy

METRES_PER_PIXEL = 0.01
SQUARE = 50      # pixels a side: less than half of what a camera sees at once
PATCHES = 8
AROUND = 150     # pixels about a square where it is not looked for: grain goes on for a plank; what repeats does so beyond, too
BLUR = 21        # pixels: broad clouds are alike everywhere and place nothing
WINDOW = 32      # pixels: what the strength of structures is measured over
ALIKE = 0.55     # normalised correlation with a square elsewhere; what does not repeat stays below 0.5


def read(path):
    """8-bit PGM as an array of rows. ValueError: it is none."""
    data = pathlib.Path(path).read_bytes()
    head = data.split(maxsplit=4)
    if len(head) < 4 or head[0] != b'P5' or head[3] != b'255':
        raise ValueError(f'{path} is no 8-bit PGM')
    width, height = int(head[1]), int(head[2])
    if len(data) < width * height:
        raise ValueError(f'{path} is cut short')
    return numpy.frombuffer(data[-width * height:], numpy.uint8).reshape(height, width)


def box_sums(picture, side):
    """Sum of each side x side square, by its first corner."""
    sums = numpy.zeros((picture.shape[0] + 1, picture.shape[1] + 1))
    numpy.cumsum(numpy.cumsum(picture, 0), 1, out=sums[1:, 1:])
    return sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]


def without_clouds(picture):
    rim = BLUR // 2
    padded = numpy.pad(picture.astype(float), rim, mode='reflect')
    return picture - box_sums(padded, BLUR) / BLUR**2


def mean_power(picture):
    """Of its windows of WINDOW pixels (Welch 1967), by frequency: too short for a pattern's period to show in it."""
    taper = numpy.hanning(WINDOW + 2)[1:-1]
    rows, columns = (2 * (side // WINDOW) - 1 for side in picture.shape)
    windows = (picture[j * WINDOW // 2:j * WINDOW // 2 + WINDOW, i * WINDOW // 2:i * WINDOW // 2 + WINDOW]
               for j in range(rows) for i in range(columns))
    return sum(numpy.abs(numpy.fft.fft2(window * numpy.outer(taper, taper)))**2 for window in windows) / (rows * columns)


def evened(picture):
    """Structures of every size and direction made as strong as the others: planks or clouds would else be like each other in
    little more than a step or two, and that by chance."""
    power = mean_power(picture)
    power = 1 / numpy.sqrt(power + 0.02 * power.mean())
    kernel = numpy.fft.fftshift(numpy.fft.ifft2(power).real)
    shape = [1 << (side + WINDOW - 1).bit_length() for side in picture.shape]
    both = numpy.fft.irfft2(numpy.fft.rfft2(picture, shape) * numpy.fft.rfft2(kernel, shape), shape)
    half = WINDOW // 2
    even = both[half:half + picture.shape[0], half:half + picture.shape[1]]
    return even / even.std()


def most_alike(picture, seed=1):
    """(score, (x, y) of a square, (x, y) of the square far off that is most like it), both in metres from the corner."""
    fine = evened(without_clouds(picture))
    height, width = fine.shape
    if max(height, width) < 3 * AROUND or min(height, width) < 2 * SQUARE:
        raise ValueError(f'{width} x {height} pixels of floor are too few to judge; {3 * AROUND} by {2 * SQUARE} are needed')
    shape = [1 << (side - 1).bit_length() for side in fine.shape]
    spectrum = numpy.fft.rfft2(fine, shape)
    count = SQUARE**2
    sums, squares = box_sums(fine, SQUARE), box_sums(fine**2, SQUARE)
    spread = numpy.sqrt(numpy.maximum(squares - sums**2 / count, 1e-3 * count))
    random = numpy.random.default_rng(seed)
    best = (0.0, (0.0, 0.0), (0.0, 0.0))
    for _ in range(PATCHES):
        y, x = random.integers(0, height - SQUARE), random.integers(0, width - SQUARE)
        square = fine[y:y + SQUARE, x:x + SQUARE]
        square = square - square.mean()
        for quarters in range(4):
            looked_for = numpy.fft.rfft2(numpy.rot90(square, quarters), shape)
            scores = numpy.fft.irfft2(spectrum * looked_for.conj(), shape)[:sums.shape[0], :sums.shape[1]]
            scores = scores / (spread * max(1e-3, numpy.linalg.norm(square)))
            scores[max(0, y - AROUND):y + AROUND, max(0, x - AROUND):x + AROUND] = 0.0
            there = numpy.unravel_index(numpy.argmax(scores), scores.shape)
            if scores[there] > best[0]:
                best = (float(scores[there]), (x * METRES_PER_PIXEL, y * METRES_PER_PIXEL),
                        (there[1] * METRES_PER_PIXEL, there[0] * METRES_PER_PIXEL))
    return best


def fault(path):
    """What is wrong with the floor in this picture; None if it does not repeat."""
    try:
        score, here, there = most_alike(read(path))
    except (OSError, ValueError) as problem:
        return f'whether the floor repeats is not known: {problem}'
    if score <= ALIKE:
        return None
    return (f'the floor repeats: what lies at {here[0]:.2f}, {here[1]:.2f} m of its picture lies at {there[0]:.2f}, '
            f'{there[1]:.2f} m again (correlation {score:.2f} > {ALIKE})')


if __name__ == '__main__':
    for name in sys.argv[1:]:
        print(f'{name}: {fault(name) or "does not repeat"}')
