"""Random numbers that are the same everywhere: the Mersenne twister of 64 bits (Nishimura 2000), as std::mt19937_64 seeds it."""
import numpy as np

SIZE, HALF = 312, 156
UPPER, LOWER = np.uint64(0xffffffff80000000), np.uint64(0x7fffffff)
MATRIX = np.uint64(0xb5026f5aa96619e9)


class Draw:
    def __init__(self, seed):
        state = [seed]
        for i in range(1, SIZE):
            state.append((6364136223846793005 * (state[-1] ^ (state[-1] >> 62)) + i) & 0xffffffffffffffff)
        self.state, self.numbers = np.array(state, np.uint64), iter(())

    def next_block(self):
        """The next numbers on [0, 1)."""
        x = self.state
        for part, other in ((slice(0, HALF), slice(HALF, SIZE)), (slice(HALF, SIZE), slice(0, HALF))):
            y = (x[part] & UPPER) | (np.append(x, x[0])[part.start + 1:part.stop + 1] & LOWER)
            x[part] = x[other] ^ (y >> np.uint64(1)) ^ np.where(y & np.uint64(1), MATRIX, np.uint64(0))
        z = x ^ ((x >> np.uint64(29)) & np.uint64(0x5555555555555555))
        z ^= (z << np.uint64(17)) & np.uint64(0x71d67fffeda60000)
        z ^= (z << np.uint64(37)) & np.uint64(0xfff7eee000000000)
        z ^= z >> np.uint64(43)
        return np.ldexp((z >> np.uint64(11)).astype(float), -53).tolist()

    def uniform(self, low=0.0, high=1.0):
        for number in self.numbers:
            return low + (high - low) * number
        self.numbers = iter(self.next_block())
        return self.uniform(low, high)

    def power_of_ten(self, low, high):
        return 10**self.uniform(low, high)

    def integer(self, low, high):
        return low + int(self.uniform(0, high - low + 1))

    def chance(self, share):
        return self.uniform() < share
