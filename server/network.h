#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dini::server {

/// An IP address; one of IPv4 is written as IPv6 does (::ffff:10.0.0.1), so that both compare.
class Address {
 public:
  /// "10.0.0.1", "::1"; nothing for what is none.
  static std::optional<Address> parse(std::string_view text);
  /// That of the peer of a socket; nothing where there is none.
  static std::optional<Address> of_peer(int descriptor);

  std::string text() const;

  /// What all addresses of one subscriber have in common: of IPv6 the first 64 bits, since everybody gets as many as
  /// the rest can tell apart; of IPv4 all of it.
  Address subscriber() const;

  auto operator<=>(const Address&) const = default;

 private:
  friend class Network;
  std::array<unsigned char, 16> bytes_{};
};

/// An address, or all that begin as it does: "10.0.0.0/8".
class Network {
 public:
  static std::optional<Network> parse(std::string_view text);

  bool contains(const Address& address) const;

 private:
  Address begin_;
  std::size_t bits_ = 128;
};

}  // namespace dini::server
