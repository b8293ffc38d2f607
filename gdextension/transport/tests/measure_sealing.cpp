// SPDX-License-Identifier: MIT
// What sealing and opening cost, for ./run bench transport: transport_measure_sealing <bytes>
// prints nanoseconds of processor time for each, and the bytes that a datagram grows by, as JSON.
#include "relay/server_relay.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>

using namespace transport;

namespace {

constexpr int ROUNDS = 15;
constexpr size_t DATAGRAMS = 4000;

double thread_nsec() {
	timespec now{};
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
	return double(now.tv_sec) * 1e9 + double(now.tv_nsec);
}

double median(std::vector<double> &r_values) {
	std::sort(r_values.begin(), r_values.end());
	return r_values[r_values.size() / 2];
}

} // namespace

int main(int p_count, char **p_arguments) {
	if (p_count != 2) {
		std::fputs("transport_measure_sealing BYTES\n", stderr);
		return 2;
	}
	const CookieJar initialised;
	Key key{};
	key.fill(7);
	SealedChannel from(key, key);
	SealedChannel to(key, key);
	const Bytes plain(std::stoul(p_arguments[1]), 1);
	std::vector<Bytes> sealed(DATAGRAMS);
	Bytes opened;
	Content content = Content::ENET;
	size_t good = 0;
	std::vector<double> seal;
	std::vector<double> open;
	for (int round = 0; round < ROUNDS; round++) {
		const double begin = thread_nsec();
		for (Bytes &datagram : sealed) {
			from.seal(Content::FAST, plain, datagram);
		}
		const double middle = thread_nsec();
		for (const Bytes &datagram : sealed) {
			good += to.open(datagram, content, opened) ? 1 : 0;
		}
		seal.push_back((middle - begin) / double(DATAGRAMS));
		open.push_back((thread_nsec() - middle) / double(DATAGRAMS));
	}
	std::printf("{\"seal_ns\": %.0f, \"open_ns\": %.0f, \"grown\": %zu}\n", median(seal), median(open),
			sealed.front().size() - plain.size());
	return good == ROUNDS * DATAGRAMS ? 0 : 1;
}
