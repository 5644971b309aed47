#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/folders.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "store/asset_folder.h"
#include "store/graph_store.h"

namespace dini::cli {
namespace {

struct StoreOptions {
  std::string data;
  std::string backup;
};

using OpenedStore = Result<std::unique_ptr<store::GraphStore>>;

/// Opens the folder in one of the two ways, and goes on with what it holds.
template <class Work>
int with_store(const StoreOptions& options, OpenedStore (*open)(const std::filesystem::path&), Work work) {
  const std::filesystem::path folder = data_folder(options.data);
  if (folder.empty()) {
    return fail({usage_problem("say with --data which folder: there is no HOME to find the usual one in")}, exit_usage);
  }
  const OpenedStore store = open(folder);
  if (!store) return fail(store.problems(), exit_io);
  return work(**store, folder);
}

OpenedStore open_to_write(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    return Problem{.code = "io", .detail = folder.string() + ": there is no such folder"};
  }
  constexpr std::size_t any_size = std::size_t{1} << 46;
  return store::GraphStore::open(folder, any_size);
}

int list(const store::GraphStore& store) {
  constexpr std::size_t page_size = 1000;
  std::string after;
  for (bool more = true; more;) {
    const auto page = store.list(after, "", page_size);
    if (!page) return fail(page.problems(), exit_io);
    for (const store::GraphVersion& graph : page->graphs) {
      std::cout << graph.id << "@" << graph.version << "\t" << graph.bytes << "\t" << to_hex(graph.hash) << "\t"
                << printable(graph.title) << "\n";
      after = graph.id;
    }
    more = page->more;
  }
  return exit_ok;
}

int check(const store::GraphStore& store, const std::filesystem::path& folder) {
  auto fault = store.fault();
  if (!fault) return fail(fault.problems(), exit_io);
  if (fault->empty()) *fault = store::fault_in_assets(folder);
  if (!fault->empty()) return fail({{.code = "io", .detail = "what is kept is damaged: " + *fault}}, exit_io);
  std::cout << "Everything that is kept can be read and is what was written.\n";
  return exit_ok;
}

int back_up(const store::GraphStore& store, const std::filesystem::path& folder, const std::string& file) {
  const std::string assets = file + ".assets";
  std::error_code error;
  for (const std::string& target : {file, assets}) {
    if (!std::filesystem::exists(target, error)) continue;
    return fail({{.code = "io", .detail = target + ": there is one already; a backup replaces none"}}, exit_io);
  }
  if (const auto written = store.back_up(file); !written) return fail(written.problems(), exit_io);
  // After the graphs, so that no file is missing that they name.
  const auto copied = store::copy_assets(folder, assets);
  return copied ? int{exit_ok} : fail(copied.problems(), exit_io);
}

int purge(store::GraphStore& store) {
  const auto purged = store.purge();
  if (!purged) return fail(purged.problems(), exit_io);
  std::cout << *purged << (*purged == 1 ? " deleted graph is" : " deleted graphs are") << " gone for ever.\n";
  return exit_ok;
}

}  // namespace

void add_store(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("store", "Look after the graphs that a server keeps");
  command->require_subcommand(1);
  // Each has options of its own: the environment is read for all of them, also for those that were not given.
  const auto add = [&](const char* name, const char* help, std::function<int(const StoreOptions&)> run,
                       const std::shared_ptr<StoreOptions>& options = std::make_shared<StoreOptions>()) {
    auto* subcommand = command->add_subcommand(name, help);
    subcommand
        ->add_option("--data", options->data, "The folder of the server (default: dini in the user's data folder)")
        ->envname("DINI_DATA");
    subcommand->callback([run = std::move(run), options, &chosen] { chosen = [=] { return run(*options); }; });
    return subcommand;
  };
  const auto backup = std::make_shared<StoreOptions>();
  add("list", "List the graphs: name and version, bytes, hash, title", [](const StoreOptions& options) {
    return with_store(options, store::GraphStore::open_to_read, [](auto& store, const auto&) { return list(store); });
  });
  add("check", "Read everything that is kept and say whether it is what was written", [](const StoreOptions& options) {
    return with_store(options, store::GraphStore::open_to_read,
                      [](auto& store, const auto& folder) { return check(store, folder); });
  });
  add(
      "backup",
      "Write everything into a new file while the server goes on, uploaded files into a folder beside it; put back as "
      "dini.db and assets in an empty folder",
      [](const StoreOptions& options) {
        return with_store(options, store::GraphStore::open_to_read,
                          [&](auto& store, const auto& folder) { return back_up(store, folder, options.backup); });
      },
      backup)
      ->add_option("file", backup->backup, "The file to write; uploaded files go into FILE.assets")
      ->required();
  add("purge", "Forget deleted graphs and all their versions for ever; while no server runs",
      [](const StoreOptions& options) {
        return with_store(options, open_to_write, [](auto& store, const auto&) { return purge(store); });
      });
}

}  // namespace dini::cli
