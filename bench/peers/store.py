"""The results file: groups of runs by case and code, written whole after every group, so that an interrupted run goes on."""
import json
import os


class Store:
    def __init__(self, file, fresh):
        self.file = file
        self.document = {'benchmark': 'peers', 'provenance': {}, 'codes': {}, 'calibration': {}, 'cases': {}, 'groups': []}
        if os.path.exists(file):
            with open(file) as text:
                old = json.load(text)
            if fresh:
                self.document['cases'] = old['cases']  # the loads found for the surfaces: no measurement
            else:
                self.document = old

    def save(self):
        os.makedirs(os.path.dirname(os.path.abspath(self.file)), exist_ok=True)
        with open(self.file + '.part', 'w') as out:
            json.dump(self.document, out, indent=1)
            out.write('\n')
        os.replace(self.file + '.part', self.file)

    def group(self, case, code):
        return next((group for group in self.document['groups'] if (group['case'], group['code']) == (case, code)), None)

    def put(self, group):
        self.document['groups'] = [old for old in self.document['groups']
                                   if (old['case'], old['code']) != (group['case'], group['code'])] + [group]
        self.save()


def total(run):
    return run['setup_seconds'] + run['solve_seconds']


def best(group, level):
    """The fastest run that is certified at a level, or None."""
    met = [run for run in group['runs'] if run.get('residual') is not None and run['residual'] <= level]
    return min(met, key=total) if met else None


def growth(run):
    return run['peak_bytes'] - run['start_bytes']
