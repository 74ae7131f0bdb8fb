// H of a half-space grid with free boundaries, for a contact that is small against the grid.
#pragma once

#include <cstdint>
#include <optional>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "failure.h"
#include "product.h"
#include "tiles.h"

namespace rc_split {

class Operator {
 public:
  static constexpr roughcontact::Component component = rc_split::component;

  Operator(const rc_host* host, const rc_operator_spec& spec);

  static void score(const rc_facts&, rc_estimate&);
  const rc_host* host() const { return host_; }
  std::int64_t modelled() const { return modelled_; }

  void bind(const rc_domain& domain);
  void apply(const double* x, double* y);
  void apply_float(const float* x, float* y);
  void field(const double* x, double* y);
  void screen(const double* x, rc_screen& request);

 private:
  // The products of one precision for one purpose.
  template <class T> struct Bound {
    std::optional<Product<T>> product;
    bool bound = false;
  };

  template <class T> Product<T>& ready(Bound<T>& bound, std::optional<Tables<T>>& tables, const Frame& frame, Targets targets);
  Product<double>& domain_product();
  Product<double>& screen_product();
  template <class T> void multiply(Product<T>& product, const T* x, T* y);

  const rc_host* host_;
  rc_operator_spec spec_;
  int spacing_;  // the spacing wanted; 0: any
  Frame grid_;
  Tiles tiles_;
  Frame frame_;  // of the domain, with room for it to grow
  std::int64_t modelled_ = 0;

  Kernel kernel_;
  std::optional<Tables<double>> tables_;
  std::optional<Tables<float>> float_tables_;
  Bound<double> product_, screen_product_, field_product_;
  Bound<float> float_product_;
};

}  // namespace rc_split
