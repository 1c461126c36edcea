"""One packet in ten is lost both ways, fragments counted one by one, with jitter and overtaking; then each robot has 1 Mbit/s."""
import lab

TITLE, SECONDS = 'a tenth lost, 60 ms of jitter, a tenth overtaking; then 1 Mbit/s a robot', 200
LOSSY = {'loss': 0.1, 'delay_ms': 1, 'jitter_ms': 60, 'overtake': 0.1}
VENDORS = {'fastdds': ('r2', 'r4', 'r6'), 'cyclonedds': ('r1', 'r3', 'r5')}
MOST_TIMES, SLOW_KBIT = 5, 1000


def sent(fleet, work):
    """vendor -> bytes a second that one of its robots sends meanwhile."""
    meters = {vendor: fleet.meter(names) for vendor, names in VENDORS.items()}
    work()
    return {vendor: meter.rates(len(VENDORS[vendor]))[0] for vendor, meter in meters.items()}


def serve(fleet, first, seconds):
    fleet.succeed([fleet.send((first + 3 * k) % 8) for k in range(5)], seconds)


def lossy(bench, fleet):
    serve(fleet, 0, 90)
    serve(fleet, 5, 90)
    fleet.lead_on(bench.records, 'r6', 'lossy', 8)           # what it hands in, and how it stands, come to the server


def run(bench):
    fleet = bench.taught()
    clean = sent(fleet, lambda: serve(fleet, 3, 60))
    losses = [lab.Loss(fleet.node(name), seed=101 + number, **LOSSY) for number, name in enumerate(('server', *fleet.names))]
    with fleet.patient(60):
        try:
            under_loss = sent(fleet, lambda: lossy(bench, fleet))
        finally:
            bench.numbers['a tenth lost'] = lab.lost(losses)
        for vendor, rate in under_loss.items():
            bench.at_most(f'{vendor}, a tenth lost: times the bytes/s that a robot sends where nothing is', rate / clean[vendor], MOST_TIMES)
    with fleet.patient(60), fleet.slow_robots(SLOW_KBIT):
        fleet.succeed([fleet.send(2), fleet.send(6)], 60)
