"""Wrong input of roughcontact-mpi: one message of rank 0, code 1 everywhere, nothing written, and no rank waits for another."""
import ranks
from ranks import PRESS, RanksTest, np, rough


class Input(RanksTest):
    def assert_refused(self, *arguments, says, count=3):
        before = sorted(path.name for path in self.folder.iterdir())
        done = self.run_ranks(count, *arguments, code=1)
        self.assertEqual(len(self.messages(done)), 1, done.stderr)
        self.assertIn(says, self.messages(done)[0])
        self.assertEqual(before, sorted(path.name for path in self.folder.iterdir()))

    def press(self, name):
        return [name, *PRESS, '--approach', '1e-7', '--out', 'out']

    def test_files_that_are_no_grid(self):
        self.assert_refused(*self.press('none.npy'), says='No such file')
        (self.folder / 'text.npy').write_text('1 2\n3 4\n')
        self.assert_refused(*self.press('text.npy'), says='text.npy: the file does not begin with')
        whole = (self.folder / self.npy(rough())).read_bytes()
        (self.folder / 'short.npy').write_bytes(whole[:-8])
        self.assert_refused(*self.press('short.npy'), says='short.npy: the file has 49144 bytes of data, 64 x 96 points of 8 bytes need 49152')
        (self.folder / 'long.npy').write_bytes(whole + b'8')
        self.assert_refused(*self.press('long.npy'), says='long.npy: the file has 49153 bytes of data')
        self.npy(rough().astype(np.int32), 'whole.npy')
        self.assert_refused(*self.press('whole.npy'), says='the numbers are integers')
        self.npy(rough().astype(np.complex128), 'complex.npy')
        self.assert_refused(*self.press('complex.npy'), says='data type "<c16" cannot be read')
        self.npy(np.asfortranarray(rough()), 'columns.npy')
        self.assert_refused(*self.press('columns.npy'), says='Fortran order')
        self.npy(rough()[None], 'cube.npy')
        self.assert_refused(*self.press('cube.npy'), says='is not (ny, nx)')
        self.npy(np.where(np.arange(6144).reshape(96, 64) == 5000, np.inf, 0), 'infinite.npy')
        self.assert_refused(*self.press('infinite.npy'), says='the height at ix=8, iy=78 is not finite')

    def test_arguments(self):
        self.npy(rough())
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--resume', says='--resume needs --out, the folder of the interrupted run')
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--out', 'out', '--checkpoint', '0', says='--checkpoint: "0"')
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--tolerance', '7', says='did you mean "--tol"')
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--missing', 'fill', says='give reject or exclude')
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--set', 'nothing=1', says='nothing')
        self.assert_refused('surface.npy', *PRESS, '--load', '1', '--solver', 'nnls', says='with this solver')

    def test_folders_that_cannot_be_used(self):
        self.npy(rough())
        (self.folder / 'file').write_text('')
        self.assert_refused('surface.npy', *PRESS, '--approach', '1e-7', '--out', 'file', says='file')
        (self.folder / 'taken').mkdir()
        (self.folder / 'taken' / 'pressure-1.npy').write_text('mine')
        self.assert_refused('surface.npy', *PRESS, '--approach', '1e-7', '--out', 'taken', says='belongs to no earlier run')
        self.assertEqual((self.folder / 'taken' / 'pressure-1.npy').read_text(), 'mine')


if __name__ == '__main__':
    ranks.main()
