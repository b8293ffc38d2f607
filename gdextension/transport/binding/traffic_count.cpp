// SPDX-License-Identifier: MIT
#include "traffic_count.hpp"

namespace godot {

namespace {

/// What a server's relay counts, by the names that stats() has for it.
struct Count {
	const char *name;
	uint64_t transport::RelayCounts::*member;
};

constexpr Count COUNTS[] = {
	{ "sealed", &transport::RelayCounts::sealed },
	{ "opened", &transport::RelayCounts::opened },
	{ "not_opened", &transport::RelayCounts::not_opened },
	{ "stray", &transport::RelayCounts::stray },
	{ "from_port_zero", &transport::RelayCounts::from_port_zero },
	{ "malformed", &transport::RelayCounts::malformed },
	{ "too_few_channels", &transport::RelayCounts::too_few_channels },
	{ "bad_fragments", &transport::RelayCounts::bad_fragments },
	{ "held_too_much", &transport::RelayCounts::held_too_much },
	{ "cookies", &transport::RelayCounts::cookies },
	{ "bad_cookies", &transport::RelayCounts::bad_cookies },
	{ "handshakes", &transport::RelayCounts::handshakes },
	{ "handshakes_dropped", &transport::RelayCounts::handshakes_dropped },
	{ "handshakes_later", &transport::RelayCounts::handshakes_later },
	{ "wrong_passwords", &transport::RelayCounts::wrong_passwords },
	{ "half_open_evicted", &transport::RelayCounts::evicted },
	{ "moved", &transport::RelayCounts::moved },
	{ "questions", &transport::RelayCounts::questions },
	{ "answers", &transport::RelayCounts::answers },
};

} // namespace

Dictionary TrafficCount::describe() const {
	Dictionary made;
	made["sent_bytes"] = _sent_bytes;
	made["received_bytes"] = _received_bytes;
	made["sent_packets"] = _sent_datagrams;
	made["received_packets"] = _received_datagrams;
	return made;
}

void describe_server(const transport::ServerRelay &p_server, Dictionary &r_stats) {
	const transport::RelayCounts &counts = p_server.counts();
	r_stats["refused"] = p_server.last_refusal().number;
	for (const Count &count : COUNTS) {
		r_stats[count.name] = counts.*count.member;
	}
	r_stats["held_bytes"] = p_server.links().held();
	r_stats["half_open"] = uint64_t(p_server.links().half_open() + p_server.pending());
}

} // namespace godot
