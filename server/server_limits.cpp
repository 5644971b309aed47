#include "server/server_limits.h"

#include <array>

namespace dini::server {
namespace {

constexpr std::uint64_t day = 24 * 3600 * 1000;
constexpr std::uint64_t most_threads = 4096;

constexpr std::array limits = {
    Limit<Settings>{"connections", "connections", &Settings::connections,
                    "open at once; past that the one that has been idle longest makes room", 1, 1 << 20},
    Limit<Settings>{"answer_threads", "threads", &Settings::answer_threads, "that read, check and write requests", 0,
                    most_threads, "two per core"},
    Limit<Settings>{"compute_slots", "evaluations", &Settings::compute_slots, "at once", 0, most_threads,
                    "one per core"},
    Limit<Settings>{"compute_queue", "requests", &Settings::compute_queue,
                    "that may wait for a place to compute, however long they take", 0, 1 << 20, "sixteen per place"},
    Limit<Settings>{"compute_bytes", "bytes", &Settings::compute_bytes,
                    "of memory predicted for all evaluations at once", 0, std::uint64_t{1} << 50,
                    "half of the machine's or container's"},
    Limit<Settings>{"known_bytes", "bytes", &Settings::known_bytes,
                    "of memory for requests that need not be read again", 0},
    Limit<Settings>{"artifact_bytes", "bytes", &Settings::artifact_bytes,
                    "of memory for files that can be fetched by their hash", 0},
    Limit<Settings>{"store_bytes", "bytes", &Settings::store_bytes, "of all versions of all graphs that are kept",
                    1 << 16, std::uint64_t{1} << 46},
    Limit<Settings>{"asset_file_bytes", "bytes", &Settings::asset_file_bytes,
                    "of all uploaded files in the data folder; those used longest ago go first, but none that a "
                    "stored graph names",
                    1 << 16, std::uint64_t{1} << 46},
    Limit<Settings>{"jobs_at_once", "jobs", &Settings::jobs_at_once, "that are done at once", 0, most_threads,
                    "one less than `compute_slots`, and at least one"},
    Limit<Settings>{"jobs_waiting", "jobs", &Settings::jobs_waiting, "that may wait for their turn; past that: 503", 1,
                    1 << 20},
    Limit<Settings>{"job_milliseconds", "ms", &Settings::job_deadline,
                    "for the evaluation of a job, from when it begins", 1, day},
    Limit<Settings>{"job_result_milliseconds", "ms", &Settings::job_result_time,
                    "that what came of a job is kept after its end", 1, 366 * day},
    Limit<Settings>{"head_bytes", "bytes", &Settings::head_bytes, "of the request line and all headers", 256, 1 << 24},
    Limit<Settings>{"line_bytes", "bytes", &Settings::line_bytes, "of the request line, and of each header", 128,
                    1 << 24},
    Limit<Settings>{"header_count", "headers", &Settings::header_count, "of one request", 1, 10'000},
    Limit<Settings>{"wrong_tokens", "tokens", &Settings::wrong_tokens,
                    "that are wrong and come from one address in a minute; past that: 429", 1, 1 << 20},
    Limit<Settings>{"incoming_bytes", "bytes", &Settings::incoming_bytes,
                    "of all bodies that are arriving; past that: 503"},
    Limit<Settings>{"unsent_bytes", "bytes", &Settings::unsent_bytes,
                    "of all answers that clients have yet to take; past that: 503"},
    Limit<Settings>{"head_milliseconds", "ms", &Settings::head_deadline, "for a whole head, from its first byte", 1,
                    day},
    Limit<Settings>{"body_milliseconds", "ms", &Settings::body_deadline,
                    "for a whole body, and a second more per MiB of it", 1, day},
    Limit<Settings>{"idle_milliseconds", "ms", &Settings::idle_deadline, "between two requests of a connection", 1,
                    day},
    Limit<Settings>{"write_milliseconds", "ms", &Settings::write_deadline,
                    "in each of which a client takes at least `write_rate` a second", 1, day},
    Limit<Settings>{"write_rate", "bytes/s", &Settings::write_rate, "that a client takes at least", 0},
    Limit<Settings>{"drain_milliseconds", "ms", &Settings::drain_deadline,
                    "for running requests when the server is told to stop", 0, day},
};

}  // namespace

std::span<const Limit<Settings>> server_limits() { return limits; }

}  // namespace dini::server
