// SPDX-License-Identifier: MIT
#pragma once

#include "../relay/endpoint.hpp"

#include <unordered_map>

namespace transport {

/// Something for each network. Where a new one is one too many, those are forgotten that are idle, and
/// some other if none is. All are looked at once for many new ones only: datagrams from addresses that
/// nobody has must cost little.
template <typename Entry>
class NetworkTable {
public:
	using Network = std::array<uint8_t, 16>;

	static constexpr size_t MAX = 4096;

	/// The entry of a network, p_fresh if there was none. p_is_idle says whether one may be forgotten.
	template <typename IsIdle>
	Entry &find_or_add(const Network &p_network, const Entry &p_fresh, IsIdle p_is_idle) {
		const auto found = _entries.find(p_network);
		if (found != _entries.end()) {
			return found->second;
		}
		if (_entries.size() >= MAX) {
			forget(p_is_idle);
		}
		return _entries.emplace(p_network, p_fresh).first->second;
	}

	/// The entry of a network, or null.
	Entry *find(const Network &p_network) {
		const auto found = _entries.find(p_network);
		return found != _entries.end() ? &found->second : nullptr;
	}

	size_t size() const { return _entries.size(); }

private:
	template <typename IsIdle>
	void forget(IsIdle p_is_idle) {
		if (_forgotten == 0) {
			for (auto one = _entries.begin(); one != _entries.end();) {
				one = p_is_idle(one->second) ? _entries.erase(one) : std::next(one);
			}
		}
		if (_entries.size() >= MAX) {
			_entries.erase(_entries.begin());
			_forgotten = (_forgotten + 1) % LOOK_EVERY;
		}
	}

	/// New networks that make another one go, between two looks at all.
	static constexpr size_t LOOK_EVERY = MAX / 8;

	std::unordered_map<Network, Entry, NetworkHash> _entries;
	size_t _forgotten = 0;
};

} // namespace transport
