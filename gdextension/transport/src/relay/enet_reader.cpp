// SPDX-License-Identifier: MIT
#include "enet_reader.hpp"

namespace transport {

namespace {

constexpr uint8_t KIND_MASK = 0x0F;
constexpr uint16_t SENT_TIME = 0x8000;
constexpr uint16_t COMPRESSED = 0x4000;
constexpr uint16_t PEER_MASK = 0x0FFF;
constexpr uint8_t UNSEQUENCED = 0x40;
/// Bytes of each kind of command without what it carries; 0: there is no such kind.
constexpr std::array<size_t, 16> SIZES{ { 0, 8, 48, 44, 8, 4, 6, 8, 24, 8, 12, 16, 24, 0, 0, 0 } };

uint16_t big_u16(const uint8_t *p_from) {
	return uint16_t(p_from[0] << 8 | p_from[1]);
}

uint32_t big_u32(const uint8_t *p_from) {
	return uint32_t(big_u16(p_from)) << 16 | big_u16(p_from + 2);
}

} // namespace

EnetReader::EnetReader(const View &p_datagram) {
	if (p_datagram.size < 2) {
		return;
	}
	const uint16_t head = big_u16(p_datagram.data);
	const size_t size = head & SENT_TIME ? 4 : 2;
	_valid = p_datagram.size > size && !(head & COMPRESSED);
	_peer = head & PEER_MASK;
	_left = _valid ? p_datagram.from(size) : View();
}

bool EnetReader::next(EnetCommand &r_command) {
	if (!_valid || _left.size == 0) {
		return false;
	}
	const uint8_t kind = _left.data[0] & KIND_MASK;
	const size_t size = SIZES[kind];
	_valid = size > 0 && _left.size >= size;
	if (!_valid) {
		return false;
	}
	r_command = EnetCommand();
	r_command.kind = EnetCommand::Kind(kind);
	r_command.channel = _left.data[1];
	r_command.number = big_u16(_left.data + 2);
	_valid = read_body(r_command, size);
	if (_valid) {
		_left = _left.from(size + r_command.size);
	}
	return _valid;
}

bool EnetReader::read_body(EnetCommand &r_command, size_t p_size) {
	const uint8_t *at = _left.data;
	switch (r_command.kind) {
		case EnetCommand::ACKNOWLEDGE:
			r_command.number = big_u16(at + 4);
			break;
		case EnetCommand::CONNECT:
			std::memcpy(r_command.chosen.data(), at + 40, r_command.chosen.size());
			[[fallthrough]];
		case EnetCommand::VERIFY_CONNECT:
			r_command.peer = big_u16(at + 4);
			r_command.incoming_session = at[6];
			r_command.outgoing_session = at[7];
			r_command.channels = big_u32(at + 16);
			break;
		case EnetCommand::SEND_RELIABLE:
			r_command.size = big_u16(at + 4);
			break;
		case EnetCommand::SEND_UNRELIABLE:
		case EnetCommand::SEND_UNSEQUENCED:
			r_command.size = big_u16(at + 6);
			break;
		case EnetCommand::SEND_FRAGMENT:
		case EnetCommand::SEND_UNRELIABLE_FRAGMENT:
			r_command.first_number = big_u16(at + 4);
			r_command.size = big_u16(at + 6);
			r_command.fragments = big_u32(at + 8);
			r_command.fragment = big_u32(at + 12);
			r_command.whole_size = big_u32(at + 16);
			r_command.offset = big_u32(at + 20);
			break;
		default:
			break;
	}
	return _left.size >= p_size + r_command.size;
}

std::array<uint8_t, 10> make_enet_disconnect(uint16_t p_peer, uint8_t p_session) {
	const uint16_t head = uint16_t((p_peer & PEER_MASK) | (p_session & 3) << 12);
	return { { uint8_t(head >> 8), uint8_t(head), uint8_t(EnetCommand::DISCONNECT) | UNSEQUENCED, 0xFF, 0, 0, 0, 0, 0,
			0 } };
}

} // namespace transport
