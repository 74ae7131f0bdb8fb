"""The answers of roughcontact-mpi: those of roughcontact, and the same for every number of ranks."""
import ranks
from ranks import PRESS, RanksTest, np, rough


class Press(RanksTest):
    def test_every_number_of_ranks_writes_the_same_bytes(self):
        self.npy(rough())
        for boundary in 'free', 'periodic':
            for count in 1, 2, 3, 5:
                self.run_ranks(count, 'surface.npy', *PRESS, '--boundary', boundary, '--pressure', '1e5,1e6,2e5', '--out', f'{boundary}{count}')
                self.assert_same(f'{boundary}1', f'{boundary}{count}')

    def test_float32_in_any_byte_order_is_read_like_float64(self):
        z = rough().astype(np.float32)
        self.npy(z.astype(np.float64))
        self.npy(z, 'single.npy')
        self.npy(z.astype('>f4'), 'turned.npy')
        for name in 'surface', 'single', 'turned':
            self.run_ranks(2, f'{name}.npy', *PRESS, '--approach', '1e-7', '--out', name)
            self.assertEqual((self.folder / name / 'pressure-1.npy').read_bytes(), (self.folder / 'surface' / 'pressure-1.npy').read_bytes())

    def test_two_bodies_are_added_and_missing_points_excluded(self):
        z, other = rough(), rough(seed=2)
        z[10, 20] = z[70, 3] = np.nan
        self.npy(z)
        self.npy(other, 'other.npy')
        done = self.run_ranks(3, 'surface.npy', *PRESS, '--approach', '1e-7', code=1)
        self.assertEqual(len(self.messages(done)), 1, done.stderr)
        self.assertIn('2 missing values of 6144, first at ix=20, iy=10', done.stderr)
        self.run_ranks(3, 'surface.npy', *PRESS, '--approach', '1e-7', '--missing', 'exclude', '--against', 'other.npy', '--out', 'ranks')
        self.run_serial('surface.npy', *PRESS, '--approach', '1e-7', '--missing', 'exclude', '--against', 'other.npy', '--out', 'serial')
        one, other = (np.load(self.folder / name / 'pressure-1.npy') for name in ('ranks', 'serial'))
        self.assertLess(abs(one - other).max(), 1e-5 * other.max())
        self.assertEqual(one[10, 20], 0)
        self.assertTrue(np.isnan(np.load(self.folder / 'ranks' / 'gap-1.npy')[70, 3]))

    def test_rank_0_alone_prints(self):
        self.npy(rough())
        done = self.run_ranks(3, 'surface.npy', *PRESS, '--approach', '1e-7,2e-7')
        self.assertEqual(done.stdout.count('surface surface.npy, 64 x 96 points'), 1)
        self.assertEqual(done.stdout.count('RC_OK'), 2)
        self.assertEqual(self.run_ranks(2, '--help').stdout.count('Usage'), 1)


if __name__ == '__main__':
    ranks.main()
