#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geometry/imported_mesh.h"
#include "geometry/validate.h"

namespace dini::support {

/// The bytes with one to four places changed, cut out, repeated, cut off, or with a word put in that readers stumble
/// over. The same generator gives the same damage.
inline std::string damaged(std::string bytes, std::mt19937& random) {
  static const std::vector<std::string> words = {"nan",
                                                 "inf",
                                                 "-1",
                                                 "0",
                                                 "1e400",
                                                 "255.0",
                                                 "\\\n",
                                                 "#",
                                                 "\n",
                                                 "4294967296",
                                                 "18446744073709551615",
                                                 "1.#QNAN",
                                                 "f 1 2 3\n",
                                                 "3 0 1 2\n",
                                                 "{",
                                                 "}",
                                                 "[",
                                                 "]",
                                                 ",",
                                                 "\"",
                                                 std::string("\xff\xff\xff\xff"),
                                                 std::string(4, '\0')};
  const auto below = [&](std::size_t count) { return random() % std::max<std::size_t>(count, 1); };
  for (std::size_t left = 1 + below(4); left > 0 && !bytes.empty(); --left) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes.erase(at, below(16));
        break;
      case 2:
        bytes.insert(below(bytes.size()), bytes.substr(at, below(64)));
        break;
      case 3:
        bytes.insert(at, words[below(words.size())]);
        break;
      default:
        bytes.resize(at);
    }
  }
  return bytes;
}

/// Whether a file was read as a mesh that keeps its promises, or refused, in sentences that can be shown.
template <class Read>
void check_is_read_or_refused(Read read, const std::string& bytes) {
  const auto can_be_shown = [](const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  };
  // Memory of its own, so that a read past the end is one for the address sanitizer too.
  const std::vector<char> exact(bytes.begin(), bytes.end());
  const ImportResult result = read(std::string_view(exact.data(), exact.size()), {1000, 1000}, {});
  if (result) {
    CHECK_FALSE(mesh_defect(result->mesh));
    CHECK(result->mesh.triangles.size() <= 1000);
    CHECK(std::all_of(result->warnings.begin(), result->warnings.end(), can_be_shown));
  } else {
    CHECK(can_be_shown(result.error().detail));
  }
}

}  // namespace dini::support
