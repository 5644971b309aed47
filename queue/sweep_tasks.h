#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "queue/connection.h"

namespace dini::queue {

/// Who is served first: somebody who waits for an answer, or work that is asked about later.
enum class Lane { interactive, batch };

/// A sweep as it lies in the queue.
struct QueuedSweep {
  std::string id = {};
  Lane lane = Lane::batch;
  std::string body = {};   ///< the JSON of the request; its graph stands in it
  std::string about = {};  ///< what its lines need besides: JSON
  std::size_t total = 0;
  std::size_t first = 0;  ///< no variant before is wanted
};

/// What became of one variant. A line is sealed by whoever made it; nothing has been looked at yet.
struct CollectedLine {
  std::size_t index = 0;
  std::string line = {};  ///< empty when it got lost
  bool is_dead = false;   ///< it has ended as many workers as it may
};

/// How the owner of a sweep spreads its variants over the workers of an identity and gets their lines. Everything that
/// it does may be done again: an answer that was lost does no harm. See docs/scale.md.
class SweepTasks {
 public:
  SweepTasks(const Address& address, const Patience& patience, const std::string& identity);

  enum class Submitted { taken, full, unmanned };
  /// Takes a sweep in, or in again; `have` are the variants that need not be computed.
  Answered<Submitted> submit(const QueuedSweep& sweep, const std::vector<std::size_t>& have);

  struct Collected {
    bool gone = false;  ///< the queue has nothing of this sweep: it is to be submitted again
    bool idle = false;  ///< nothing is being computed that was let begin
    std::vector<CollectedLine> lines;
  };
  /// Lets go of the lines of these variants, lets further variants be computed up to `limit`, and takes some lines.
  Answered<Collected> collect(const std::string& id, std::size_t limit, const std::vector<std::size_t>& have);

  /// Has one computed again.
  Answered<Reply> redo(const std::string& id, std::size_t index);
  /// Ends a sweep, whether it is complete or not.
  Answered<Reply> drop(const std::string& id);

  /// Keeps a file that graphs name by its hash where the workers find it.
  Answered<Reply> offer_file(const std::string& sha256, const std::string& bytes);

 private:
  Connection connection_;
  std::string base_;
};

/// What is known of a sweep goes when its owner has not been heard of for so long.
inline constexpr std::chrono::milliseconds sweep_time_to_live{60'000};

/// The keys of an identity begin with this.
std::string base_of(const std::string& identity);
/// Where the line of a variant lies until the owner of the sweep has it.
std::string place_of_line(const std::string& base, const std::string& sweep, std::size_t index);
/// Where a file lies that was offered.
std::string offered_file(const std::string& sha256);

}  // namespace dini::queue
