#pragma once

#include <string>

namespace dini::jobs {

/// 128 random bits, in 32 hexadecimal digits: nobody guesses it, and no two are alike.
std::string random_id();

}  // namespace dini::jobs
