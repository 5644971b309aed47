#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "store/job_store.h"

namespace dini::jobs {

/// The media type that lines are sealed with.
inline constexpr std::string_view line_record_type = "application/x-dini-line";

/// A line with its files, as a worker sends it: JSON in one line, then the bytes of the files.
std::string line_record(const store::JobLine& line);
/// What `line_record` wrote; nothing for other bytes.
std::optional<store::JobLine> read_line_record(std::size_t index, std::string_view record);

}  // namespace dini::jobs
