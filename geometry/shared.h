#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace dini {

/// A container that copies share until one of them is changed. Reading never copies. What changes it says so by its
/// name, or by `edit`; loops take the reference that `edit` gives once. Threads may read one at the same time, not
/// change it.
template <class Container>
class Shared {
 public:
  using Item = typename Container::value_type;

  Shared() = default;
  Shared(Container items) : items_(std::make_shared<Container>(std::move(items))) {}

  const Container& operator*() const { return items_ ? *items_ : none(); }
  operator const Container&() const { return **this; }

  std::size_t size() const { return items_ ? items_->size() : 0; }
  bool empty() const { return size() == 0; }
  decltype(auto) operator[](std::size_t index) const { return std::as_const(*items_)[index]; }
  auto begin() const { return (**this).begin(); }
  auto end() const { return (**this).end(); }
  const auto& front() const { return std::as_const(*items_).front(); }
  const auto& back() const { return std::as_const(*items_).back(); }
  const auto* data() const { return (**this).data(); }
  const double* component(std::size_t k) const { return (**this).component(k); }

  /// The container to change: a copy if it was shared.
  Container& edit() {
    if (!items_) {
      items_ = std::make_shared<Container>();
    } else if (items_.use_count() > 1) {
      items_ = std::make_shared<Container>(*items_);
    }
    return *items_;
  }

  void set(std::size_t index, const Item& item) { edit().set(index, item); }
  void push_back(const Item& item) { edit().push_back(item); }
  auto& emplace_back() { return edit().emplace_back(); }
  void reserve(std::size_t size) { edit().reserve(size); }
  template <class... Fill>
  void resize(std::size_t size, const Fill&... fill) {
    edit().resize(size, fill...);
  }
  void clear() { items_ = nullptr; }

  friend bool operator==(const Shared& a, const Shared& b) { return a.items_ == b.items_ || *a == *b; }
  template <class Other>
  friend bool operator==(const Shared& a, const Other& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  static const Container& none() {
    static const Container empty;
    return empty;
  }

  std::shared_ptr<Container> items_;
};

}  // namespace dini
