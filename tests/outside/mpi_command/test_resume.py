"""A run of roughcontact-mpi that was killed goes on: after its complete steps, and from a checkpoint in the middle of a step."""
import json
import os
import signal
import subprocess
import time
from pathlib import Path

import ranks
from ranks import ENVIRONMENT, PRESS, RanksTest, np, on_ranks, rough, said

HISTORY = ['surface.npy', *PRESS, '--approach', '1e-7,2e-7,1.5e-7,3e-7,5e-8', '--quiet']


class Resume(RanksTest):
    def kill_when(self, condition, count, *arguments):
        """Kills one rank as soon as the condition holds; the program must end by itself then."""
        running = subprocess.Popen(on_ranks(count, *arguments), cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        end = time.monotonic() + 200
        while not condition() and running.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        rank = next((pid for pid in self.children(running.pid)), None)
        if rank:
            os.kill(rank, signal.SIGKILL)
        return running.wait(timeout=100)

    @staticmethod
    def children(parent):
        for folder in Path('/proc').glob('[0-9]*'):
            try:
                if (folder / 'stat').read_text().rsplit(')', 1)[1].split()[1] == str(parent):
                    yield int(folder.name)
            except OSError:
                pass

    def test_a_killed_run_goes_on(self):
        self.npy(rough(256, 256))
        self.run_ranks(2, *HISTORY, '--out', 'whole')
        second = self.folder / 'cut' / 'pressure-2.npy'
        self.assertNotEqual(self.kill_when(second.exists, 3, *HISTORY, '--out', 'cut'), 0)
        self.assertLess(len(said(self.folder / 'cut')['steps']), 5)
        self.run_ranks(2, *HISTORY, '--out', 'cut', '--resume')
        self.assert_same('whole', 'cut')

    def test_a_run_killed_within_a_step_goes_on_from_its_checkpoint(self):
        self.npy(rough(256, 256))
        once = ['surface.npy', *PRESS, '--approach', '2e-7', '--tol', '1e-10', '--checkpoint', '3', '--quiet']
        self.run_ranks(2, *once, '--out', 'whole')
        self.assertEqual([path.name for path in (self.folder / 'whole').glob('checkpoint*')], [])
        note = self.folder / 'cut' / 'checkpoint.json'
        self.assertNotEqual(self.kill_when(note.exists, 2, *once, '--out', 'cut'), 0)
        at = json.loads(note.read_text())['iterations']
        done = self.run_ranks(2, *once, '--out', 'cut', '--resume')
        self.assertIn(f'step 1 continues after {at} iterations', done.stderr)
        one, other = (np.load(self.folder / name / 'pressure-1.npy') for name in ('whole', 'cut'))
        self.assertLess(abs(one - other).max(), 1e-8 * one.max())
        ours, theirs = (said(self.folder / name)['steps'][0] for name in ('whole', 'cut'))
        self.assertEqual(ours['iterations'], theirs['iterations'])

    def test_another_problem_is_refused(self):
        self.npy(rough())
        self.run_ranks(2, *HISTORY, '--out', 'out')
        self.npy(rough(seed=2))
        done = self.run_ranks(2, *HISTORY, '--out', 'out', '--resume', code=1)
        self.assertIn('is of a run with checksum', done.stderr)
        self.assertEqual(len(self.messages(done)), 1)


if __name__ == '__main__':
    ranks.main()
