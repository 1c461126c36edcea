"""A map is made: a robot on one machine is taught, the server on the other keeps it."""
TITLE, SECONDS = 'a map is made', 240


def run(bench):
    frame = bench.row().get('frame', 0)
    bench.weft('teach', 'r1', 'start', '--as', 'way')
    bench.weft('map', 'label', 'here', '--robot', 'r1', 'begin')
    bench.lead(1.5, 'way')
    bench.wait_led(frame)
    bench.weft('map', 'label', 'here', '--robot', 'r1', 'end')
    bench.weft('teach', 'r1', 'stop', seconds=120)
    _, places, labels = bench.runs()['way']
    bench.say(f'{places} places, labels {labels}')
    return [] if places >= 5 and len(labels) == 2 else [f'{places} places, labels {labels}']
