#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dini::server {

/// Everything that can be set about the HTTP server; limits of the graphs themselves are the engine's.
struct Settings {
  std::string host = "127.0.0.1";
  int port = 8080;                         ///< 0 takes a free one
  std::string token;                       ///< when set, every /v1 request needs `Authorization: Bearer <token>`
  std::vector<std::string> allowed_hosts;  ///< further names that a Host header may carry, without port
  std::filesystem::path web;               ///< the built page; empty for none
  std::filesystem::path examples;          ///< the example graphs; empty for none

  std::size_t connection_threads = 256;   ///< one per open connection, started when first needed
  std::size_t waiting_connections = 256;  ///< accepted but without a thread; past that: 503
  std::size_t compute_slots = 0;          ///< evaluations at once; 0 for one per core
  std::size_t compute_queue = 0;          ///< requests waiting for a slot; 0 for sixteen per slot

  std::size_t head_bytes = 32 * 1024;  ///< request line and headers together
  std::size_t line_bytes = 8 * 1024;   ///< the request line, and each header
  std::size_t header_count = 100;
  std::size_t large_bodies = 8;  ///< bodies above 1 MiB that may arrive at once; past that: 503

  std::chrono::milliseconds head_deadline{3'000};    ///< for a whole head, from its first byte
  std::chrono::milliseconds body_deadline{10'000};   ///< for a whole body, and a second more per MiB of it
  std::chrono::milliseconds idle_deadline{15'000};   ///< between two requests of a connection
  std::chrono::milliseconds write_deadline{10'000};  ///< for an answer, and a second more per 64 KiB of it
  std::chrono::milliseconds drain_deadline{10'000};  ///< what running requests get when the server is told to stop
};

}  // namespace dini::server
