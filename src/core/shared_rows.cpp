#include "core/ranks.h"

namespace rc {

SharedRows::SharedRows(const Ranks& shared) : rc_rows{}, of(&shared) {
  struct_size = sizeof(rc_rows);
  rank = shared.rank();
  ranks = shared.size();
  first = shared.first().data();
  transpose = [](const rc_rows* rows, const void* from, const std::int64_t* sent, void* into, const std::int64_t* received) {
    ranks_of(rows)->transpose(from, sent, into, received);
  };
  agree = [](const rc_rows* rows, rc_status mine) -> rc_status {
    if (mine != RC_OK) ranks_of(rows)->failed(mine, last_message());
    return caught([&]() -> rc_status {
      ranks_of(rows)->agree();
      return RC_OK;
    });
  };
  gather = [](const rc_rows* rows, const void* mine, const std::int64_t* bytes, void* all) {
    ranks_of(rows)->gather_unwatched(mine, bytes, all);
  };
}

}  // namespace rc
