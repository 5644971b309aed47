#include "cli/limit_options.h"

#include "server/server_limits.h"

namespace dini::cli {
namespace {

template <class Owner>
void add_option(CLI::App& command, Configuration& configuration, const Limit<Owner>& limit, Owner& owner) {
  const std::string number = std::to_string(limit.get(Owner{}));
  const std::string usual = limit.zero_means.empty() ? number : std::string(limit.zero_means);
  const CLI::Option* option =
      command
          .add_option_function<std::uint64_t>(
              flag_of(limit.name), [&limit, &owner](const std::uint64_t& value) { limit.set(owner, value); },
              std::string(limit.unit) + " " + std::string(limit.doc) + " (default " + usual + ")")
          ->check(CLI::Range(limit.least, limit.most))
          ->group("Limits");
  configuration.usual(option, number);
}

}  // namespace

void add_limit_options(CLI::App& command, Configuration& configuration, Limits& limits) {
  for (const Limit<Limits>& limit : evaluation_limits()) add_option(command, configuration, limit, limits);
}

void add_limit_options(CLI::App& command, Configuration& configuration, Limits& limits, server::Settings& settings) {
  add_limit_options(command, configuration, limits);
  for (const Limit<server::Settings>& limit : server::server_limits())
    add_option(command, configuration, limit, settings);
}

}  // namespace dini::cli
