// How an elastic layer on a base answers a wave of normal pressure without shear.
#pragma once

namespace rc::kernel::layer {

struct Layer {
  double thickness;           // [length]
  double modulus;             // E1/(1 - nu1^2) over the modulus of the system, which is E2/(1 - nu2^2) of a half-space below
  double poisson;             // nu1
  double base_poisson = 0.3;  // nu2, of a half-space below to which the layer is bonded
  bool rigid_base = false;
  bool bonded = true;  // else the layer slides on the base without friction; it never leaves it
};

// A pressure cos(q.x) deflects the surface by 2/(E* |q|) f(|q| t) times itself. With s = |q| t, m = E1*/E2*, e = exp(-2 s),
// a = (1 - e)^2 - 4 s^2 e, b = 1 - e^2 - 4 s e, c = 1 - e^2 + 4 s e, k = 3 - 4 nu and mu = G1/G2:
//   half-space, bonded      Burmister (1945); O'Sullivan & King, ASME Journal of Tribology 110 (1988) 235, in a form without
//                           cancellation:
//                           f = 1/m (mu (1+k1) (1+k2) + L K b + 4 K s e (1 + 2 mu k2 - k1)) /
//                                   (K (1 + mu k2) a + (1+k1) (1 + k1 + (1-e) (L + K e))),  K = mu - 1, L = mu k2 - k1
//   half-space, sliding     f = ((1-e)^2/m + c) / (c + m a)
//   rigid base, bonded      f = 1/m (k1 b + 4 (k1-1) s e) / (k1 (1 + e^2) + 4 s^2 e + (1 + k1^2) e)
//   rigid base, sliding     f = 1/m (1-e)^2 / c;  K. L. Johnson, Contact Mechanics (1985), section 5.8.
// f goes to 1/m at short waves. At long ones it goes to 1 on a half-space, and to 0 on a rigid base.
class Response {
 public:
  explicit Response(const Layer& layer);

  template <class Number> Number f(Number s) const;  // double or std::complex<double>
  template <class Number> Number beyond(Number s) const { return f(s) - short_waves(); }
  double short_waves() const { return 1 / layer_.modulus; }
  double long_waves() const { return layer_.rigid_base ? 0 : 1; }
  // f has no singularity nearer to 0 than this, in the first quadrant and some way beyond the imaginary axis; poles of bonded
  // soft layers lie on that axis or next to it. The pole of a stiff layer is the plate's, (6/m)^(1/3). Others are at about 2.3,
  // those of bonded layers at 1.4 - .9 nu1. tests/unit/kernel/layer/layer_zeros.py counts the zeros of the denominators for m =
  // 1e-6 .. 1e6 and several Poisson's ratios: none is nearer than .7 of the smaller of the two.
  double reach() const;

  const Layer& layer() const { return layer_; }

 private:
  Layer layer_;
  double mu_, k1_, k2_;
};

}  // namespace rc::kernel::layer
