#include "cli/limit_options.h"

#include "server/server_limits.h"

namespace dini::cli {
namespace {

template <class Owner>
void add_option(CLI::App& command, const Limit<Owner>& limit, Owner& owner) {
  const std::string usual =
      limit.zero_means.empty() ? std::to_string(limit.get(Owner{})) : std::string(limit.zero_means);
  command
      .add_option_function<std::uint64_t>(
          flag_of(limit.name), [&limit, &owner](const std::uint64_t& value) { limit.set(owner, value); },
          std::string(limit.unit) + " " + std::string(limit.doc) + " (default " + usual + ")")
      ->envname(variable_of(limit.name))
      ->check(CLI::Range(limit.least, limit.most))
      ->group("Limits");
}

}  // namespace

void add_limit_options(CLI::App& command, Limits& limits, server::Settings& settings) {
  for (const Limit<Limits>& limit : evaluation_limits()) add_option(command, limit, limits);
  for (const Limit<server::Settings>& limit : server::server_limits()) add_option(command, limit, settings);
}

}  // namespace dini::cli
