// The ranks that run the command together: what all must know, and failures that one of them meets.
#pragma once

#include <roughcontact/mpi.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cli {

class Communicator {
 public:
  explicit Communicator(MPI_Comm comm);
  ~Communicator() { rc_mpi_exchange_destroy(&exchange_); }
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  MPI_Comm get() const { return comm_; }
  const rc_exchange& exchange() const { return exchange_; }  // between the same ranks, for the library
  int rank() const { return rank_; }
  bool first() const { return rank_ == 0; }

  // Calls `part` on every rank, without communication within it. If it throws on one of them, every rank throws the Error of the
  // first of those.
  void together(const std::function<void()>& part) const;
  // The same where rank 0 alone has work.
  void on_first(const std::function<void()>& part) const;

  // The value of rank 0, on every rank.
  std::string of_first(std::string text) const;
  std::int64_t of_first(std::int64_t number) const;

  double largest(double value) const;
  std::int64_t least(std::int64_t value) const;
  std::int64_t sum(std::int64_t value) const;
  // The values of all ranks in the order of ranks, on rank 0; nothing on the others.
  std::vector<double> collected(std::span<const double> values) const;

 private:
  MPI_Comm comm_;
  int rank_ = 0, ranks_ = 1;
  rc_exchange exchange_ = RC_EXCHANGE_INIT;
};

}  // namespace cli
