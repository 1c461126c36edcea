"""floor-attempts.png: recall over distance and heading, and why attempts were refused."""
import collections

from sheet import PALETTE, QUIET, colour, dress, panels, read_json, read_rows, save

FEWEST_IN_BIN = 5       # fewer attempts say nothing
NAMED_REASONS = 4
RIGHT_ANSWER = ('near', 'near, guided')
NO_ANSWER = ('elsewhere', 'look-alike', 'elsewhere, guided', 'mirrored', 'other floor')


def recalls_of(document, rows):
    """By floor and sort of attempt the counts of each bin, summed over the lights and seeds that the CSV file has."""
    asked = {(row['floor'], row['light'], int(row['seed'])) for row in rows}
    sums = collections.defaultdict(lambda: collections.defaultdict(collections.Counter))
    for row in document['rows']:
        if (row['floor'], row['light'], row['seed']) not in asked:
            continue
        for sort, bins in row['recall'].items():
            for name, counts in bins.items():
                sums[row['floor'], sort][name].update(dict(enumerate(counts)))
    return sums


def plot_recall(axes, recalls, kinds, sort, by, bin_size):
    for i, kind in enumerate(kinds):
        bins = recalls[kind, sort]
        tried, right = bins[f'tried_by_{by}'], bins[f'right_by_{by}']
        some = [k for k in sorted(tried) if tried[k] >= FEWEST_IN_BIN]
        axes.plot([bin_size * (k + 0.5) for k in some], [right[k] / tried[k] for k in some], color=colour(i), linewidth=1.8, label=kind)
    axes.set_ylim(0.0, 1.03)
    axes.set_xlim(left=0.0)
    if by == 'heading':
        axes.set_xlim(0.0, 180.0)
        axes.set_xticks(range(0, 181, 30))
    x = 'middles of what both see apart, m' if by == 'metres' else 'headings differ by, degrees'
    dress(axes, f'{sort}, by {"distance" if by == "metres" else "heading"}', x, 'share found')


def plot_refusals(axes, rows, kinds, sorts, title):
    """A bar a floor: shares of all its attempts that were refused, by reason."""
    some = [row for row in rows if row['attempt'] in sorts]
    counts, reasons = collections.defaultdict(collections.Counter), collections.Counter()
    for row in some:
        counts[row['floor']][row['outcome']] += int(row['count'])
        if row['outcome'] not in ('right', 'WRONG'):
            reasons[row['outcome']] += int(row['count'])
    named = [reason for reason, _ in reasons.most_common(NAMED_REASONS)]
    bottom = [0.0] * len(kinds)
    for i, reason in enumerate([*named, 'others']):
        own = [reason] if reason != 'others' else [other for other in reasons if other not in named]
        shares = [sum(counts[kind][name] for name in own) / max(1, sum(counts[kind].values())) for kind in kinds]
        if any(shares):
            axes.bar(range(len(kinds)), shares, 0.6, bottom, color=PALETTE[i] if reason != 'others' else QUIET, label=reason)
        bottom = [below + share for below, share in zip(bottom, shares)]
    axes.set_xticks(range(len(kinds)), kinds, rotation=20, ha='right')
    axes.set_xlim(-0.6, len(kinds) - 0.4)
    axes.set_ylim(0.0, 1.03)
    axes.grid(axis='x', visible=False)
    dress(axes, title, 'floor', 'share of the attempts refused')


def draw(folder):
    rows, document = read_rows(folder / 'attempts.csv'), read_json(folder / 'attempts.json')
    study = read_json(folder / 'series' / 'floor-attempts.json')
    recalls = recalls_of(document, rows)
    kinds = list(dict.fromkeys(row['floor'] for row in rows))
    figure, grid = panels('Attempts to relate views with places', study['about'], 6, 2)
    for row, sort in enumerate(RIGHT_ANSWER):
        plot_recall(grid[2 * row], recalls, kinds, sort, 'metres', study['bin_m'])
        plot_recall(grid[2 * row + 1], recalls, kinds, sort, 'heading', study['bin_deg'])
    plot_refusals(grid[4], rows, kinds, RIGHT_ANSWER, 'refused though there is a right answer')
    plot_refusals(grid[5], rows, kinds, NO_ANSWER, 'refused where there is none')
    yield save(figure, folder, 'floor-attempts.png')
