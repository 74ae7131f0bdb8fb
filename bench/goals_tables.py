"""Tables of goal.json: how often option accuracy kept its goal, and on which grids."""
from samples import median
from speed_accuracy_rows import TITLES
from store import fits
from tables import table

CONTROLS = {'displacement': 'approach', 'load': 'load'}


def rows_of(document, **values):
    return [row for row in document['rows'] if fits(row, values)]


def goals_of(document):
    return sorted({row['goal'] for row in document['rows']}, reverse=True)


def percent(goal):
    return f'{100 * goal:g} %'


def kept_table(document):
    lines = []
    for quantity in ('load', 'area'):
        for control, prescribed in CONTROLS.items():
            for goal in goals_of(document):
                rows = rows_of(document, quantity=quantity, control=control, goal=goal)
                if not rows:
                    continue
                coarser = [row for row in rows if row['status'] == 'RC_WITHIN_GOAL']
                slack = [row['estimate'] / row['error'] for row in coarser if row['error'] > 0]
                ratio = [row['whole_seconds'] / row['seconds'] for row in coarser]
                other = [row['seconds'] / row['whole_seconds'] for row in rows if row['status'] != 'RC_WITHIN_GOAL']
                lines.append([quantity, prescribed, percent(goal), str(len(rows)), str(sum(row['error'] <= goal for row in rows)),
                              str(len(coarser)), f'{median(slack):.1f}' if slack else '', f'{median(ratio):.1f}' if ratio else '',
                              f'{median(other):.2f}' if other else ''])
    return table(['goal of', 'prescribed', 'goal', 'runs', 'within it', 'on a coarser grid', 'there: estimate over error',
                  'whole grid\'s time over this', 'otherwise: time over the whole grid\'s alone'], lines)


def grid_used(rows):
    """Points a side of the grid that was solved, as parts of the given ones: median of the runs."""
    factor = median([row['points'] / row['model'] for row in rows])
    return 'all' if factor < 1.5 else f'1/{factor:.0f}'


def grids_table(document):
    """For a goal of the load under a given approach."""
    lines = []
    goals = goals_of(document)
    for scene, title in TITLES.items():
        rows = rows_of(document, scene=scene, quantity='load', control='displacement')
        if not rows:
            continue
        cells = []
        for goal in goals:
            found = [f'{contact:g} %: {grid_used([row for row in rows if row["goal"] == goal and row["contact"] == contact])}'
                     for contact in sorted({row['contact'] for row in rows})]
            cells.append(', '.join(found))
        lines.append([f'{title}, {rows[0]["points"]}²', *cells])
    return table(['scene', *[f'within {percent(goal)}' for goal in goals]], lines)


def sentence(document):
    rows = document['rows']
    within = sum(row['error'] <= row['goal'] for row in rows)
    surfaces = len({(row['scene'], row['seed']) for row in rows})
    ratio = [row['whole_seconds'] / row['seconds'] for row in rows if row['status'] == 'RC_WITHIN_GOAL']
    saved = (f' The whole grid, solved to a hundredth of the goal, took {median(ratio):.2f} times the time in the median of the '
             f'{len(ratio)} that did without.' if ratio else '')
    return (f'{within} of {len(rows)} runs ({100 * within / len(rows):.2f} %) over {surfaces} surfaces were within their goal of the '
            f'answer on the whole grid.{saved}')


def goal_section(document):
    return '\n\n'.join([sentence(document), kept_table(document).strip(), 'Grids that were solved, in points a side over those given, '
                        'for a goal of the load under a given approach; by contact:', grids_table(document).strip()])
