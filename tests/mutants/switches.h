// Operators that change when RC_CHANGE names them: scripts/mutants.py puts all mutants of a file into one program. `a + b`
// becomes `a + At<7, sub>{} + b`, which binds as before.
#pragma once
#pragma GCC system_header  // warnings about what it makes of a change mean nothing

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace rc_switch {

inline int chosen() {
  static const int number = std::getenv("RC_CHANGE") ? std::atoi(std::getenv("RC_CHANGE")) : 0;
  return number;
}
constexpr bool on(int number) { return !std::is_constant_evaluated() && chosen() == number; }

enum Kind { lt, le, gt, ge, eq, ne, add, sub, mul, div, first };

// Numbers of changes, each followed by its kind.
template <int... changes> struct At {};
template <class A, int... changes> struct Begun { A&& a; };
template <class B, int... changes> struct Assigned { B&& b; };

template <int kind> struct Is {};
#define RC_KIND(kind, text) \
  template <class A, class B> constexpr auto changed(Is<kind>, A&& a, B&& b)->decltype(text) { return text; }
RC_KIND(lt, a < b)
RC_KIND(le, a <= b)
RC_KIND(gt, a > b)
RC_KIND(ge, a >= b)
RC_KIND(eq, a == b)
RC_KIND(ne, a != b)
RC_KIND(add, a + b)
RC_KIND(sub, a - b)
RC_KIND(mul, a* b)
RC_KIND(div, a / b)
RC_KIND(first, a)
#undef RC_KIND

template <class R, class A, class B, class Plain> constexpr R result(At<>, A&& a, B&& b, Plain plain) { return plain(a, b); }
template <class R, int number, int kind, int... more, class A, class B, class Plain>
constexpr R result(At<number, kind, more...>, A&& a, B&& b, Plain plain) {
  if constexpr (requires { static_cast<R>(changed(Is<kind>{}, a, b)); })
    if (on(number)) return static_cast<R>(changed(Is<kind>{}, a, b));
  return result<R>(At<more...>{}, a, b, plain);
}

#define RC_SWITCHED(op)                                                                                           \
  template <class A, int... changes> constexpr Begun<A, changes...> operator op(A&& a, At<changes...>) {          \
    return {std::forward<A>(a)};                                                                                  \
  }                                                                                                               \
  template <class A, int... changes, class B> constexpr auto operator op(Begun<A, changes...> begun, B&& b) {     \
    return result<decltype(begun.a op b)>(At<changes...>{}, begun.a, b, [](auto& x, auto& y) { return x op y; }); \
  }
RC_SWITCHED(<)
RC_SWITCHED(<=)
RC_SWITCHED(>)
RC_SWITCHED(>=)
RC_SWITCHED(==)
RC_SWITCHED(!=)
RC_SWITCHED(+)
RC_SWITCHED(-)
RC_SWITCHED(*)
RC_SWITCHED(/)
#undef RC_SWITCHED

#define RC_SWITCHED(op, other)                                                                              \
  template <int... changes, class B> constexpr Assigned<B, changes...> operator op(At<changes...>, B&& b) { \
    return {std::forward<B>(b)};                                                                            \
  }                                                                                                         \
  template <class A, class B, int number> constexpr A& operator op(A& a, Assigned<B, number> assigned) {    \
    if (on(number)) return a other assigned.b;                                                              \
    return a op assigned.b;                                                                                 \
  }
RC_SWITCHED(+=, -=)
RC_SWITCHED(-=, +=)
RC_SWITCHED(*=, /=)
RC_SWITCHED(/=, *=)
#undef RC_SWITCHED

// `-x` and `!x` become `minus<7>{}->*x`.
template <int number> struct minus {};
template <int number, class A> constexpr auto operator->*(minus<number>, const A& a) { return on(number) ? decltype(-a)(a) : -a; }
template <int number> struct negation {};
template <int number, class A> constexpr bool operator->*(negation<number>, const A& a) {
  return on(number) ? static_cast<bool>(a) : !a;
}

// `a && b` becomes `both<7>(a, [&] { return b; })`.
template <int number, class B> constexpr bool both(bool a, B b) { return on(number) ? a || b() : a && b(); }
template <int number, class B> constexpr bool any(bool a, B b) { return on(number) ? a && b() : a || b(); }

template <int number, class A> constexpr A either(A plain, A other) { return on(number) ? other : plain; }
template <int number, class A> constexpr A least(const A& a, const A& b) { return on(number) ? std::max(a, b) : std::min(a, b); }
template <int number, class A> constexpr A least(std::initializer_list<A> all) {
  return on(number) ? std::max(all) : std::min(all);
}
template <int number, class A> constexpr A most(const A& a, const A& b) { return on(number) ? std::min(a, b) : std::max(a, b); }
template <int number, class A> constexpr A most(std::initializer_list<A> all) {
  return on(number) ? std::min(all) : std::max(all);
}
template <int number, class A> auto root(const A& a) { return on(number) ? decltype(std::sqrt(a))(a) : std::sqrt(a); }
template <int number, class A> auto size(const A& a) { return on(number) ? decltype(std::abs(a))(a) : std::abs(a); }

}  // namespace rc_switch
