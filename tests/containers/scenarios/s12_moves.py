"""The server comes back at another address; server and robots start while their link is down."""
TITLE, SECONDS = 'another address, and links that come late', 100
ELSEWHERE = 12


def run(bench):
    fleet = bench.taught()
    fleet.kill_server()
    fleet.lab.remove('server')
    fleet.start_server(ELSEWHERE)
    fleet.wait_server()
    bench.numbers['all robots heard after the server moved'] = f'{fleet.wait_heard(fleet.names):.1f} s'

    fleet.start_late('server', lambda gate: fleet.start_server(ELSEWHERE, gate=gate))
    fleet.wait_server()
    fleet.wait_heard(fleet.names)
    for name in ('r5', 'r6'):                                        # one of each vendor
        fleet.start_late(name, lambda gate: fleet.start_robot(name, gate=gate))
        bench.files.pop(name, None)
    bench.files.pop('server', None)
    fleet.wait_heard(fleet.names)
    fleet.localise(['r5', 'r6'])
    fleet.succeed([fleet.send(2, 'r5'), fleet.send(6, 'r6')], 60)
