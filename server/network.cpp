#include "server/network.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cstring>
#include <sys/socket.h>

#include "server/text.h"

namespace dini::server {
namespace {

constexpr std::array<unsigned char, 12> v4_beginning = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
constexpr std::size_t all_bits = 128, v4_bits = 32;

bool is_v4(const std::array<unsigned char, 16>& bytes) {
  return std::equal(v4_beginning.begin(), v4_beginning.end(), bytes.begin());
}

void set_v4(std::array<unsigned char, 16>& bytes, const in_addr& address) {
  std::ranges::copy(v4_beginning, bytes.begin());
  std::memcpy(bytes.data() + v4_beginning.size(), &address, sizeof address);
}

}  // namespace

std::optional<Address> Address::parse(std::string_view text) {
  const std::string terminated(text);
  Address address;
  in_addr v4{};
  if (::inet_pton(AF_INET, terminated.c_str(), &v4) == 1) {
    set_v4(address.bytes_, v4);
    return address;
  }
  if (::inet_pton(AF_INET6, terminated.c_str(), address.bytes_.data()) != 1) return std::nullopt;
  return address;
}

std::optional<Address> Address::of_peer(int descriptor) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  if (::getpeername(descriptor, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return std::nullopt;
  Address address;
  if (storage.ss_family == AF_INET) {
    sockaddr_in v4{};
    std::memcpy(&v4, &storage, sizeof v4);
    set_v4(address.bytes_, v4.sin_addr);
    return address;
  }
  if (storage.ss_family != AF_INET6) return std::nullopt;
  sockaddr_in6 v6{};
  std::memcpy(&v6, &storage, sizeof v6);
  std::memcpy(address.bytes_.data(), &v6.sin6_addr, address.bytes_.size());
  return address;
}

std::string Address::text() const {
  std::array<char, INET6_ADDRSTRLEN> text{};
  const bool v4 = is_v4(bytes_);
  const unsigned char* begin = v4 ? bytes_.data() + v4_beginning.size() : bytes_.data();
  ::inet_ntop(v4 ? AF_INET : AF_INET6, begin, text.data(), text.size());
  return text.data();
}

Address Address::subscriber() const {
  Address shared = *this;
  if (!is_v4(bytes_)) std::fill(shared.bytes_.begin() + bytes_.size() / 2, shared.bytes_.end(), 0);
  return shared;
}

std::optional<Network> Network::parse(std::string_view text) {
  const auto slash = text.find('/');
  const auto begin = Address::parse(text.substr(0, slash));
  if (!begin) return std::nullopt;
  Network network;
  network.begin_ = *begin;
  if (slash == std::string_view::npos) return network;
  const bool v4 = text.find(':') == std::string_view::npos;
  const auto bits = whole_number(text.substr(slash + 1));
  if (!bits || *bits > (v4 ? v4_bits : all_bits)) return std::nullopt;
  network.bits_ = *bits + (v4 ? all_bits - v4_bits : 0);
  return network;
}

bool Network::contains(const Address& address) const {
  const std::size_t whole = bits_ / 8, rest = bits_ % 8;
  if (!std::equal(begin_.bytes_.begin(), begin_.bytes_.begin() + static_cast<std::ptrdiff_t>(whole),
                  address.bytes_.begin())) {
    return false;
  }
  if (rest == 0) return true;
  const unsigned mask = 0xffu << (8 - rest);
  return ((begin_.bytes_[whole] ^ address.bytes_[whole]) & mask & 0xffu) == 0;
}

}  // namespace dini::server
