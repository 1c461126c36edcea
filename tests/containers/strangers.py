#!/usr/bin/python3
"""A stranger on the network. Run in a container's network (nsenter):
  strangers.py listen SECONDS OUT              datagrams that pass eth0, a JSON line each
  strangers.py storm SEED COUNT IN             sends COUNT of them, mutated, to where they went
  strangers.py usurp EPOCH CLAIMED IN          sends each greeting of the server of that epoch with another one; prints how many
Datagrams are sent from the stranger's own address: RTPS knows writers by their ids, which anybody can copy."""
import json
import random
import socket
import struct
import sys
import time

ALL_PROTOCOLS, UDP, RTPS = 3, 17, b'RTPS'
DATA_SUBMESSAGE, HEADER = 0x15, 20


def datagrams(frame):
    """(destination, port, payload) of a whole UDP datagram over IPv4, or nothing."""
    if len(frame) < 42 or frame[12:14] != b'\x08\x00' or frame[23] != UDP or struct.unpack('!H', frame[20:22])[0] & 0x3FFF:
        return None
    start = 14 + 4 * (frame[14] & 15)
    port, length = struct.unpack('!HH', frame[start + 2:start + 6])
    return socket.inet_ntoa(frame[30:34]), port, frame[start + 8:start + length]


def listen(seconds, out):
    tap = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL_PROTOCOLS))
    tap.bind(('eth0', 0))
    tap.settimeout(0.2)
    end, seen = time.monotonic() + float(seconds), 0
    with open(out, 'w') as file:
        while time.monotonic() < end:
            try:
                found = datagrams(tap.recv(65536))
            except socket.timeout:
                continue
            if found and found[2].startswith(RTPS):
                file.write(json.dumps(dict(to=found[0], port=found[1], hex=found[2].hex())) + '\n')
                seen += 1
    print(seen)


def read(path):
    rows = [json.loads(line) for line in open(path)]
    return [(row['to'], row['port'], bytes.fromhex(row['hex'])) for row in rows]


def mutated(data, draw):
    data = bytearray(data)
    kind = draw.randrange(4)
    if kind == 0:                                    # some bytes
        for _ in range(draw.randint(1, 8)):
            data[draw.randrange(4, len(data))] = draw.randrange(256)
    elif kind == 1:                                  # cut short
        del data[draw.randrange(4, len(data)):]
    elif kind == 2:                                  # a length, or whatever stands there
        at = draw.randrange(HEADER, max(HEADER + 1, len(data) - 4))
        data[at:at + 4] = struct.pack('<I', draw.choice((0, 1, 0x7FFFFFFF, 0xFFFFFFFF, draw.getrandbits(32))))
    else:                                            # something more
        at = draw.randrange(HEADER, len(data) + 1)
        data[at:at] = draw.randbytes(draw.randint(1, 64))
    return bytes(data)


def storm(seed, count, path):
    draw, rows = random.Random(int(seed)), read(path)
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    for _ in range(int(count)):
        to, port, data = rows[draw.randrange(len(rows))]
        try:
            out.sendto(mutated(data, draw), (to, port))
        except OSError:
            continue
    print(int(count))


def next_number(data, at):
    """Raises the writer's sequence number of the DATA submessage that holds the byte `at`, so that it is taken as a new sample."""
    data, begin = bytearray(data), HEADER
    while begin + 4 <= len(data):
        order = '<' if data[begin + 1] & 1 else '>'
        length = struct.unpack(order + 'H', data[begin + 2:begin + 4])[0] or len(data) - begin - 4
        if data[begin] == DATA_SUBMESSAGE and begin <= at < begin + 4 + length:
            number = struct.unpack(order + 'I', data[begin + 20:begin + 24])[0]
            data[begin + 20:begin + 24] = struct.pack(order + 'I', number + 1)
            return bytes(data)
        begin += 4 + length
    return None


def usurp(epoch, claimed, path):
    greeting = struct.pack('<Q', int(epoch)) + struct.pack('<I', 7) + b'server\0'
    out, sent = socket.socket(socket.AF_INET, socket.SOCK_DGRAM), 0
    for to, port, data in read(path):
        at = data.find(greeting)
        forged = next_number(data, at) if at >= 0 else None
        if forged:
            out.sendto(forged[:at] + struct.pack('<Q', int(claimed)) + forged[at + 8:], (to, port))
            sent += 1
    print(sent)


if __name__ == '__main__':
    {'listen': listen, 'storm': storm, 'usurp': usurp}[sys.argv[1]](*sys.argv[2:])
