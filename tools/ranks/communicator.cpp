#include "communicator.h"

#include <algorithm>
#include <climits>
#include <exception>
#include <numeric>

#include "formats/error.h"

namespace cli {

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &ranks_);
  rc_mpi_exchange_create(comm_, &exchange_);  // if it fails, contacts are refused with its message
}

void Communicator::together(const std::function<void()>& part) const {
  std::string message;
  bool failed = false;
  try {
    part();
  } catch (const std::bad_alloc&) {
    failed = true;
    message = "out of memory on rank " + std::to_string(rank_);
  } catch (const std::exception& error) {
    failed = true;
    message = error.what();
  }
  int at = failed ? rank_ : INT_MAX, speaker = INT_MAX;
  MPI_Allreduce(&at, &speaker, 1, MPI_INT, MPI_MIN, comm_);
  if (speaker == INT_MAX) return;
  auto length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, speaker, comm_);
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, speaker, comm_);
  throw rc::formats::Error(message);
}

void Communicator::on_first(const std::function<void()>& part) const {
  together([&] {
    if (first()) part();
  });
}

std::string Communicator::of_first(std::string text) const {
  text.resize(static_cast<std::size_t>(of_first(static_cast<std::int64_t>(text.size()))));
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, comm_);
  return text;
}

std::int64_t Communicator::of_first(std::int64_t number) const {
  MPI_Bcast(&number, 1, MPI_INT64_T, 0, comm_);
  return number;
}

double Communicator::largest(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return value;
}

std::int64_t Communicator::least(std::int64_t value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_MIN, comm_);
  return value;
}

std::int64_t Communicator::sum(std::int64_t value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, comm_);
  return value;
}

std::vector<double> Communicator::collected(std::span<const double> values) const {
  const auto mine = static_cast<int>(values.size());
  std::vector<int> counts(first() ? static_cast<std::size_t>(ranks_) : 0), places(counts.size());
  MPI_Gather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm_);
  std::exclusive_scan(counts.begin(), counts.end(), places.begin(), 0);
  std::vector<double> all(static_cast<std::size_t>(std::reduce(counts.begin(), counts.end())));
  MPI_Gatherv(values.data(), mine, MPI_DOUBLE, all.data(), counts.data(), places.data(), MPI_DOUBLE, 0, comm_);
  return all;
}

}  // namespace cli
