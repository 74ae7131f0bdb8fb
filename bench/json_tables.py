"""Results in JSON, a line a record: lists of records are tables of values below their keys."""
import json
import os


def rounded(value):
    """Seven digits of every number: no measurement has more."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return float(f'{value:.7g}') if isinstance(value, float) else value


MISSING = [[]]  # in a table, where a record lacks the key


def packed(value):
    """A list of records as a table: their keys, then a list of values for each."""
    if not isinstance(value, list) or not value or not all(isinstance(row, dict) for row in value):
        return value
    keys = list(dict.fromkeys(key for row in value for key in row))
    return [keys, *([row.get(key, MISSING) for key in keys] for row in value)]


def unpacked(value):
    if not isinstance(value, list) or not value or not all(isinstance(row, list) for row in value):
        return value
    return [{key: each for key, each in zip(value[0], row) if each != MISSING} for row in value[1:]]


def lines(document):
    """JSON with a line for each record of a list and each entry of an object."""
    def compact(value):
        return json.dumps(value, ensure_ascii=False, separators=(',', ':'))

    def block(value):
        if not value or not isinstance(value, (dict, list)):
            return compact(value)
        brackets, each = ('{}', (f'{compact(key)}:{compact(entry)}' for key, entry in value.items())) if isinstance(value, dict) else ('[]', map(compact, value))
        return brackets[0] + '\n' + ',\n'.join(each) + '\n' + brackets[1]
    return '{\n' + ',\n'.join(f'{compact(key)}:{block(packed(value))}' for key, value in document.items()) + '\n}\n'


def read(file):
    with open(file, encoding='utf-8') as text:
        return {key: unpacked(value) for key, value in json.load(text).items()}


def load(folder, name):
    """The results of a benchmark; {} where it has not run."""
    file = os.path.join(folder, name + '.json')
    return read(file) if os.path.exists(file) else {}
