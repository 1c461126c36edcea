"""Images from programs that are built already: a Debian of our own, then the targets of deploy/Containerfile."""
import pathlib
import shutil
import time

import lab
from playing import debian

BASE = 'debian:bookworm-slim'
PROGRAMS = ('weft', 'weft-server', 'weft-agent', 'weft-agent-sim', 'weft-health')
LIMITS_MB = {'server': 180, 'agent': 400}


def missing(build):
    """Programs that have to be built before, by name; empty: all are there."""
    return [str(path) for path in [*(build / 'bin' / name for name in PROGRAMS), build / 'tests' / 'weft-light-agents'] if not path.exists()]


def copy_programs(build):
    """Stripped, into the folder that the target `prebuilt` takes."""
    for folder, names, source in ((lab.WORK / 'bin', PROGRAMS, build / 'bin'), (lab.WORK / 'light', ('weft-light-agents',), build / 'tests')):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name in names:
            lab.run('strip', '-o', folder / name, source / name)


def make_netfault():
    source, program = lab.TOP / 'tests' / 'containers' / 'netfault.cpp', lab.WORK / 'netfault'
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        lab.run('g++', '-std=c++20', '-O1', '-o', program, source, '-lnetfilter_queue', '-lmnl')


def base_archive():
    """A small Debian, made once for each release of the archive."""
    archive = lab.WORK / f'base-{debian.release_key()}.tar'
    if archive.exists():
        return archive
    for old in lab.WORK.glob('base-*.tar*'):
        old.unlink()
    made = archive.with_suffix('.tar.new')
    debian.make(made)
    made.rename(archive)
    return archive


def import_base(say):
    """Gives the engine, which runs, the small Debian, unless it has it."""
    began = time.monotonic()
    if not lab.docker('images', '-q', BASE).strip():
        archive = base_archive()
        say(f'base archive after {time.monotonic() - began:.0f} s')
        lab.docker('import', archive, BASE)


def make_all(targets, say):
    """Builds the images, and returns what is wrong with them; the engine stands in the host's network meanwhile."""
    engine = lab.Engine()
    engine.start(in_lab=False)
    try:
        began = time.monotonic()
        import_base(say)
        for target in targets:
            lab.docker('build', '--network', 'host', '-q', '-f', 'deploy/Containerfile', '--target', target, '--build-arg', 'STAGE=prebuilt', '-t',
                       f'weft-{target}:latest', '.', cwd=lab.TOP, timeout=900)
            say(f'image weft-{target}: {size_mb(target)} MB, after {time.monotonic() - began:.0f} s')
        return broken(targets)
    finally:
        engine.stop()


def size_mb(target):
    return int(lab.docker('image', 'inspect', '-f', '{{.Size}}', f'weft-{target}:latest')) // 1_000_000


def broken(targets):
    """What is wrong with the images: size, user, or a program that does not start."""
    wrong = [f'image weft-{target} has {size_mb(target)} MB, at most {most} are good' for target, most in LIMITS_MB.items()
             if target in targets and size_mb(target) > most]
    for target in targets:
        user = lab.docker('image', 'inspect', '-f', '{{.Config.User}}', f'weft-{target}:latest').strip()
        if user != f'{lab.USER}:{lab.USER}':
            wrong.append(f'image weft-{target} runs as user {user!r}')
    return wrong
