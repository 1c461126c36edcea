"""What a run measured, for people and for docs/results/network.md. Nothing of it is asserted."""
import json

import lab


def write(numbers):
    if not numbers:
        return
    (lab.WORK / 'network.json').write_text(json.dumps(numbers, indent=1) + '\n')
    print('--- measured')
    for name, value in numbers.items():
        print(f'    {name}: {value}')
