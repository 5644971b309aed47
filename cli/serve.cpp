#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/folders.h"
#include "cli/terminal.h"
#include "server/server.h"

namespace dini::cli {
namespace {

struct Options {
  server::Settings settings;
  std::string web;
  std::string examples;
  std::string port_file;
  std::string log_level = "info";
  Computing computing;
};

int fail(const Problems& problems, int code) {
  print_problems(problems);
  return code;
}

bool is_loopback(const std::string& host) { return host == "localhost" || host == "::1" || host.starts_with("127."); }

/// The signals that end the server, blocked in this and every later thread, so that one thread can wait for them.
sigset_t block_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void wait_for_signal(const sigset_t& signals) {
  int received = 0;
  sigwait(&signals, &received);
  // A second one ends the program at once, for those who will not wait for the requests that still run.
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

Problems announce(const Options& options, int port) {
  const std::string& host = options.settings.host;
  const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
  std::cout << "Dini listens on http://" << name << ":" << port << "/" << std::endl;
  if (options.settings.web.empty()) std::cout << "There is no built page beside the program; see --web." << std::endl;
  return options.port_file.empty() ? Problems{} : write_output(options.port_file, std::to_string(port) + "\n");
}

int run(Options& options) {
  if (options.settings.host.empty()) return fail({{.code = "usage", .detail = "--host needs an address"}}, exit_usage);
  std::error_code ignored;
  if (!options.examples.empty() && !std::filesystem::is_directory(options.examples, ignored)) {
    return fail({{.code = "io", .detail = options.examples + ": there is no such folder"}}, exit_io);
  }
  if (!is_loopback(options.settings.host) && options.settings.token.empty()) {
    return fail({{.code = "usage",
                  .detail = "--host " + options.settings.host + " can be reached from elsewhere: give a --token"}},
                exit_usage);
  }
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return fail(wrong, exit_usage);
  const sigset_t signals = block_ending_signals();
  spdlog::set_default_logger(spdlog::stderr_logger_mt("dini"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  spdlog::set_level(spdlog::level::from_str(options.log_level));
  options.settings.web = find_folder(options.web, "../../web/dist", "../share/dini/web");
  options.settings.examples = find_examples(options.examples);

  const Engine engine;
  const auto server = server::Server::start(engine, options.settings);
  if (!server) {
    const bool address = server.problems().front().code == "address" || server.problems().front().code == "io";
    return fail(server.problems(), address ? exit_io : exit_invalid_graph);
  }
  if (const Problems wrong = announce(options, (*server)->port()); !wrong.empty()) return fail(wrong, exit_io);
  wait_for_signal(signals);
  spdlog::info("draining");
  (*server)->stop();
  return exit_ok;
}

}  // namespace

void add_serve(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("serve", "Run the HTTP server and its page");
  const auto options = std::make_shared<Options>();
  server::Settings& settings = options->settings;
  command->add_option("--host", settings.host, "The address to listen on (default 127.0.0.1)");
  command->add_option("--port", settings.port, "The port, 0 for a free one (default 8080)")
      ->check(CLI::Range(0, 65535));
  command->add_option("--port-file", options->port_file, "A file to write the port to once listening");
  command
      ->add_option("--allow-host", settings.allowed_hosts,
                   "A further name that the Host header may carry; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--token", settings.token, "Needed by every request to /v1; allows addresses other than loopback")
      ->envname("DINI_TOKEN");
  command->add_option("--web", options->web, "The folder of the built page");
  command->add_option("--examples", options->examples, "The folder of the example graphs");
  command->add_option("--log-level", options->log_level, "Least level to log (default info)")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}));
  options->computing.add_options(*command);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace dini::cli
