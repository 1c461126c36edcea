"""The disk that a machine begins with: a fresh Debian 12 with systemd, a kernel, and the packages that Weft's depend on."""
import pathlib
import shutil
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / 'tests'))
from playing import debian  # noqa: E402
from playing.processes import run  # noqa: E402

WORK = TOP / 'build' / 'machines'
GUEST = pathlib.Path(__file__).resolve().parent / 'guest'
# A machine as people install it, without what asks them: kernel, service manager, network.
MACHINE = ('linux-image-cloud-amd64', 'initramfs-tools', 'systemd', 'systemd-sysv', 'dbus', 'udev', 'iproute2', 'procps', 'kmod')
DISK_GB = 4
# file of guest/, where it goes, its mode
FILES = (('commands', 'usr/local/sbin/weft-test', 0o755), ('weft-test.service', 'etc/systemd/system/weft-test.service', 0o644),
         ('server.network', 'etc/systemd/network/10-server.network', 0o644), ('robot.network', 'etc/systemd/network/10-robot.network', 0o644))
ENABLED = (('multi-user.target', '/etc/systemd/system/weft-test.service'), ('multi-user.target', '/lib/systemd/system/systemd-networkd.service'),
           ('network-online.target', '/lib/systemd/system/systemd-networkd-wait-online.service'))
# What would ask people at the first start, or work in the middle of a scenario.
MASKED = ('systemd-firstboot.service', 'apt-daily.timer', 'apt-daily-upgrade.timer', 'e2scrub_all.timer', 'e2scrub_reap.service', 'fstrim.timer',
          'dpkg-db-backup.timer', 'serial-getty@ttyS0.service')


def depended(packages):
    """Names of what these files depend on, Weft's own apart; of alternatives the first."""
    names = set()
    for package in packages:
        for clause in run('dpkg-deb', '-f', package, 'Depends').split(','):
            name = clause.split('|')[0].split('(')[0].strip()
            if name and not name.startswith('weft-'):
                names.add(name)
    return sorted(names)


def of(packages):
    """A folder with `disk`, `kernel` and `initrd`, made once for each release of Debian and set of dependencies."""
    include = [*MACHINE, *depended(packages)]
    texts = [path.read_text() for path in sorted(GUEST.iterdir())] + [pathlib.Path(__file__).read_text()]
    folder = WORK / f'debian-{debian.release_key(*include, *texts)}'
    if (folder / 'disk').exists():
        return folder
    for old in WORK.glob('debian-*'):
        shutil.rmtree(old)
    folder.mkdir(parents=True)
    tree = folder / 'tree'
    # The small initrd is asked for before the kernel's package makes one.
    early = [f'--essential-hook={command}' for command in (
        'mkdir -p "$1/etc/initramfs-tools/conf.d" "$1/etc/initramfs-tools/hooks"',
        'echo MODULES=list >"$1/etc/initramfs-tools/conf.d/weft-test"',
        f'install -m 755 {GUEST}/drivers "$1/etc/initramfs-tools/hooks/weft-test"')]
    debian.make(folder / 'tar', include, early)
    tree.mkdir()
    run('tar', '--numeric-owner', '-xf', folder / 'tar', '-C', tree, timeout=600)
    (folder / 'tar').unlink()
    dress(tree)
    for name, pattern in (('kernel', 'vmlinuz-*'), ('initrd', 'initrd.img-*')):
        shutil.copy(next((tree / 'boot').glob(pattern)), folder / name)
    write_disk(tree, folder / 'disk.new', DISK_GB * 1024)
    shutil.rmtree(tree)
    (folder / 'disk.new').rename(folder / 'disk')
    return folder


def dress(tree):
    """Puts in what the tests need, as nothing else of it differs from a machine that people install."""
    for name, path, mode in FILES:
        target = tree / path
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(GUEST / name, target)
        target.chmod(mode)
    units = tree / 'etc/systemd/system'
    for target, unit in ENABLED:
        (units / f'{target}.wants').mkdir(exist_ok=True)
        link(units / f'{target}.wants' / pathlib.Path(unit).name, unit)
    for unit in MASKED:
        link(units / unit, '/dev/null')
    (tree / 'etc/fstab').write_text('/dev/vda / ext4 rw 0 1\n/dev/vdb /packages ext4 ro 0 0\n')
    (tree / 'packages').mkdir()
    (tree / 'etc/hosts').write_text('127.0.0.1 localhost\n10.77.0.1 server\n10.77.0.2 robot\n')
    (tree / 'etc/machine-id').write_text('')           # each machine has its own from its first start on
    (tree / 'etc/hostname').unlink(missing_ok=True)


def link(path, target):
    path.unlink(missing_ok=True)
    path.symlink_to(target)


def write_disk(tree, disk, megabytes, label='weft'):
    """Writes a file system with what is below `tree`; needs no mount."""
    run('truncate', '-s', f'{megabytes}M', disk)
    run('mke2fs', '-q', '-F', '-t', 'ext4', '-L', label, '-d', tree, disk, timeout=600)
