"""The records that a demo leaves for its judge (docs/formats/records.md)."""
import json
import shutil
import subprocess

RECORDS = ('truth.jsonl', 'fixes.jsonl', 'drives.jsonl', 'acks.jsonl', 'goals.jsonl', 'processes.jsonl', 'experiences.jsonl', 'network.json',
           'network.png', 'map.svg', 'summary.json', 'site.toml', 'floor.pgm', 'versions', 'traffic.json', 'whys.jsonl')


def write_lines(path, rows):
    path.write_text(''.join(json.dumps(row) + '\n' for row in rows))


def gather(fleet, out, site_file):
    fleet.weft('map', 'export', out / 'network.json')
    fleet.weft('map', 'draw', out / 'map.svg')
    write_lines(out / 'goals.jsonl', fleet.weft('goal', 'list')['goals'])
    rows = [dict(name='server', vendor=fleet.weft('map', 'info')['vendor'], peer=None, peak_memory_mb=fleet.server.peak_memory_mb)]
    # It exits with 1 when it finds something wrong, such as a robot that was killed.
    client = fleet.weft('doctor', good=(0, 1))['client']
    for row in fleet.weft('robots')['robots']:
        rows.append(dict(name=row['name'], vendor=row['vendor'], peer=row['id'],
                         peak_memory_mb=fleet.robots[row['name']].peak_memory_mb))
    rows.append(dict(name='cli', vendor=client['vendor'], peer=None, peak_memory_mb=None))
    rows = [dict(row, asked=fleet.vendors[row['name']]) for row in rows]
    write_lines(out / 'processes.jsonl', rows)
    write_lines(out / 'experiences.jsonl', [dict(experience=id, name=name) for id, name in fleet.experiences.items()])
    shutil.copy(site_file, out / 'site.toml')
    photographs = ['--floors', fleet.options.floors] if fleet.options.floors else []
    subprocess.run([fleet.bin / 'sim-floor', site_file, out / 'floor.pgm', *photographs], check=True)
    programs = ('weft', 'weft-server', 'weft-agent-sim')
    (out / 'versions').write_text(''.join(
        subprocess.run([fleet.bin / program, '--version'], capture_output=True, text=True).stdout for program in programs))
