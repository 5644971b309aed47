#include "graph/port_reader.h"

#include <algorithm>

namespace dini {

namespace {

/// Where the values of an input stand while a loop runs over the lifted axes.
class Places {
 public:
  Places(const Axes& own, const Axes& lifted) : offsets_(own, lifted) {}

  bool constant() const { return offsets_.constant(); }
  bool contiguous() const { return offsets_.contiguous(); }

  void begin_run(std::size_t begin, std::size_t end) {
    begin_ = begin;
    if (!constant() && !contiguous()) offsets_.fill(begin, end, places_);
  }
  std::size_t operator[](std::size_t index) const {
    return constant() ? 0 : contiguous() ? index : places_[index - begin_];
  }

 private:
  Offsets offsets_;
  std::size_t begin_ = 0;
  std::vector<std::size_t> places_;
};

const Value& value_at(const Call& call, std::size_t port) { return std::get<Value>(call.arguments[port]); }

/// Reads what stands at one place for each index: Reader writes it from there.
template <class Reader>
class PlacedReader : public PortReader {
 public:
  PlacedReader(const Call& call, std::size_t port) : places_(value_at(call, port).axes, call.lifted) {}

  void begin_run(std::size_t begin, std::size_t end, void* target) override {
    places_.begin_run(begin, end);
    if (places_.constant()) write(0, target);
  }
  bool varies() const override { return !places_.constant(); }
  void read(std::size_t index, void* target) const override { write(places_[index], target); }
  bool same(std::size_t a, std::size_t b) const override { return places_[a] == places_[b]; }

 private:
  void write(std::size_t place, void* target) const { static_cast<const Reader&>(*this).write(place, target); }

  Places places_;
};

template <class T>
class ValueReader final : public PlacedReader<ValueReader<T>> {
 public:
  ValueReader(const Call& call, std::size_t port)
      : PlacedReader<ValueReader<T>>(call, port), column_(column_of<T>(value_at(call, port))) {}

  void write(std::size_t place, void* target) const { *static_cast<T*>(target) = column_[place]; }

 private:
  const Column<T>& column_;
};

template <class T, int K>
class BlockReader final : public PlacedReader<BlockReader<T, K>> {
 public:
  BlockReader(const Call& call, std::size_t port)
      : PlacedReader<BlockReader<T, K>>(call, port),
        value_(value_at(call, port)),
        column_(column_of<T>(value_)),
        consumed_(call.consumed) {}

  void write(std::size_t place, void* target) const {
    *static_cast<Block<T, K>*>(target) = Block<T, K>(column_, place, value_.axes, consumed_);
  }

 private:
  const Value& value_;
  const Column<T>& column_;
  const Axes& consumed_;
};

/// What is left out is the same for all indices; what is given is read as a value is.
template <class T, class Reader>
class OptionalReader : public PortReader {
 public:
  OptionalReader(const Call& call, std::size_t port) {
    if (std::holds_alternative<Value>(call.arguments[port])) reader_.emplace(call, port);
  }

  void begin_run(std::size_t begin, std::size_t end, void* target) override {
    auto& optional = *static_cast<std::optional<T>*>(target);
    if (!reader_) return optional.reset();
    reader_->begin_run(begin, end, &optional.emplace());
  }
  bool varies() const override { return reader_ && reader_->varies(); }
  void read(std::size_t index, void* target) const override {
    reader_->read(index, &**static_cast<std::optional<T>*>(target));
  }
  bool same(std::size_t a, std::size_t b) const override { return !reader_ || reader_->same(a, b); }

 private:
  std::optional<Reader> reader_;
};

/// Values that do not lie one after another are gathered first.
template <class T>
class BatchReader : public PortReader {
 public:
  static constexpr std::size_t width = Components<T>::width;

  BatchReader(const Call& call, std::size_t port)
      : column_(column_of<T>(value_at(call, port))), places_(value_at(call, port).axes, call.lifted) {}

  void begin_run(std::size_t begin, std::size_t end, void* target) override {
    places_.begin_run(begin, end);
    auto& batch = *static_cast<Batch<T>*>(target);
    batch = {{}, end - begin, places_.constant()};
    const bool in_place = places_.constant() || places_.contiguous();
    if (!in_place) gathered_.resize(width * batch.size);
    for (std::size_t k = 0; k < width; ++k) {
      const double* source = column_.component(k);
      batch.components[k] = places_.constant() ? source : in_place ? source + begin : gather(source, k, begin, end);
    }
  }

 private:
  const double* gather(const double* source, std::size_t k, std::size_t begin, std::size_t end) {
    double* target = gathered_.data() + k * (end - begin);
    for (std::size_t i = begin; i < end; ++i) target[i - begin] = source[places_[i]];
    return target;
  }

  const Column<T>& column_;
  Places places_;
  std::vector<double> gathered_;
};

template <class L>
class LiteralReader : public PortReader {
 public:
  LiteralReader(const Call& call, std::size_t port) : literal_(std::get<L>(std::get<Literal>(call.arguments[port]))) {}
  void begin_run(std::size_t, std::size_t, void* target) override { *static_cast<L*>(target) = literal_; }

 private:
  const L& literal_;
};

class ChoiceReader : public PortReader {
 public:
  ChoiceReader(std::size_t place, void (*write)(void*, std::size_t)) : place_(place), write_(write) {}
  void begin_run(std::size_t, std::size_t, void* target) override { write_(target, place_); }

 private:
  std::size_t place_;
  void (*write_)(void*, std::size_t);
};

class ItemsReader : public PortReader {
 public:
  ItemsReader(const Call& call, std::size_t port) : items_(std::get<Items>(call.arguments[port])) {}
  void begin_run(std::size_t, std::size_t, void* target) override { *static_cast<Items*>(target) = items_; }

 private:
  const Items& items_;
};

}  // namespace

template <class T>
std::unique_ptr<PortReader> read_value(const Call& call, std::size_t port) {
  return std::make_unique<ValueReader<T>>(call, port);
}
template <class T>
std::unique_ptr<PortReader> read_optional(const Call& call, std::size_t port) {
  return std::make_unique<OptionalReader<T, ValueReader<T>>>(call, port);
}
template <class T, int K>
std::unique_ptr<PortReader> read_block(const Call& call, std::size_t port) {
  return std::make_unique<BlockReader<T, K>>(call, port);
}
template <class T, int K>
std::unique_ptr<PortReader> read_optional_block(const Call& call, std::size_t port) {
  return std::make_unique<OptionalReader<Block<T, K>, BlockReader<T, K>>>(call, port);
}
template <class T>
std::unique_ptr<PortReader> read_batch(const Call& call, std::size_t port) {
  return std::make_unique<BatchReader<T>>(call, port);
}
template <class L>
std::unique_ptr<PortReader> read_literal_of(const Call& call, std::size_t port) {
  return std::make_unique<LiteralReader<L>>(call, port);
}

std::unique_ptr<PortReader> read_items(const Call& call, std::size_t port) {
  return std::make_unique<ItemsReader>(call, port);
}

std::unique_ptr<PortReader> read_choice(const Call& call, std::size_t port, std::span<const std::string_view> words,
                                        void (*write)(void*, std::size_t)) {
  const std::string& word = std::get<std::string>(std::get<Literal>(call.arguments[port]));
  const auto found = std::find(words.begin(), words.end(), word);
  return std::make_unique<ChoiceReader>(static_cast<std::size_t>(found - words.begin()), write);
}

// Compiled here once for all nodes.
#define DINI_READERS_OF_NUMBERS(T)                                                 \
  template std::unique_ptr<PortReader> read_value<T>(const Call&, std::size_t);    \
  template std::unique_ptr<PortReader> read_optional<T>(const Call&, std::size_t); \
  template std::unique_ptr<PortReader> read_block<T, 1>(const Call&, std::size_t); \
  template std::unique_ptr<PortReader> read_block<T, 2>(const Call&, std::size_t); \
  template std::unique_ptr<PortReader> read_batch<T>(const Call&, std::size_t)
DINI_READERS_OF_NUMBERS(double);
DINI_READERS_OF_NUMBERS(Vector);
DINI_READERS_OF_NUMBERS(Point);
DINI_READERS_OF_NUMBERS(Generator);
DINI_READERS_OF_NUMBERS(Circle);
DINI_READERS_OF_NUMBERS(Sphere);
#undef DINI_READERS_OF_NUMBERS
template std::unique_ptr<PortReader> read_optional_block<double, 2>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_value<SharedMesh>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_value<SharedField>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_optional<SharedField>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_block<SharedField, 1>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_literal_of<std::int64_t>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_literal_of<bool>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_literal_of<std::string>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_literal_of<Color>(const Call&, std::size_t);
template std::unique_ptr<PortReader> read_literal_of<SharedAssetFile>(const Call&, std::size_t);

}  // namespace dini
