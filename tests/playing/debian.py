"""A small Debian 12 of our own, from the archive that this machine's own settings name."""
import hashlib
import pathlib
import subprocess

from playing.processes import Trouble, die_with_parent

SOURCES = ('/etc/apt/sources.list.d/debian.sources', '/etc/apt/sources.list')
# What Debian's own image for containers leaves out, too.
LEFT_OUT = ('doc', 'man', 'locale', 'info')


def source():
    """The file with the archives of Debian."""
    return next((path for path in SOURCES if pathlib.Path(path).exists()), SOURCES[0])


def release_key(*more):
    """Sixteen digits that change with the release of the archive, its address, or one of `more`."""
    release = b''.join(path.read_bytes() for path in sorted(pathlib.Path('/var/lib/apt/lists').glob('*bookworm_InRelease')))
    return hashlib.sha256(release + pathlib.Path(source()).read_bytes() + '\n'.join(more).encode()).hexdigest()[:16]


def make(archive, include=(), flags=()):
    """Writes it to `archive`, a new tar file, with these packages besides; `flags` are mmdebstrap's."""
    left_out = [f'--dpkgopt=path-exclude=/usr/share/{folder}/*' for folder in LEFT_OUT]
    with open(archive, 'wb') as out:
        done = subprocess.run(['mmdebstrap', '--quiet', '--variant=apt', '--format=tar', *left_out, '--dpkgopt=force-unsafe-io',
                               '--aptopt=APT::Install-Recommends "0"', f"--include={','.join(('usr-is-merged', *include))}",
                               '--hook-dir=/usr/share/mmdebstrap/hooks/merged-usr', *flags, 'bookworm', '-', source()], stdout=out, stderr=subprocess.PIPE,
                              text=True, timeout=1500, preexec_fn=die_with_parent)
    if done.returncode:
        raise Trouble(f'mmdebstrap: {done.stderr.strip()[-300:]}')
