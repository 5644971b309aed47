#include "formats/zip_archive.h"

#include <memory>
#include <zip.h>

namespace dini {

namespace {

constexpr zip_uint16_t first_day = (1 << 5) | 1;  ///< 1 January 1980, the first that a ZIP can tell
constexpr zip_uint32_t effort = 6;

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DropArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};

FileError failure(const std::string& why) { return {"encode-failed", "the archive cannot be written: " + why}; }

/// An error of libzip while it lives.
class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ~ZipError() { zip_error_fini(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;

  zip_error_t* get() { return &error_; }
  std::string text() { return zip_error_strerror(&error_); }

 private:
  zip_error_t error_;
};

/// Adds one file; false with the error in the archive.
bool add(zip_t* archive, const std::string& name, const std::string& content) {
  zip_source_t* const source = zip_source_buffer(archive, content.data(), content.size(), 0);
  if (source == nullptr) return false;
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto entry = static_cast<zip_uint64_t>(index);
  return zip_set_file_compression(archive, entry, ZIP_CM_DEFLATE, effort) == 0 &&
         zip_file_set_dostime(archive, entry, 0, first_day, 0) == 0;
}

int is_stopped(zip_t*, void* cancel) { return static_cast<const Cancel*>(cancel)->stopped() ? 1 : 0; }

Expected<std::string, FileError> contents_of(zip_source_t* source) {
  zip_stat_t facts;
  if (zip_source_stat(source, &facts) != 0 || zip_source_open(source) != 0) return failure("it cannot be read back");
  std::string bytes(facts.size, '\0');
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read != static_cast<zip_int64_t>(bytes.size())) return failure("it cannot be read back");
  return bytes;
}

}  // namespace

Expected<std::string, FileError> zip_archive(const std::vector<std::pair<std::string, std::string>>& files,
                                             const Cancel& cancel) {
  ZipError error;
  const std::unique_ptr<zip_source_t, FreeSource> target(zip_source_buffer_create(nullptr, 0, 0, error.get()));
  if (target == nullptr) return failure(error.text());
  std::unique_ptr<zip_t, DropArchive> archive(
      zip_open_from_source(target.get(), ZIP_CREATE | ZIP_TRUNCATE, error.get()));
  if (archive == nullptr) return failure(error.text());
  zip_source_keep(target.get());  // the archive has one share of it, and this function the other
  for (const auto& [name, content] : files) {
    if (!add(archive.get(), name, content)) return failure(zip_strerror(archive.get()));
  }
  // It only reads the flag.
  zip_register_cancel_callback_with_state(archive.get(), is_stopped, nullptr, const_cast<Cancel*>(&cancel));
  if (zip_close(archive.get()) != 0) return failure(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closing has freed it
  return contents_of(target.get());
}

}  // namespace dini
