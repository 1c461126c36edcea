"""The disk with packages that both machines are given: the archive for sites without a network, and the same packages a version newer."""
import pathlib
import shutil

import image
from playing.processes import run

PROGRAMS = ('weft', 'weft-server', 'weft-agent', 'weft-agent-sim', 'weft-health')


def missing(build):
    """Programs that have to be built before; empty: all are there."""
    return [str(build / 'bin' / name) for name in PROGRAMS if not (build / 'bin' / name).exists()]


def build(folder):
    """Builds the packages of a build, and returns their files."""
    made = image.WORK / 'packages'
    run('deploy/package', '--build', folder, '--fast', made, cwd=image.TOP, timeout=900)
    return sorted(made.glob('weft-*.deb'))


def newer_than(version):
    return f'{version}+newer'


def version_of(package):
    return run('dpkg-deb', '-f', package, 'Version').strip()


def make_newer(package, folder):
    """The same package as of a later version, which depends on others of that version; its shipped settings differ."""
    tree, version = image.WORK / 'newer', version_of(package)
    shutil.rmtree(tree, ignore_errors=True)
    run('dpkg-deb', '-R', package, tree)
    control = tree / 'DEBIAN' / 'control'
    text = control.read_text().replace(f'Version: {version}\n', f'Version: {newer_than(version)}\n')
    control.write_text(text.replace(f'(= {version})', f'(= {newer_than(version)})'))
    for settings in (tree / 'etc' / 'weft').glob('*.toml'):
        settings.write_text(settings.read_text() + '# of the newer version\n')
    (tree / 'DEBIAN' / 'md5sums').unlink(missing_ok=True)
    run('dpkg-deb', '--root-owner-group', '-Zgzip', '-z1', '-b', tree, folder / package.name.replace(version, newer_than(version)))
    shutil.rmtree(tree)


def write_disk(packages):
    """Returns the file with the file system that has `site.tar` and `newer/`."""
    tree, disk = image.WORK / 'disk', image.WORK / 'packages.disk'
    shutil.rmtree(tree, ignore_errors=True)
    (tree / 'newer').mkdir(parents=True)
    run('deploy/bundle', '--packages', image.WORK / 'packages', tree / 'site.tar', cwd=image.TOP)
    for package in packages:
        if not package.name.startswith('weft-doc'):
            make_newer(package, tree / 'newer')
    size = sum(path.stat().st_size for path in tree.rglob('*') if path.is_file()) >> 20
    disk.unlink(missing_ok=True)
    image.write_disk(tree, disk, size + size // 8 + 32, 'packages')
    shutil.rmtree(tree)
    return disk
