// SPDX-License-Identifier: MIT
#pragma once

#include "bytes.hpp"
#include "cpace.hpp"

namespace transport {

/// What both ends say before datagrams are sealed, and the heads of those that are. Layouts:
/// docs/protocol.md. No answer is longer than what asks for it.
namespace messages {

/// First byte. ENet's datagrams have bit 6 only if they are compressed, which nobody here does.
/// Sealed datagrams without a head of their own have bit 7, see SealedChannel.
enum Type : uint8_t {
	INIT = 0x41,
	COOKIE = 0x42,
	START = 0x43,
	REPLY = 0x44,
	NOTICE = 0x45,
	/// Sealed, with the client's number: until the server's first one has come.
	FIRST = 0x46,
	/// A server's answer to a sealed datagram from an address where it knows nobody.
	UNKNOWN = 0x48,
	/// Sealed, with the client's number: its address is another one now.
	MOVED = 0x49,
	/// Without sealing: a message beside ENet.
	OPEN_FAST = 0x4A,
	// 0x4B and 0x4C: see discovery::QUESTION and discovery::ANSWER.
};

/// What a NOTICE says.
enum class Notice : uint8_t {
	WRONG_PASSWORD = 1,
	/// Too many tries of a password are open: try again.
	LATER = 2,
	/// The server speaks another version, which the notice names.
	OTHER_VERSION = 3,
	/// The server does not seal.
	SERVER_IS_OPEN = 4,
	/// The server wants sealed connections.
	SERVER_SEALS = 5,
};

constexpr int ROLES = 3;
constexpr size_t INIT_SIZE = 64;
constexpr size_t FIRST_HEAD = 9;
constexpr size_t MOVED_HEAD = 21;

/// A client chooses it by chance; who does not know it cannot forge a notice.
using ClientId = std::array<uint8_t, 8>;
using Cookie = std::array<uint8_t, 16>;
/// Shows that whoever sends it receives what is sent to his address.
using AddressCookie = std::array<uint8_t, 12>;
/// The last bytes of a datagram: shows that whoever sends them has seen it.
using Echo = std::array<uint8_t, 4>;
/// Lets a client that was here try its password at once; zeros: none.
using ReturnTag = std::array<uint8_t, 16>;

struct Init {
	uint32_t version = 0;
	uint8_t role = 0;
	ClientId client{};

	Bytes encode() const;
	/// False if it is none of any version.
	bool decode(const View &p_bytes);
};

struct CookieReply {
	ClientId client{};
	Cookie cookie{};
	/// Whether the role needs a password.
	bool locked = false;

	Bytes encode() const;
	bool decode(const View &p_bytes);
};

struct Start {
	ClientId client{};
	Cookie cookie{};
	uint32_t version = 0;
	uint8_t role = 0;
	ReturnTag return_tag{};
	cpace::Share share{};

	Bytes encode() const;
	bool decode(const View &p_bytes);
	/// The part that the key exchange authenticates.
	Bytes associated() const;
};

struct Reply {
	ClientId client{};
	cpace::Share share{};

	Bytes encode() const;
	bool decode(const View &p_bytes);
};

struct NoticeMessage {
	ClientId client{};
	Notice what = Notice::LATER;
	uint32_t version = 0;

	Bytes encode() const;
	bool decode(const View &p_bytes);
};

struct UnknownMessage {
	Echo echo{};
	AddressCookie cookie{};

	Bytes encode() const;
	bool decode(const View &p_bytes);
};

/// Identifier of the key exchange's channel: who takes part, the initiator first.
Bytes channel_identifier();
/// Identifier of a key exchange's session.
Bytes session_identifier(const ClientId &p_client, const Cookie &p_cookie);
/// The head of a FIRST.
Bytes first_head(const ClientId &p_client);
/// The head of a MOVED.
Bytes moved_head(const ClientId &p_client, const AddressCookie &p_cookie);
/// The last bytes of a datagram that has as many.
Echo echo_of(const View &p_datagram);

} // namespace messages

} // namespace transport
