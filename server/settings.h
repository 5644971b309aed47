#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "queue/address.h"
#include "server/network.h"

namespace dini::server {

enum class LogFormat { text, json };

/// Everything that can be set about the HTTP server; limits of the graphs themselves are the engine's.
struct Settings {
  std::string host = "127.0.0.1";
  int port = 8080;                           ///< 0 takes a free one
  std::string token;                         ///< when set, every /v1 request needs `Authorization: Bearer <token>`
  std::string base_path;                     ///< everything is served below it; empty or as "/dini"
  std::vector<Network> trusted_proxies;      ///< whose word is taken for who asked them, and how
  std::vector<std::string> allowed_hosts;    ///< further names that a Host header may carry, with or without port
  std::vector<std::string> allowed_origins;  ///< whose pages may read answers and send requests; "*" for all
  LogFormat log_format = LogFormat::text;    ///< of the lines of requests
  std::filesystem::path web;                 ///< the built page; empty for none
  std::filesystem::path examples;            ///< the example graphs; empty for none

  std::filesystem::path data;  ///< where graphs are kept; empty: in memory, as long as the server runs
  bool needs_data = true;      ///< false: a server that cannot use that folder starts and keeps nothing

  std::optional<queue::Address> queue;  ///< of the workers that compute sweeps; nothing: they are computed here

  std::size_t connections = 4096;  ///< open at once; past that the one that has been idle longest makes room
  std::size_t answer_threads = 0;  ///< that read, check and write requests; 0 for two per core
  std::size_t compute_slots = 0;   ///< evaluations at once; 0 for one per core
  std::size_t compute_queue = 0;   ///< requests waiting for a slot; 0 for sixteen per slot
  std::size_t compute_bytes = 0;   ///< predicted memory of all evaluations at once; 0 for half of what there is
  std::size_t known_bytes = std::size_t{64} << 20;      ///< memory of requests that need not be read again
  std::size_t artifact_bytes = std::size_t{256} << 20;  ///< memory of files that can be fetched by their hash

  std::size_t store_bytes = std::size_t{4} << 30;       ///< of all graphs that are kept
  std::size_t asset_file_bytes = std::size_t{4} << 30;  ///< of all uploaded files that are kept

  std::size_t jobs_at_once = 0;     ///< 0 for one less than compute slots, so that one is left for who waits
  std::size_t jobs_waiting = 1000;  ///< past that: 503
  std::chrono::milliseconds job_deadline{600'000};        ///< for the evaluation of a job, from when it begins
  std::chrono::milliseconds job_result_time{86'400'000};  ///< how long what came of a job is kept

  std::size_t head_bytes = 32 * 1024;  ///< request line and headers together
  std::size_t line_bytes = 8 * 1024;   ///< the request line, and each header
  std::size_t header_count = 100;
  std::size_t wrong_tokens = 20;                        ///< of one address in a minute; past that: 429
  std::size_t incoming_bytes = std::size_t{256} << 20;  ///< of all bodies that are arriving; past that: 503
  std::size_t unsent_bytes = std::size_t{1} << 30;  ///< of all answers that clients have yet to take; past that: 503

  std::chrono::milliseconds head_deadline{3'000};    ///< for a whole head, from its first byte
  std::chrono::milliseconds body_deadline{10'000};   ///< for a whole body, and a second more per MiB of it
  std::chrono::milliseconds idle_deadline{15'000};   ///< between two requests of a connection
  std::chrono::milliseconds write_deadline{10'000};  ///< in which a client takes at least `write_rate` a second
  std::size_t write_rate = 64 * 1024;                ///< bytes a second
  std::chrono::milliseconds drain_deadline{10'000};  ///< what running requests get when the server is told to stop
};

}  // namespace dini::server
