#!/usr/bin/python3
"""The firewall file: nft takes it, and its ports are those that a server has."""
import re
import shutil
import subprocess
import unittest

from command import ROOT, Case, main

FIREWALL = ROOT / 'deploy/network/weft.nft'


def checked(path):
    return subprocess.run(['nft', '-c', '-f', str(path)], capture_output=True, text=True, timeout=60)


class Firewall(Case):
    def test_nft_takes_it(self):
        if shutil.which('nft') is None:
            print('NOT TESTED: nft is missing (Debian package nftables)', flush=True)
            self.skipTest('nft is missing')
        done = checked(FIREWALL)
        if 'Operation not permitted' in done.stderr or 'cache initialization failed' in done.stderr:
            print('NOT TESTED: nft may not run here', flush=True)
            self.skipTest(done.stderr)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, '', ''))

    def test_its_ports_are_those_of_domain_0_and_index_0(self):
        text = FIREWALL.read_text()
        addresses = (ROOT / 'idl/bus/addresses.cpp').read_text()
        base = int(re.search(r'kBase = (\d+)', addresses)[1])
        ports = [int(port) for port in re.search(r'define weft_server_ports = \{ ([\d, ]+) \}', text)[1].split(', ')]
        self.assertEqual(ports, [base + 10, base + 11])

    def test_it_drops_what_it_does_not_name(self):
        self.assertIn('hook input priority filter; policy drop;', FIREWALL.read_text())


if __name__ == '__main__':
    main()
