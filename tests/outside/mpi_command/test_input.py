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

    def test_files_that_are_no_grid(self):
        whole, z = (self.folder / self.npy(rough())).read_bytes(), rough()
        infinite = np.where(np.arange(6144).reshape(96, 64) == 5000, np.inf, 0)
        for name, contents, says in (
                ('none', None, 'No such file'), ('text', b'1 2\n3 4\n', 'text.npy: the file does not begin with'),
                ('short', whole[:-8], 'short.npy: the file has 49144 bytes of data, 64 x 96 points of 8 bytes need 49152'),
                ('long', whole + b'8', 'long.npy: the file has 49153 bytes of data'), ('whole', z.astype(np.int32), 'the numbers are integers'),
                ('complex', z.astype(np.complex128), 'data type "<c16" cannot be read'), ('columns', np.asfortranarray(z), 'Fortran order'),
                ('cube', z[None], 'is not (ny, nx)'), ('infinite', infinite, 'the height at ix=8, iy=78 is not finite')):
            if contents is not None:
                (self.file if isinstance(contents, bytes) else lambda file, z: self.npy(z, file))(name + '.npy', contents)
            self.assert_refused(name + '.npy', *PRESS, '--approach', '1e-7', '--out', 'out', says=says)

    def test_arguments(self):
        self.npy(rough())
        for words, says in (('--resume', '--resume needs --out, the folder of the interrupted run'), ('--out out --checkpoint 0', '--checkpoint: "0"'),
                            ('--tolerance 7', 'did you mean "--tol"'), ('--missing fill', 'give reject or exclude'), ('--set nothing=1', 'nothing'),
                            ('--solver nnls', 'with this solver')):
            self.assert_refused('surface.npy', *PRESS, '--load', '1', *words.split(), says=says)

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
