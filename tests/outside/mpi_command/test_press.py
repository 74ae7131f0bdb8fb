"""The answers of roughcontact-mpi: those of roughcontact, and the same for every number of ranks."""
import ranks
from ranks import PRESS, RanksTest, np, rough


class Press(RanksTest):
    def test_every_number_of_ranks_writes_the_same_bytes(self):
        z = rough()
        z[70, 3] = np.nan
        self.npy(z)
        for boundary in 'free', 'periodic':
            for count in 1, 2, 3, 5:
                self.run_ranks(count, 'surface.npy', *PRESS, '--boundary', boundary, '--missing', 'exclude', '--pressure', '1e5,1e6,2e5',
                               '--out', f'{boundary}{count}')
                self.assert_same(f'{boundary}1', f'{boundary}{count}')
            self.assertTrue(np.isnan(np.load(self.folder / f'{boundary}5' / 'gap-1.npy')[70, 3]))

    def test_float32_in_any_byte_order_is_read_like_float64(self):
        z = rough().astype(np.float32)
        self.npy(z.astype(np.float64))
        self.npy(z, 'single.npy')
        self.npy(z.astype('>f4'), 'turned.npy')
        for name in 'surface', 'single', 'turned':
            self.run_ranks(2, f'{name}.npy', *PRESS, '--approach', '1e-7', '--out', name)
            self.assertEqual((self.folder / name / 'pressure-1.npy').read_bytes(), (self.folder / 'surface' / 'pressure-1.npy').read_bytes())

    def test_rank_0_alone_prints(self):
        self.npy(rough())
        done = self.run_ranks(3, 'surface.npy', *PRESS, '--approach', '1e-7,2e-7')
        self.assertEqual(done.stdout.count('surface surface.npy, 64 x 96 points'), 1)
        self.assertEqual(done.stdout.count('RC_OK'), 2)
        self.assertEqual(self.run_ranks(2, '--help').stdout.count('Usage'), 1)


if __name__ == '__main__':
    ranks.main()
