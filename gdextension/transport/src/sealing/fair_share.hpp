// SPDX-License-Identifier: MIT
#pragma once

#include "network_table.hpp"

#include <algorithm>
#include <sodium.h>

namespace transport {

/// Admits about so many a second of each network. Where more come they are chosen by chance, so that
/// somebody among many gets through after a few tries, however the others time theirs.
class FairShare {
public:
	using Network = std::array<uint8_t, 16>;

	static constexpr int64_t WINDOW_USEC = 100000;

	explicit FairShare(double p_per_second) : _allowed(p_per_second * double(WINDOW_USEC) / 1e6) {}

	bool admit(const Network &p_network, int64_t p_now_usec) {
		const int64_t number = p_now_usec / WINDOW_USEC;
		const auto is_silent = [number](const Window &p_window) { return p_window.number + 1 < number; };
		Window &window = _windows.find_or_add(p_network, Window(), is_silent);
		if (number != window.number) {
			window.before = number == window.number + 1 ? window.count : 0;
			window.number = number;
			window.count = 0;
		}
		window.count++;
		const double come = double(std::max(window.count, window.before));
		return come <= _allowed || double(randombytes_random()) * come < _allowed * double(UINT32_MAX);
	}

private:
	struct Window {
		int64_t number = 0;
		uint64_t count = 0;
		uint64_t before = 0;
	};

	double _allowed;
	NetworkTable<Window> _windows;
};

} // namespace transport
