"""roughcontact-bench: time, memory and accuracy of the library, through its public interface alone."""
import argparse
import json
import signal
import subprocess
import sys

import roughcontact

import batch
import dilute
import documents
import failures
import goals
import histories
import limits
import paper
import peers
import physics
import processor_time
import repeated
import scaling
import speed_accuracy
import stiffness
import trial
from case import Failure
from options import THREADS
from store import provenance

QUESTIONS = (scaling.QUESTION, limits.PRODUCTS, limits.LIMITS, repeated.BUSY, repeated.DETERMINISTIC, speed_accuracy.QUESTION, goals.QUESTION,
             trial.QUESTION, histories.QUESTION, failures.QUESTION, batch.QUESTION, dilute.QUESTION, stiffness.QUESTION, paper.QUESTION,
             physics.QUESTION, peers.QUESTION, processor_time.QUESTION, documents.QUESTION)


def main():
    parser = argparse.ArgumentParser(prog='roughcontact-bench', description='Benchmarks of the roughcontact library')
    commands = parser.add_subparsers(required=True, metavar='COMMAND')
    for question in QUESTIONS:
        question.add_to(commands)
    commands.add_parser('provenance', help='what is measured here: library, compiler, machine, as JSON')
    given = parser.parse_args()
    if 'question' in given:
        given.question.answer(given)
    else:
        print(json.dumps(provenance(THREADS), indent=1))


if __name__ == '__main__':
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the package then calls the library on this thread: no hand-over counts as time
    try:
        main()
    except (Failure, roughcontact.RoughContactError, subprocess.CalledProcessError, OSError) as error:
        sys.exit(f'roughcontact-bench: {error}')
