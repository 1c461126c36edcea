"""network.png of a demo with --traffic: who drove where by itself, over the map that one of them taught."""
import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

from judging import contact, picture  # noqa: E402

COLOURS = ('#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9')      # Okabe & Ito 2008
APART_M = 0.05      # paths are drawn beside each other, so that robots that drove one way are seen


def draw_paths(axes, records, by_itself):
    for number, robot in enumerate(sorted(records.truth)):
        colour, off = COLOURS[number % len(COLOURS)], (number - (len(records.truth) - 1) / 2) * APART_M
        poses = [pose for frame, pose in sorted(records.truth[robot].items()) if frame in by_itself[robot]]
        if not poses:
            continue
        axes.plot([p[0] + off for p in poses], [p[1] + off for p in poses], '-', color=colour, linewidth=1.3, zorder=6,
                  label=f'driven by {robot} ({APART_M:g} m beside the next)' if not number else f'driven by {robot}')
        axes.add_patch(plt.Circle(poses[-1][:2], contact.radius_m(records.site), facecolor=colour, alpha=0.45, zorder=7))
        axes.annotate(robot, poses[-1][:2], fontsize=8, ha='center', va='center', zorder=9)


def draw_ends(axes, records, goals):
    """Draws the places that goals led to, with how many of those sent there succeeded."""
    sent = {}
    for goal in goals:
        sent.setdefault(goal['to'], []).append(goal)
    for label, place in records.network.get('labels', {}).items():
        x, y, _ = records.true_place(place)
        rows = sent.get(label, [])
        text = label + (f": {sum(row['state'] == 'succeeded' for row in rows)} of {len(rows)}" if rows else '')
        axes.plot(x, y, '*', color='#111111', markersize=9, zorder=8)
        axes.annotate(text, (x, y), xytext=(0, 14), textcoords='offset points', fontsize=9, ha='center', zorder=8,
                      bbox=dict(boxstyle='round,pad=0.2', facecolor='white', edgecolor='#555555', linewidth=0.5))
    axes.plot([], [], '*', color='#111111', markersize=9, linestyle='none', label='goal: how many sent there succeeded')


def draw_events(axes, records):
    killed, closed = records.traffic.get('killed'), records.traffic.get('closed')
    if killed and records.truth.get(killed['robot']):
        x, y, _ = records.truth[killed['robot']][max(records.truth[killed['robot']])]
        axes.plot(x, y, 'x', color='#cc0000', markersize=16, markeredgewidth=3, zorder=10, linestyle='none',
                  label=f"{killed['robot']}: its agent was killed here")
    if closed:
        a, b = records.true_place(closed['a']), records.true_place(closed['b'])
        axes.plot([a[0], b[0]], [a[1], b[1]], '-', color='#cc0000', linewidth=7, zorder=10, solid_capstyle='butt',
                  label='edge that was closed for a while')


def draw(records, by_itself, goals, path):
    figure, axes = plt.subplots(figsize=(13, 7.5))
    picture.draw_site(axes, records.site)
    poses = [records.true_place(place['id']) for place in records.places.values()]
    axes.plot([p[0] for p in poses], [p[1] for p in poses], '.', color='#777777', markersize=4, zorder=4,
              label=f'taught: {len(poses)} places')
    draw_paths(axes, records, by_itself)
    draw_ends(axes, records, goals)
    draw_events(axes, records)
    picture.finish(figure, axes, f'Where {len(records.truth)} robots drove by themselves: true positions, by the simulation', path)
