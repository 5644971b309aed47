#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/configuration.h"
#include "cli/ending_signals.h"
#include "cli/exit_codes.h"
#include "cli/folders.h"
#include "cli/given_queue.h"
#include "cli/json_lines.h"
#include "cli/limit_options.h"
#include "cli/log_sink.h"
#include "cli/output_files.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "jobs/memory_reserve.h"
#include "jobs/process_memory.h"
#include "server/addresses.h"
#include "server/base_path.h"
#include "server/server.h"

namespace dini::cli {
namespace {

struct ServeOptions {
  server::Settings settings;
  Limits limits;
  std::vector<std::string> trusted_proxies;
  std::string web;
  std::string examples;
  std::string data;
  std::string queue;
  std::string port_file;
  std::string log_level = "info";
  std::string log_format = "text";
  Computing computing;
  std::optional<Configuration> configuration;
};

/// For --data: graphs are kept in memory, as long as the server runs.
constexpr const char* no_data = "none";

/// Of the memory for results, one part in so many may wait to be used again.
constexpr std::size_t spare_share = 8;

/// Enough to tell everybody that there is no more.
constexpr std::size_t memory_reserve = std::size_t{8} << 20;

/// What the server gets on top of its own deadlines to end before it is ended.
constexpr std::chrono::seconds patience_at_the_end{5};

bool is_json(const ServeOptions& options) { return options.settings.log_format == server::LogFormat::json; }

void begin_log(ServeOptions& options) {
  if (options.log_format == "json") options.settings.log_format = server::LogFormat::json;
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("dini", log_sink()));
  if (is_json(options)) {
    spdlog::set_formatter(json_lines());
  } else {
    spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  }
  spdlog::set_level(spdlog::level::from_str(options.log_level));
}

/// Why the server does not start: for people, or a line of the log where all are JSON.
int fail_to_start(const ServeOptions& options, const Problems& problems, int code) {
  if (!is_json(options)) return fail(problems, code);
  for (const Problem& problem : problems) spdlog::critical(problem_line(problem));
  return code;
}

/// Tells people on standard output, and a log of JSON in itself.
void tell(const ServeOptions& options, const std::string& sentence) {
  if (is_json(options)) return spdlog::info(sentence);
  // Whether anybody reads this is none of the server's concern.
  write_at_once(STDOUT_FILENO, sentence + "\n");
}

Problems announce(const ServeOptions& options, int port) {
  const std::string& host = options.settings.host;
  const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
  tell(options, "Dini listens on http://" + name + ":" + std::to_string(port) + options.settings.base_path + "/");
  if (options.settings.web.empty()) tell(options, "There is no built page beside the program; see --web.");
  return options.port_file.empty() ? Problems{} : write_output(options.port_file, std::to_string(port) + "\n");
}

/// Why pages of an origin cannot be let in; empty when they can.
std::string fault_in_origin(const std::string& origin, const std::string& token) {
  if (origin == "*") return token.empty() ? "" : "a token is for those who have it, not for every page";
  const auto scheme = origin.find("://");
  const bool web = origin.starts_with("http://") || origin.starts_with("https://");
  // Nothing else stands in an origin, and it is written into headers, one of which has lists.
  const auto stands_in_origin = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view(".-:[]").find(c) != std::string_view::npos;
  };
  const bool bare =
      web && origin.size() > scheme + 3 &&
      std::all_of(origin.begin() + static_cast<std::ptrdiff_t>(scheme) + 3, origin.end(), stands_in_origin);
  return bare ? "" : "an origin is a scheme, a name and perhaps a port, as https://site.example:8443";
}

/// Takes out of the options what is written in words. What is wrong with them, as far as can be told before anything
/// is started.
Problems check(ServeOptions& options) {
  const std::string& host = options.settings.host;
  if (host.empty()) return {usage_problem("--host needs an address")};
  std::error_code ignored;
  if (!options.examples.empty() && !std::filesystem::is_directory(options.examples, ignored)) {
    return {{.code = "io", .detail = options.examples + ": there is no such folder"}};
  }
  if (const std::string wrong = server::fault_in_base_path(options.settings.base_path); !wrong.empty()) {
    return {usage_problem("--base-path " + options.settings.base_path + ": " + wrong)};
  }
  for (const std::string& text : options.trusted_proxies) {
    const auto network = server::Network::parse(text);
    if (!network) {
      return {usage_problem("--trusted-proxy " + text +
                            ": it is an address, as 10.0.0.1 or ::1, or a network, as "
                            "10.0.0.0/8")};
    }
    options.settings.trusted_proxies.push_back(*network);
  }
  for (const std::string& origin : options.settings.allowed_origins) {
    if (const std::string wrong = fault_in_origin(origin, options.settings.token); !wrong.empty()) {
      return {usage_problem("--allow-origin " + origin + ": " + wrong)};
    }
  }
  if (!options.queue.empty()) {
    auto address = read_queue(options.queue);
    if (!address) return address.problems();
    options.settings.queue = *std::move(address);
  }
  if (!server::is_loopback(host) && options.settings.token.empty()) {
    return {usage_problem("--host " + host + " can be reached from elsewhere: give a --token")};
  }
  return {};
}

int run(ServeOptions& options, const EngineMaker& make_engine) {
  const Problems unread = options.configuration->read();
  begin_log(options);
  const auto refuse = [&](const Problems& problems) {
    return fail_to_start(options, problems, exit_code_for(problems, Stage::checking));
  };
  if (!unread.empty()) return refuse(unread);
  if (const Problems wrong = check(options); !wrong.empty()) return refuse(wrong);
  if (options.configuration->is_to_be_printed()) {
    std::cout << options.configuration->text();
    return exit_ok;
  }
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return refuse(wrong);
  std::signal(SIGPIPE, SIG_IGN);  // whoever reads the log may leave
  EndingSignals signals(options.settings.drain_deadline + patience_at_the_end);
  options.settings.web = find_folder(options.web, "../../web/dist", "../share/dini/web");
  options.settings.examples = find_examples(options.examples);
  if (options.data != no_data) {
    options.settings.data = data_folder(options.data);
    options.settings.needs_data = !options.data.empty();
  }

  jobs::use_few_memory_pools();
  jobs::keep_spare_memory(options.limits.cache_bytes / spare_share);
  const jobs::MemoryReserve reserve(memory_reserve);
  const std::unique_ptr<Engine> engine = make_engine(options.limits);
  const auto server = server::Server::start(*engine, options.settings);
  if (!server) {
    const std::string& code = server.problems().front().code;
    return fail_to_start(options, server.problems(),
                         code == "address" || code == "io" ? exit_io
                         : code == "out-of-memory"         ? exit_limit
                                                           : exit_invalid_graph);
  }
  signals.running();
  if (const Problems wrong = announce(options, (*server)->port()); !wrong.empty()) return refuse(wrong);
  signals.wait();
  spdlog::info("draining");
  (*server)->stop();
  return exit_ok;
}

}  // namespace

void add_serve(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("serve", "Run the HTTP server and its page");
  const auto options = std::make_shared<ServeOptions>();
  server::Settings& settings = options->settings;
  Configuration& configuration = options->configuration.emplace(*command);
  configuration.usual(command->add_option("--host", settings.host, "The address to listen on (default 127.0.0.1)"),
                      settings.host);
  configuration.usual(command->add_option("--port", settings.port, "The port, 0 for a free one (default 8080)")
                          ->check(CLI::Range(0, 65535)),
                      std::to_string(settings.port));
  command->add_option("--port-file", options->port_file, "A file to write the port to once listening");
  command
      ->add_option(
          "--allow-host", settings.allowed_hosts,
          "A further name that the Host header may carry, with any port or, as name:8443, with one; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--allow-origin", settings.allowed_origins,
                   "An origin, as https://site.example, whose pages may read answers and send requests; may be "
                   "repeated; * for all, without a token only")
      ->allow_extra_args(false);
  command->add_option("--base-path", settings.base_path,
                      "Where all addresses begin, as /dini, for a proxy that serves more than this");
  command
      ->add_option("--trusted-proxy", options->trusted_proxies,
                   "The address or network (10.0.0.0/8) of a proxy whose X-Forwarded-For, -Proto and -Host are "
                   "believed; may be repeated")
      ->allow_extra_args(false);
  configuration.hide(command->add_option("--token", settings.token,
                                         "Needed by every request to /v1; allows addresses other than loopback"));
  command->add_option("--web", options->web, "The folder of the built page");
  command->add_option("--examples", options->examples, "The folder of the example graphs");
  command->add_option("--data", options->data,
                      "The folder that graphs are kept in, or `none` to keep them as long as the server runs (default: "
                      "dini in the user's data folder)");
  configuration.hide(command->add_option(
      "--queue", options->queue,
      std::string("The Redis whose workers compute sweeps, as ") + queue_form + "; without it they are computed here"));
  configuration.usual(command->add_option("--log-level", options->log_level, "Least level to log (default info)")
                          ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"})),
                      options->log_level);
  configuration.usual(
      command->add_option("--log-format", options->log_format, "Lines of the log for people, or JSON (default text)")
          ->check(CLI::IsMember({"text", "json"})),
      options->log_format);
  options->computing.add_options(*command);
  add_limit_options(*command, configuration, options->limits, settings);
  configuration.name_variables();
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli
