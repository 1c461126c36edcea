"""SE(2) for the judge: poses are (x, y, heading) in metres and radians; a_from_b takes b-coordinates to a."""
import math


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


def compose(a_from_b, b_from_c):
    x, y, h = a_from_b
    c, s = math.cos(h), math.sin(h)
    return (x + c * b_from_c[0] - s * b_from_c[1], y + s * b_from_c[0] + c * b_from_c[1], wrap(h + b_from_c[2]))


def inverse(a_from_b):
    x, y, h = a_from_b
    c, s = math.cos(h), math.sin(h)
    return (-c * x - s * y, s * x - c * y, wrap(-h))


def between(site_from_a, site_from_b):
    return compose(inverse(site_from_a), site_from_b)


def distance(p, q):
    return math.hypot(p[0] - q[0], p[1] - q[1])


def error(measured, true):
    """(metres, degrees) between two poses of one frame."""
    off = between(true, measured)
    return math.hypot(off[0], off[1]), abs(math.degrees(off[2]))


def to_polyline(point, polyline):
    """Distance of a point to a chain of points; to the single point where there is just one."""
    best = distance(point, polyline[0])
    for p, q in zip(polyline, polyline[1:]):
        dx, dy = q[0] - p[0], q[1] - p[1]
        length2 = dx * dx + dy * dy
        t = 0.0 if length2 == 0 else max(0.0, min(1.0, ((point[0] - p[0]) * dx + (point[1] - p[1]) * dy) / length2))
        best = min(best, math.hypot(point[0] - p[0] - t * dx, point[1] - p[1] - t * dy))
    return best
